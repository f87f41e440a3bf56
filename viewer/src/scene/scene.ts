// SPDX-License-Identifier: MIT
/** The air picture: mounts into a host, follows the store, draws when something changed. */
import type { Place, Player, Run } from '../run/run.ts';
import type { Cell, Store } from '../store.ts';
import { listen } from '../events.ts';
import { measure } from '../ui/actions.ts';
import { rem_size } from '../ui/canvas.ts';
import { draw_tracks, draw_zone, eyesight } from './beliefs.ts';
import { draw_bullseye, draw_ghost, draw_names, draw_rings, draw_ruler, ghost_points } from './callouts.ts';
import { SceneCamera } from './camera.ts';
import { Eye } from './eye.ts';
import type { Frame } from './frame.ts';
import { watch_hand, type Hand } from './gestures.ts';
import { draw_hud, told } from './hud.ts';
import { Poses } from './motion.ts';
import { Notes } from './notes.ts';
import { draw_other, type Other, poses_of } from './other.ts';
import { FlatPainter } from './flat/painter.ts';
import { painter_for, type Painter } from './painter.ts';
import { css, palette_of } from './palette.ts';
import { draw_radar, type Volume } from './radar.ts';
import { Meter, kRest, Sharpness } from './pace.ts';
import { SvgPen, with_svg_paths } from './svg.ts';
import { draw_routes, draw_drop_lines, draw_trails } from './trails.ts';
import { draw_gone, draw_missiles } from './weapons.ts';

/** What of the view is seen here. */
const kSeen = ['time', 'selected', 'camera', 'pose', 'ruler', 'ghost', 'layers', 'theme', 'trail', 'units', 'end'] as const;
const kSharpest = 2;
/** px around an aircraft that still mean it. */
const kGrasp = 22;
const kToldEvery = 1000;
/** px of one rem on a small screen. */
const kRem = 12.2;
/** px that an arrow key stands for. */
const kKeyStep = 24;

/** Fills `host`, whose size it follows. */
export class AirPicture {
  private readonly camera: SceneCamera;
  private readonly painter: Painter;
  private readonly frame: Frame;
  private readonly meter = new Meter();
  private readonly sharpness = new Sharpness();
  private asked = 0;
  private drawn_at = 0;
  private told_at = -Infinity;
  private teller = 0;
  private rester = 0;
  private filmed: (() => void) | null = null;
  /** Who wants to know the place on the ground that is clicked next; null: nobody. */
  point: ((place: Place) => void) | null = null;
  private readonly stops: (() => void)[] = [];

  constructor(private readonly host: HTMLElement, private readonly run: Run, readonly store: Store, private readonly other: Cell<Other | null>) {
    const palette = palette_of(store.get().theme);
    const eye = new Eye();
    const painter = (this.painter = painter_for(run, eye));
    this.camera = new SceneCamera(globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false);
    this.frame = {
      run, other: other.get(), view: store.get(), players: new Poses(run.players), missiles: new Poses(run.missiles), sight: null, eye,
      lines: painter.lines, puffs: painter.puffs, notes: new Notes(eye, palette, painter.flat), palette, hovered: -1,
    };
    const over = this.frame.notes.canvas;
    over.style.cssText = `${painter.canvas.style.cssText};touch-action:none`;
    host.setAttribute('role', 'application');
    host.tabIndex = 0;
    host.append(painter.canvas, over);
    this.watch();
    this.resize();
  }

  private watch(): void {
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(this.host);
    this.painter.canvas.addEventListener('webglcontextrestored', () => this.wake());
    this.stops.push(
      () => observer.disconnect(), this.other.subscribe((now) => {
        this.frame.other = now;
        this.wake();
      }), this.store.subscribe((now, before) => {
        this.frame.view = now;
        if (kSeen.some((key) => now[key] !== before[key])) this.wake();
      }),
      watch_hand(this.frame.notes.canvas, this.hand()), listen(this.host, { keydown: (event) => this.press(event) }),
      this.print_too());
  }

  /** On paper is a copy in light colors: a graphics card keeps nothing to be printed. */
  private print_too(): () => void {
    const { frame, host } = this;
    const paper = document.createElement('canvas');
    paper.style.cssText = this.painter.canvas.style.cssText;
    return listen(window, {
      beforeprint: () => {
        frame.view = { ...frame.view, theme: 'light' };
        host.append(this.picture(paper));
      },
      afterprint: () => {
        paper.remove();
        frame.view = this.store.get();
        this.wake();
      },
    });
  }

