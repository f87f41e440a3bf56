// SPDX-License-Identifier: MIT
/** What belongs to the picture and not to a place in it: figures along the grid, the scale, and north; and all of it in words, for those
 * who do not see it. */
import { clock_text, heading_text, spoken } from '../words/text.ts';
import { type Frame, far_km, height_words, near_km } from './frame.ts';
import { type Grid, grid_of, round_down, round_up } from './grid.ts';
import { fill, stroke } from './palette.ts';
import type { Run } from '../run/run.ts';
import type { View } from '../store.ts';
import { convergence } from './geo.ts';
import type { Poses } from './motion.ts';

const kMargin = 14;
/** Lines that are looked at along an edge. */
const kMost = 60;
/** Cells of the grid away from its middle that figures are still given for. */
const kFar = 45;
/** One in so many lines of the grid may have a figure, if that makes steps of 1, 2 or 5. */
const kEvery = [1, 2, 4, 5, 10, 20, 25, 50];
/** Of the edge that could have figures: so much is enough for the finer steps. */
const kEnough = 0.6;

function figure(value: number, plus: string, minus: string): string {
  const size = Math.abs(value);
  const digits = Number.isInteger(size) ? size.toFixed(0) : size.toFixed(1);
  return value === 0 ? '0' : `${digits} ${value > 0 ? plus : minus}`;
}

/**
 * Figures where the grid's lines meet the line on screen from (ax, ay) to (bx, by): far lengths from the origin. Of both families of
 * lines the one that crosses it more often is named.
 */
function draw_edge({ eye, notes, palette }: Frame, ax: number, ay: number, bx: number, by: number, { step, x, z }: Grid): void {
  const km = step * far_km();
  if (!eye.hit(ax, ay)) return;
  const [ex, ez] = [eye.ground_x, eye.ground_z];
  // the other end may be in the sky, or so far away that nobody asks
  let end = 1;
  const is_far = (): boolean => Math.hypot(eye.ground_x - x, eye.ground_z - z) > kFar * km;
  while (end > 0 && (!eye.hit(ax + (bx - ax) * end, ay + (by - ay) * end) || is_far())) end -= 0.05;
  if (end <= 0) return;
  const [fx, fz] = [eye.ground_x, eye.ground_z];
  const eastward = Math.abs(fx - ex) > Math.abs(fz - ez);
  const [from, to] = eastward ? [ex, fx] : [-ez, -fz];
  const way = Math.sign(to - from);
  const lines: { k: number; px: number; py: number }[] = [];
  for (let k = Math.ceil((way * from) / km); k <= Math.floor((way * to) / km) && lines.length < kMost; ++k) {
    const share = (way * k * km - from) / (to - from);
    if (eye.project(ex + (fx - ex) * share, 0, ez + (fz - ez) * share) && eye.on_screen(-10)) lines.push({ k, px: eye.px, py: eye.py });
  }
  const between = (a: number, b: number): number => Math.hypot(lines[a]!.px - lines[b]!.px, lines[a]!.py - lines[b]!.py);
  const apart = (ax === bx ? 30 : 62) * eye.ui;
  // of one in so many lines those that stand apart, from the near end on; the finest that says enough
  const choices = kEvery.filter((every) => Math.abs(round_up(every * step) / (every * step) - 1) < 1e-6).map((every) => {
    const all = [...lines.keys()].filter((i) => lines[i]!.k % every === 0);
    const crowded = all.findIndex((line, i) => i > 0 && between(line, all[i - 1]!) < apart);
    return crowded < 0 ? all : all.slice(0, crowded);
  });
  const reach = (all: number[]): number => (all.length ? between(all.at(-1)!, 0) : 0);
  const enough = kEnough * Math.max(...choices.map(reach));
  for (const line of choices.find((all) => reach(all) >= enough) ?? []) {
    const { k, px, py } = lines[line]!;
    const value = Math.round(way * k * step * 10) / 10;
    notes.write(eastward ? figure(value, 'E', 'W') : figure(value, 'N', 'S'), px, py, palette.faint);
  }
}

