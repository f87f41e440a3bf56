// SPDX-License-Identifier: MIT
/** A person at the controls of an aircraft: keyboard, pointer and gamepad make the numbers that are flown instead of the tree's. They are
 * said to the program at most twenty times a second, and only when they change. */
import { MathUtils } from 'three';
import { listen } from '../events.ts';
import { convergence } from '../scene/geo.ts';
import { wrapped } from '../scene/motion.ts';
import { last_at, source_of, type Player, type TrackSeen } from '../run/run.ts';
import { Cell } from '../store.ts';
import { keep, kept } from '../ui/link.ts';
import type { Live } from './live.ts';

/** What is asked for: directions true, SI. */
export interface Wanted {
  player: number;  // Index into Run.players.
  heading: number;
  altitude: number;
  speed: number;
  climb: number | null;  // rad: towards the pointer or the stick, instead of an altitude.
  load_factor: number | null;  // g, as hard as the stick is moved.
  target: number;  // As his own tracker numbers it; 0: nobody.
  gun: boolean;
  radar: boolean;
  pointer: boolean;  // Towards the pointer.
  stick: boolean;  // By stick and throttle.
}

/** ms between two orders. */
const kTick = 50;
/** ms: what is refused so soon was the taking over. */
const kTrial = 1000;
/** By a key that is held, each second. */
const kTurn = (40 * Math.PI) / 180;
const kClimb = 300;  // m
const kSpeedUp = 25;  // m/s
const kLowest = 60;  // m
const kSlowest = 60;  // m/s
const kFastest = 900;
/** Of a stick that rests. */
const kDead = 0.12;
const kAhead = 1;  // rad: from the way it flies to where a stick at its stop shows.
const kPull = 8;  // g, at its stop; the aircraft has its own limit.
const kSteepest = 1.5;  // rad

export type Act = 'shoot' | 'next' | 'gun' | 'radar' | 'dispense' | 'pointer' | 'stick' | 'hand_back' | 'help';
export const kKeys: { keys: string[]; shown: string; words: string; act?: Act }[] = [
  { keys: ['ArrowLeft', 'ArrowRight'], shown: '← →', words: 'heading' },
  { keys: ['ArrowUp', 'ArrowDown'], shown: '↑ ↓', words: 'altitude' },
  { keys: ['+', '=', '-', '_'], shown: '+ −', words: 'speed' },
  { keys: ['t'], shown: 'T', words: 'next target', act: 'next' },
  { keys: [' '], shown: 'space', words: 'shoot at the target', act: 'shoot' },
  { keys: ['g'], shown: 'G', words: 'gun, while it is held', act: 'gun' },
  { keys: ['r'], shown: 'R', words: 'radar on or silent', act: 'radar' },
  { keys: ['c'], shown: 'C', words: 'chaff and flares', act: 'dispense' },
  { keys: ['m'], shown: 'M', words: 'fly where the pointer is', act: 'pointer' },
  { keys: ['s'], shown: 'S', words: 'stick and throttle', act: 'stick' },
  { keys: ['h'], shown: 'H', words: 'hand it back to its tree', act: 'hand_back' },
  { keys: ['?'], shown: '?', words: 'this card', act: 'help' },
];
const kActs = new Map(kKeys.flatMap(({ keys, act }) => keys.map((key) => [key, act] as const)));
/** Of a standard gamepad. */
const kButtons: (Act | null)[] = ['shoot', 'dispense', 'gun', 'next', 'radar', 'stick', null, null, 'help', 'hand_back'];

const { clamp } = MathUtils;

/** A held key, or a stick that is moved, for `s` seconds. Ways are from -1 to 1: right, up, faster. */
export function steered(wanted: Wanted, [right, up, faster]: readonly [number, number, number], s: number): Wanted {
  if (!right && !up && !faster) return wanted;
  return {
    ...wanted,
    heading: wrapped(wanted.heading + right * kTurn * s),
    altitude: clamp(wanted.altitude + up * kClimb * s, kLowest, 18_000),
    speed: clamp(wanted.speed + faster * kSpeedUp * s, kSlowest, kFastest),
    // keys take over from the pointer
    ...(right || up ? { climb: null, pointer: false } : {}),
  };
}

/** As stick and throttle fly it: the way it flies is turned to where the stick shows, as hard as it is moved, and stays when it is let go. */
export function pulled(wanted: Wanted, [right, up, faster]: readonly [number, number, number], flown: { heading: number; climb: number }, s: number): Wanted {
  const speed = clamp(wanted.speed + faster * kSpeedUp * s, kSlowest, kFastest);
  const hard = Math.min(1, Math.hypot(right, up));
  if (hard) return { ...wanted, speed, heading: wrapped(flown.heading + right * kAhead), climb: clamp(flown.climb + up * kAhead, -kSteepest, kSteepest), load_factor: 1 + hard * kPull };
  return wanted.load_factor === null && wanted.climb !== null ? { ...wanted, speed } : { ...wanted, speed, ...flown, load_factor: null };
}