  private wake(): void {
    if (this.asked) return;
    this.meter.ask(performance.now());
    this.asked = requestAnimationFrame((now) => {
      this.asked = 0;
      this.draw(now);
    });
  }

  /** Whether no other picture is to come by itself, and this one has all its pixels. */
  is_still(): boolean {
    return !this.asked && this.sharpness.scale === 1;
  }

  private resize(): void {
    const { host, frame } = this;
    const width = Math.max(1, host.clientWidth);
    const height = Math.max(1, host.clientHeight);
    const ratio = Math.min(kSharpest, globalThis.devicePixelRatio || 1);
    frame.eye.resize(width, height, Math.max(1, rem_size() / kRem));
    frame.notes.resize(ratio);
    const { offsetLeft = 0, offsetTop = 0, offsetWidth = 0, offsetHeight = 0 } = (host.nextElementSibling ?? {}) as Partial<HTMLElement>;
    frame.notes.covered = [offsetLeft, offsetTop, offsetWidth, offsetHeight];
    this.sharpen();
    // a resized canvas is empty until it is drawn, so not in the next frame but now
    this.draw(performance.now());
  }

  /** The writing keeps all its pixels. */
  private sharpen(): void {
    const ratio = Math.min(kSharpest, globalThis.devicePixelRatio || 1) * this.sharpness.scale;
    this.painter.resize(this.frame.eye.width, this.frame.eye.height, ratio);
  }

  private rest(): void {
    if (this.asked || !this.sharpness.rest()) return;
    this.sharpen();
    this.draw(performance.now());
  }

  private draw(now: number): void {
    const { frame, camera } = this;
    const { view, players, missiles, eye } = frame;
    frame.palette = frame.notes.palette = palette_of(view.theme);
    this.host.style.backgroundColor = css(frame.palette.sky);
    players.update(view.time);
    missiles.update(view.time);
    const selected = this.run.players[view.selected];
    frame.sight = selected && players.shown[view.selected] ? eyesight(selected, view.time) : null;
    camera.aim(view, players, eye, this.opponent(), [...(poses_of(frame)?.players.spots() ?? []), ...ghost_points(frame)]);
    const moving = camera.rig.step(Math.min(0.1, Math.max(0.001, (now - this.drawn_at) / 1000)));
    this.drawn_at = now;
    eye.look(camera.rig.stance());

    this.painter.draw(frame, this.fill(frame));
    this.filmed?.();
    const interval = this.meter.drawn(now, performance.now());
    if (this.sharpness.judge(interval, frame.notes.canvas.width * frame.notes.canvas.height)) this.sharpen();
    this.tell(now);
    clearTimeout(this.rester);
    this.rester = window.setTimeout(() => this.rest(), kRest);
    const pose = moving ? null : camera.rested(view);
    if (moving) this.wake();
    else if (pose) this.store.set({ pose });
  }

  /** Of the selected player: its target, or else who of the other side is nearest; -1: nobody. */
  private opponent(): number {
    const { view, players, sight } = this.frame;
    const own = view.selected;
    const target = sight?.now.tracks.find((track) => track.is_target)?.truth ?? -1;
    if (players.shown[target]) return target;
    const side = this.run.players[own]?.side;
    const far = ({ index, side: its }: Player): number =>
      (its === side || its === 'none' || !players.shown[index] ? Infinity : Math.hypot(players.x[index]! - players.x[own]!, players.z[index]! - players.z[own]!));
    const nearest = this.run.players.reduce<[number, number]>((best, one) => (far(one) < best[1] ? [one.index, far(one)] : best), [-1, Infinity]);
    return nearest[0];
  }

  /** What is seen, with all that is written in it. */
  picture(canvas = document.createElement('canvas')): HTMLCanvasElement {
    const over = this.frame.notes.canvas;
    // drawn at once, as a graphics card keeps nothing
    if (!this.filmed) this.draw(performance.now());
    if (canvas.width !== over.width || canvas.height !== over.height) [canvas.width, canvas.height] = [over.width, over.height];
    const pen = canvas.getContext('2d')!;
    pen.drawImage(this.painter.canvas, 0, 0, over.width, over.height);
    pen.drawImage(over, 0, 0);
    return canvas;
  }

  /** A canvas that shows every picture from now on, until `stop`. */
  film(): { canvas: HTMLCanvasElement; stop: () => void } {
    const canvas = this.picture();
    this.filmed = () => void this.picture(canvas);
    return { canvas, stop: () => (this.filmed = null) };
  }

