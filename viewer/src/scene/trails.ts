// SPDX-License-Identifier: MIT
/** Where everybody came from, and how high they are: trails, drop lines and the selected player's staff of
 * altitudes; and where the selected flight was told to go. */
import type { Motion } from '../run/run.ts';
import type { View } from '../store.ts';
import { spoken } from '../words/text.ts';
import { kSideMark, near_km, x_of, y_of, z_of, type Frame } from './frame.ts';
import { place_at } from './motion.ts';
import type { Pens } from './painter.ts';

/** Legs of a way at most. */
const kMostLegs = 800;
/** Steps of the staff. */
const kTallest = 10;
const at = { east: 0, north: 0, up: 0 };

/** A way from `first` to `last` (s) in legs that end at whole multiples of `leg` s. `alpha_of` gives the opacity at a time, and
 * may choose the pen; a leg that ends at a time for which `gap` holds is left out. */
export function draw_legs(
  lines: Pens, motion: Motion, [first, last]: [number, number], leg: number,
  alpha_of: (t: number) => number, gap = (_: number): boolean => false,
): void {
  let [x, y, z, pale] = [NaN, 0, 0, 0];
  for (let t = first; last > first;) {
    if (!place_at(motion, t, at)) return;
    const alpha = alpha_of(t);
    if (!Number.isNaN(x) && !gap(t)) lines.add(x, y, z, x_of(at), y_of(at), z_of(at), pale, alpha);
    [x, y, z, pale] = [x_of(at), y_of(at), z_of(at), alpha];
    if (t >= last) return;
    t = Math.min(last, (Math.floor(t / leg + 1e-6) + 1) * leg);
  }
}

/** s: how much of each way is drawn; in the end all of it. */
export function trail_of({ trail, time, end }: View): number {
  return time >= end - 0.05 ? Infinity : trail;
}

/** A way, paler with its age; of a broken one a second is drawn and a second left out. */
export function draw_way({ view, players, lines }: Frame, motion: Motion, first: number, last: number, broken = false): void {
  const leg = Math.max(players.count <= 24 ? 0.5 : players.count <= 80 ? 2 : 5, Math.ceil((last - first) / kMostLegs));
  const dash = Math.max(1, leg);
  const trail = trail_of(view);
  draw_legs(lines, motion, [first, last], leg, (t) => (trail === Infinity ? 0.6 : 0.8 * (1 - (view.time - t) / trail)),
    (t) => broken && Math.floor((t - 1e-6) / dash) % 2 === 1);
}

/** Where everybody was. */
export function draw_trails(frame: Frame): void {
  const { run, view, lines, palette } = frame;
  if (!view.layers.trails) return;
  for (const player of run.players) {
    lines.pen(palette.side[player.side], player.index === view.selected ? 2.6 : 1.8);
    draw_way(frame, player.motion, Math.max(player.born, view.time - trail_of(view)), Math.min(view.time, player.gone));
  }
}

export function draw_drop_lines(frame: Frame): void {
  const { run, view, players, lines, palette, eye } = frame;
  if (!view.layers.drop_lines) return;
  for (let i = 0; i < players.count; ++i) {
    const y = players.y[i]!;
    if (!players.shown[i] || y < 0.05) continue;
    const x = players.x[i]!;
    const z = players.z[i]!;
    const chosen = i === view.selected;
    const arm = 4 * eye.ui * eye.km_per_px(x, 0, z);
    lines.pen(palette.side[run.players[i]!.side], chosen ? 1.5 : 1);
    lines.add(x, y, z, x, 0, z, chosen ? 0.9 : 0.5);
    lines.add(x - arm, 0, z, x + arm, 0, z, 0.9);
    lines.add(x, 0, z - arm, x, 0, z + arm, 0.9);
    if (chosen) draw_staff(frame, x, y, z);
  }
}

/** Ticks each five thousand feet on the line under the selected player, with figures as far as there is room. */
function draw_staff({ lines, palette, eye, notes, view, run }: Frame, x: number, y: number, z: number): void {
  const { stance } = eye;
  const km_per_px = eye.km_per_px(x, y / 2, z);
  // 5000 ft, or 2 km
  const thousands = near_km() < 0.0005 ? 5 : 2;
  const step = thousands * 1000 * near_km();
  const tall = (Math.sin(stance.polar) * step) / km_per_px;
  if (tall < 3) return;
  const figures = [1, 2, 4].find((every) => every * tall > 15 * eye.ui);
  const [rx, rz] = [Math.cos(stance.azimuth), Math.sin(stance.azimuth)];
  const top = Math.min(kTallest, Math.max(2, Math.ceil(y / (2 * step)) * 2));
  lines.pen(palette.faint, 1);
  lines.add(x, y, z, x, top * step, z, 0.5);
  for (let k = 0; k <= top; ++k) {
    const arm = (k % 2 ? 3 : 6) * eye.ui * km_per_px;
    lines.add(x, k * step, z, x - rx * arm, k * step, z - rz * arm, 0.95);
    if (figures === undefined || k % figures || !eye.project(x, k * step, z) || !eye.on_screen()) continue;
    notes.write(k === 0 ? `0 ${spoken().near[0]}` : `${k * thousands}k`, eye.px - 8 * eye.ui, eye.py, palette.faint, 'right');
  }
  const side = run.players[view.selected]!.side;
  if (eye.project(x, 0, z)) notes.mark(kSideMark[side], eye.px, eye.py, 3, palette.side[side], 1.3);
}

export function draw_routes(frame: Frame): void {
  const { run, view, lines, palette, eye, notes } = frame;
  const flight = run.flights[run.players[view.selected]?.flight ?? -1];
  if (!view.layers.routes || !flight) return;
  const tint = palette.side[flight.side];
  const stops = flight.home ? [...flight.route, flight.home] : flight.route;
  stops.forEach((stop, i) => {
    const [x, y, z] = [x_of(stop), y_of(stop), z_of(stop)];
    const next = stops[i + 1];
    const home = stop === flight.home;
    lines.pen(tint, 1.2, 10);
    if (next) lines.add(x, y, z, x_of(next), y_of(next), z_of(next), next === flight.home ? 0.35 : 0.65);
    lines.pen(tint, 1, 4);
    if (!home && y > 0.1) lines.add(x, y, z, x, 0, z, 0.35);
    if (!eye.project(x, y, z) || !eye.on_screen(20)) return;
    const r = 8 * eye.ui;
    notes.mark(home ? 'triangle' : 'circle', eye.px, eye.py, 8, palette.chip, 1, true, 0.8);
    notes.mark(home ? 'triangle' : 'circle', eye.px, eye.py, 8, tint, 1.2);
    notes.reserve(eye.px - r, eye.py - r, 2 * r, 2 * r);
    if (home) notes.tag(-40, eye.px, eye.py, `${flight.name} home`, '', tint, null, 40);
    else notes.figure(String(i + 1), eye.px, eye.py, tint);
  });
  draw_formation(frame, flight.members);
}

/** From the first of the flight who is alive to the others. */
function draw_formation({ players, lines, palette, run }: Frame, members: number[]): void {
  const lead = members.find((i) => players.shown[i]);
  if (lead === undefined) return;
  lines.pen(palette.side[run.players[lead]!.side], 1);
  for (const i of members)
    if (i !== lead && players.shown[i])
      lines.add(players.x[lead]!, players.y[lead]!, players.z[lead]!, players.x[i]!, players.y[i]!, players.z[i]!, 0.45);
}