/** True in the middle of the picture. */
function draw_scale({ eye, notes, palette, view, run }: Frame): void {
  const { ui, stance } = eye;
  const c = notes.context;
  const small = stance.height < 4;
  const unit = small ? near_km() : far_km();
  const wanted = stance.height / 4 / unit;
  const size = Math.max(small ? 10 : 0.5, round_down(wanted));
  const length = (size * unit) / eye.km_per_px(stance.x, stance.y, stance.z);
  const right = eye.width - kMargin * ui;
  const y = eye.height - (kMargin + 22) * ui;
  c.beginPath();
  c.moveTo(right - length, y - 4 * ui);
  c.lineTo(right - length, y);
  c.lineTo(right, y);
  c.lineTo(right, y - 4 * ui);
  stroke(c, palette.text, 1.4 * ui, 0.9);
  const where = view.camera === 'follow' ? ` at ${run.players[view.selected]!.name}` : '';
  notes.write(`${size} ${small ? spoken().near[0] : spoken().far[0]}${where}`, right, y - 11 * ui, palette.text, 'right');
}

function draw_north({ eye, notes, palette }: Frame): void {
  const { ui, stance } = eye;
  const c = notes.context;
  const r = 17 * ui;
  const [x, y] = [eye.width - kMargin * ui - r, kMargin * 1.7 * ui + r];
  // north as it lies on the ground seen from here
  const squash = Math.max(0.35, Math.cos(stance.polar));
  const way = (angle: number, reach: number): [number, number] =>
    [x + r * reach * Math.sin(angle), y - r * reach * Math.cos(angle) * squash];
  const north = -stance.azimuth;
  c.beginPath();
  c.ellipse(x, y, r, r * squash, 0, 0, 2 * Math.PI);
  fill(c, palette.chip, 0.6);
  stroke(c, palette.faint, ui, 0.8);
  for (const half of [1, -1]) {
    c.beginPath();
    c.moveTo(...way(north, 0.92));
    c.lineTo(...way(north + half * 2.6, 0.6));
    c.lineTo(...way(north + Math.PI, 0.25));
    c.closePath();
    fill(c, half > 0 ? palette.text : palette.faint);
  }
  const [nx, ny] = way(north, 1.45);
  notes.figure('N', nx, ny, palette.text);
  notes.reserve(x - r * 1.6, y - r * 1.6, r * 3.2, r * 3.2);
}

export function draw_hud(frame: Frame): void {
  const { eye } = frame;
  const grid = grid_of(eye);
  const low = eye.height - kMargin * eye.ui * 0.8;
  const left = 24 * eye.ui;
  draw_scale(frame);
  draw_edge(frame, left, low, eye.width - 24 * eye.ui, low, grid);
  draw_edge(frame, left, low - 26 * eye.ui, left, 48 * eye.ui, grid);
  draw_north(frame);
}

const kCamera: Record<View['camera'], string> = {
  free: 'seen from a free camera', follow: 'seen from behind the selected player', top: 'seen from above', whole: 'seen as a whole',
};

/** rad: of a player who is there now. */
export function true_heading(run: Run, players: Poses, i: number): number {
  return players.heading[i]! + convergence(run.origin, { east: players.x[i]! * 1000, north: -players.z[i]! * 1000 });
}

export function told(run: Run, view: View, players: Poses, missiles: Poses): string {
  const alive = { blue: 0, red: 0, none: 0 };
  for (const player of run.players) alive[player.side] += players.shown[player.index]!;
  const flying = missiles.shown.reduce((sum, shown) => sum + shown, 0);
  const sides = (['blue', 'red', 'none'] as const).filter((side) => run.players.some((p) => p.side === side))
    .map((side) => `${alive[side]} ${side === 'none' ? 'neutral' : side}`);
  const words = [`Air picture at ${clock_text(view.time)}, ${kCamera[view.camera]}: ${sides.join(', ')}, ${flying} missiles in flight.`];
  const chosen = run.players[view.selected];
  if (chosen) {
    const i = chosen.index;
    const there = `${chosen.name}, ${chosen.type}, heading ${heading_text(true_heading(run, players, i))} at ${height_words(players.y[i]!)}.`;
    words.push(players.shown[i] ? `Selected: ${there}` : `Selected: ${chosen.name}, not in the air picture.`);
  }
  return words.join(' ');
}