  svg(): string {
    const { frame } = this;
    const { notes, eye } = frame;
    const [pen, over] = [new SvgPen(), new SvgPen()];
    const painter = new FlatPainter(document.createElement('canvas'), pen as unknown as CanvasRenderingContext2D, this.run);
    with_svg_paths(() => {
      const real = notes.context;
      const flat: Frame = { ...frame, lines: painter.lines, puffs: painter.puffs };
      // marks are drawn at once, and over the picture
      notes.context = over as unknown as CanvasRenderingContext2D;
      painter.draw(flat, this.fill(flat));
      notes.context = real;
      pen.append(over);
    });
    return pen.text(eye.width, eye.height);
  }

  /** Lines, puffs and marks of all layers; what is left is what the radar sweeps. */
  private fill(frame: Frame): Volume | null {
    frame.notes.begin();
    draw_hud(frame);
    draw_trails(frame);
    draw_drop_lines(frame);
    draw_rings(frame);
    draw_bullseye(frame);
    const volume = draw_radar(frame);
    draw_routes(frame);
    draw_missiles(frame);
    draw_gone(frame);
    draw_zone(frame);
    draw_tracks(frame);
    draw_ruler(frame);
    draw_other(frame);
    draw_ghost(frame);
    draw_names(frame);
    frame.notes.end();
    return volume;
  }

  /** Not more often than can be read, but the last word is always said. */
  private tell(now: number): void {
    clearTimeout(this.teller);
    const say = (): void => {
      this.told_at = performance.now();
      const { view, players, missiles } = this.frame;
      const text = told(this.run, view, players, missiles);
      if (this.host.getAttribute('aria-label') !== text) this.host.setAttribute('aria-label', text);
    };
    if (now - this.told_at > kToldEvery) say();
    else this.teller = window.setTimeout(say, kToldEvery);
  }

  /** Who is at a pixel; -1: nobody. */
  private pick(px: number, py: number): number {
    const { players, eye } = this.frame;
    let best = -1;
    let nearest = kGrasp * eye.ui;
    for (let i = 0; i < players.count; ++i) {
      if (!players.shown[i] || !eye.project(players.x[i]!, players.y[i]!, players.z[i]!)) continue;
      const off = Math.hypot(eye.px - px, eye.py - py);
      if (off < nearest) {
        nearest = off;
        best = i;
      }
    }
    return best;
  }

  /** rad: where a place of the window lies for a player: on the map, and above him. */
  way_to(player: number, x: number, y: number): { heading: number; climb: number } {
    const { left, top } = this.host.getBoundingClientRect();
    const { players, eye } = this.frame;
    return eye.way(x - left, y - top, players.x[player]!, players.y[player]!, players.z[player]!);
  }

  private hand(): Hand {
    const { frame, camera, store } = this;
    const freed = (was_whole: boolean): void => {
      if (was_whole) store.set({ camera: 'free' });
      else this.wake();
    };
    return {
      drag: (dx, dy) => freed(camera.drag(dx, dy, frame.view, frame.eye)),
      push: (dx, dy) => freed(camera.push(dx, dy, frame.view, frame.eye)),
      zoom: (factor, px, py) => freed(camera.zoom(factor, px, py, frame.view, frame.eye)),
      click: (px, py, shift) => {
        if (this.point && frame.eye.hit(px, py)) return this.point({ east: frame.eye.ground_x * 1000, north: -frame.eye.ground_z * 1000, up: 0 });
        const who = this.pick(px, py);
        if (who >= 0) shift ? measure(this, who) : store.set({ selected: who });
      },
      hover: (px, py) => {
        const who = px === null ? -1 : this.pick(px, py);
        if (who === frame.hovered) return;
        frame.hovered = who;
        frame.notes.canvas.style.cursor = who < 0 ? '' : 'pointer';
        this.wake();
      },
    };
  }

  /** Who has no pointer turns with the arrows, pushes with shift and an arrow, and zooms with plus and minus. */
  private press(event: KeyboardEvent): void {
    const { width, height } = this.frame.eye;
    const hand = this.hand();
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const factor = { '+': 0.8, '=': 0.8, '-': 1.25 }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (way) hand[event.shiftKey ? 'push' : 'drag'](way[0]! * kKeyStep, way[1]! * kKeyStep);
    else if (factor) hand.zoom(factor, width / 2, height / 2);
    else return;
    event.preventDefault();
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    clearTimeout(this.teller);
    clearTimeout(this.rester);
    for (const stop of this.stops) stop();
    this.painter.dispose();
    this.painter.canvas.remove();
    this.frame.notes.canvas.remove();
  }
}