/** The target after this one, the nearest first and again after the last, of those known as hostile: others may not be attacked; 0: nobody. */
export function next_target(tracks: readonly TrackSeen[], from: { east: number; north: number }, now: number): number {
  const far = ({ place }: TrackSeen): number => Math.hypot(place.east - from.east, place.north - from.north);
  const ids = tracks.filter(({ identity }) => identity === 'hostile').sort((a, b) => far(a) - far(b)).map(({ id }) => id);
  return ids[ids.indexOf(now) + 1] ?? ids[0] ?? 0;
}

/** The order that says it, as src/scenario/operator_orders.hpp reads it. */
export function order_of(wanted: Wanted, once: Record<string, unknown>): Record<string, unknown> {
  const { heading, altitude, speed, climb, load_factor, target, gun, radar } = wanted;
  const short = (value: number): number => Number(value.toFixed(4));
  return {
    heading: short(heading), speed: short(speed), ...(climb === null ? { altitude: short(altitude) } : { climb: short(climb) }),
    ...(load_factor === null ? {} : { load_factor: short(load_factor) }), target, gun, radar, ...once,
  };
}

/** With shift or without: it may be let go between pressing and releasing. */
const kSameKeys = [['+', '='], ['-', '_']];
/** In the browser's memory: the card has been seen. */
const kKnown = 'eyrie-hands';

const place_now = ({ motion }: Player): { east: number; north: number } => ({ east: motion.east.at(-1)!, north: motion.north.at(-1)! });
const key_of = ({ key }: KeyboardEvent): string => (key.length === 1 ? key.toLowerCase() : key);

export class Hands {
  readonly wanted = new Cell<Wanted | null>(null);  // Null: nobody is flown.
  readonly help = new Cell(false);
  private held = new Set<string>();
  private taken = -Infinity;  // ms
  private pressed: readonly boolean[] = [];  // Buttons of the gamepad.
  private once: Record<string, unknown> = {};
  private said = '';
  private pointed: [number, number] | null = null;
  private stop = (): void => {};

  constructor(private readonly live: Live) {}

  get player(): Player | null {
    const wanted = this.wanted.get();
    return (wanted && this.live.page?.run.players[wanted.player]) ?? null;
  }

  /** Takes over who is chosen, as he flies now. */
  take(): void {
    const { page } = this.live;
    if (!page || this.wanted.get()) return;
    const { run, store } = page;
    const index = store.get().selected;
    const player = run.players[index]!;
    const { motion, gauges, end, kind } = player;
    if (end || kind !== 'aircraft' || !motion.t.length) return;
    this.live.to_present();
    this.taken = performance.now();
    store.set({ camera: 'follow' });
    this.said = '';
    this.held.clear();
    this.pressed = [];
    this.wanted.set({
      player: index, heading: this.true_way(player, motion.heading.at(-1)!), altitude: motion.up.at(-1)!, speed: gauges.speed.at(-1)!,
      climb: null, load_factor: null, target: this.tracks(index).find(({ is_target }) => is_target)?.id ?? 0, gun: false, radar: true, pointer: false, stick: false,
    });
    if (!kept(kKnown)) this.help.set(true);
    const timer = setInterval(() => this.tick(), kTick);
    const stops = [
      listen(window, { keydown: (event) => this.press(event), keyup: (event) => this.release(event) }, { capture: true }),
      listen(window, { pointermove: (event) => void (event.target instanceof Element && event.target.closest('.scene') && (this.pointed = [event.clientX, event.clientY])) }),
      listen(window, { blur: () => this.let_go() }), () => clearInterval(timer),
    ];
    this.stop = () => stops.forEach((stop) => stop());
    this.tick();
  }

  hand_back(): void {
    const name = this.player?.name;
    this.drop();
    if (name) this.live.order('hand_back', { player: name });
  }
  /** Without a word to anybody. */
  drop(): void {
    this.stop();
    this.wanted.set(null);
    this.help.set(false);
  }

  /** Who may not take over, or has lost what he flew, does so no longer. */
  refused(words: string): void {
    if (performance.now() - this.taken < kTrial || /somebody else|no longer there/.test(words)) this.drop();
  }

  act(act: Act): void {
    const wanted = this.wanted.get();
    if (!wanted) return;
    const change = (patch: Partial<Wanted>): void => this.wanted.set({ ...wanted, ...patch });
    if (act === 'hand_back') this.hand_back();
    else if (act === 'help') this.toggle_help();
    else if (act === 'shoot') this.once = { ...this.once, shoot: true };
    else if (act === 'dispense') this.once = { ...this.once, dispense: 'both' };
    else if (act === 'radar') change({ radar: !wanted.radar });
    else if (act === 'gun') change({ gun: !wanted.gun });
    else if (act === 'pointer' || act === 'stick') {
      const level = { climb: null, load_factor: null, altitude: this.player!.motion.up.at(-1)! };
      change({ ...level, pointer: act === 'pointer' && !wanted.pointer, stick: act === 'stick' && !wanted.stick });
    }
    else if (act === 'next') {
      const target = next_target(this.tracks(wanted.player), place_now(this.player!), wanted.target);
      if (!target) this.live.say('no track is known as hostile yet');
      change({ target });
    }
  }
  toggle_help(): void {
    this.help.set(!this.help.get());
    if (!this.help.get()) keep(kKnown, '1');
  }
  tracks(player: number): TrackSeen[] {
    const { sights } = this.live.page!.run.players[player]!;
    return sights.t.length ? sights.at(sights.t.length - 1).tracks : [];
  }

  private press(event: KeyboardEvent): void {
    const key = key_of(event);
    if (!kActs.has(key) || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target instanceof Element && event.target.matches('input:not([type=checkbox]), select, textarea')) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.repeat) return;
    this.held.add(key);
    const act = kActs.get(key);
    if (act === 'gun') this.wanted.set({ ...this.wanted.get()!, gun: true });
    else if (act) this.act(act);
    else this.tick();
  }
  private release(event: KeyboardEvent): void {
    const key = key_of(event);
    for (const one of kSameKeys.find((keys) => keys.includes(key)) ?? [key]) this.held.delete(one);
    if (key === 'g') this.cease();
  }
  /** Of all keys: they are let go unseen. */
  private let_go(): void {
    this.held.clear();
    this.cease();
  }
  private cease(): void {
    const wanted = this.wanted.get();
    if (wanted?.gun) this.wanted.set({ ...wanted, gun: false });
  }

  private ways(): readonly [number, number, number] {
    const held = (...keys: string[]): number => (keys.some((key) => this.held.has(key)) ? 1 : 0);
    const pad = navigator.getGamepads?.().find((one) => one) ?? null;
    const axis = (value = 0): number => (Math.abs(value) < kDead ? 0 : value);
    if (pad) this.buttons(pad.buttons.map(({ pressed }) => pressed));
    return [
      held('ArrowRight') - held('ArrowLeft') + axis(pad?.axes[0]),
      held('ArrowUp') - held('ArrowDown') + axis(pad?.axes[1]),  // pulled is up
      held('+', '=') - held('-', '_') + (pad?.buttons[7]?.value ?? 0) - (pad?.buttons[6]?.value ?? 0),
    ];
  }
  private buttons(pressed: readonly boolean[]): void {
    kButtons.forEach((act, i) => {
      const [now, before] = [pressed[i] ?? false, this.pressed[i] ?? false];
      if (act && (act === 'gun' ? now !== before : now && !before)) this.act(act);
    });
    this.pressed = pressed;
  }

  private tick(): void {
    const ways = this.ways();
    let wanted = this.wanted.get();
    const { player } = this;
    if (!wanted || !player) return;
    if (player.end) return this.drop();
    wanted = wanted.stick ? pulled(wanted, ways, this.flown(player), kTick / 1000) : this.to_pointer(steered(wanted, ways, kTick / 1000));
    this.wanted.set(wanted);
    const order = order_of(wanted, this.once);
    const text = JSON.stringify(order);
    if (text === this.said) return;
    this.said = JSON.stringify(order_of(wanted, {}));
    this.once = {};
    this.live.order('manual', { player: player.name, ...order });
  }
  /** From the map's north there where he is to true north. */
  private true_way(player: Player, heading: number): number {
    return wrapped(heading + convergence(this.live.page!.run.origin, place_now(player)));
  }
  /** Which way he flies, true. */
  private flown(player: Player): { heading: number; climb: number } {
    const { motion } = player;
    const now = motion.t.at(-1)!;
    const before = motion.t.findLastIndex((t) => t < now - kTick / 1000);
    const [east, north, up] = [motion.east, motion.north, motion.up].map((all) => all.at(-1)! - all.at(before)!) as [number, number, number];
    const heading = before < 0 ? motion.heading.at(-1)! : Math.atan2(east, north);
    return { heading: this.true_way(player, heading), climb: before < 0 ? 0 : Math.atan2(up, Math.hypot(east, north)) };
  }
  /** Where the pointer shows: to its side of the aircraft, above it or below. */
  private to_pointer(wanted: Wanted): Wanted {
    const way = wanted.pointer && this.pointed && this.live.scene?.way_to(wanted.player, ...this.pointed);
    if (!way) return wanted;
    const player = this.player!;
    return { ...wanted, heading: this.true_way(player, way.heading), climb: clamp(way.climb, -0.8, 0.8), altitude: player.motion.up.at(-1)! };
  }
}

/** What his tree proposes now, by field. */
export function proposed(live: Live): Map<string, { value: number; by: string }> {
  const found = new Map<string, { value: number; by: string }>();
  const { player } = live.hands;
  if (!player || !live.page) return found;
  const { run } = live.page;
  const { decisions } = run.players[player.index]!;
  const at = last_at(decisions.t, live.flown);
  const shape = run.shapes[decisions.shape[at]!];
  if (!shape) return found;
  const tree = run.trees[shape.tree]!;
  run.platforms[player.kind].action.forEach(({ name }, field) => {
    const node = shape.supplier[0]?.[field] ?? -1;
    if (node >= 0) found.set(name, { value: decisions.value(source_of(shape, 0, field), field)?.[at] ?? NaN, by: tree.nodes[node]!.label });
  });
  return found;
}
