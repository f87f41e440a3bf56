// SPDX-License-Identifier: MIT
/** What was asked of the picture: who is who; how far it is, by rings, the bullseye, which is the scenario's reference, and a ruler; and
 * where another decision led. */
import type { Vector3 } from 'three';
import { made } from '../made.ts';
import type { Player, Run } from '../run/run.ts';
import type { Ghost } from '../store.ts';
import { heading_text, quantity_text } from '../words/text.ts';
import { type Frame, climb_words, far_km, height_words, kCrowd, kSideMark, near_km, range_words, x_of, y_of, z_of } from './frame.ts';
import { convergence, measure } from './geo.ts';
import { type GhostPoint, ghost_path } from './ghost.ts';
import { gauge_at, place_at, spot_of } from './motion.ts';
import { true_heading } from './hud.ts';
import { round_up } from './grid.ts';

/** Of those in a crowd who do not matter to the selected player, so many have labels. */
const kOthers = 12;
const kGhostSpan = 30;
/** km: the bracket around the selected is never smaller than half of an aircraft. */
const kHalfSpan = 0.0085;

function rest_of(player: Player, frame: Frame): string {
  const { players, view } = frame;
  const i = player.index;
  if (player.kind === 'vehicle') return '';
  if (i !== view.selected) return `${(players.y[i]! / near_km() / 1000).toFixed(1)}k`;
  const speed = gauge_at(player.motion, player.gauges.speed, view.time);
  const heading = heading_text(true_heading(frame.run, players, i));
  return `${height_words(players.y[i]!)} ${Number.isNaN(speed) ? '' : `${quantity_text(speed, 'm/s')} `}${heading}`;
}

/** Who matters to the selected player: 0 nobody in particular. */
function priority(frame: Frame, i: number): number {
  const { run, view, sight } = frame;
  if (i === view.selected) return 100;
  if (i === frame.hovered || view.ruler?.includes(i)) return 95;
  if (sight?.now.tracks.some((track) => track.is_target && track.truth === i)) return 80;
  if (run.players[i]!.flight === run.players[view.selected]?.flight) return 50;
  return sight?.now.tracks.some((track) => track.truth === i && track.identity !== 'friendly') ? 30 : 0;
}

export function draw_names(frame: Frame): void {
  const { run, view, players, eye, notes, palette } = frame;
  const crowd = players.count > kCrowd;
  const seen: { i: number; off: number }[] = [];
  for (let i = 0; i < players.count; ++i) {
    if (!players.shown[i] || !eye.project(players.x[i]!, players.y[i]!, players.z[i]!) || !eye.on_screen()) continue;
    seen.push({ i, off: Math.hypot(eye.px - eye.width / 2, eye.py - eye.height / 2) });
    if (!crowd) notes.reserve(eye.px - 8 * eye.ui, eye.py - 8 * eye.ui, 16 * eye.ui, 16 * eye.ui);
  }
  // in a crowd those nearest to the middle of the picture get what room is left
  if (crowd) seen.sort((a, b) => a.off - b.off);
  let left = crowd ? kOthers : Infinity;
  for (const { i } of seen) {
    const matters = priority(frame, i);
    eye.project(players.x[i]!, players.y[i]!, players.z[i]!);
    const player = run.players[i]!;
    if (i === view.selected) notes.bracket(eye.px, eye.py, Math.max(18, kHalfSpan / eye.km_per_px_at() / eye.ui), palette.text);
    if (!view.layers.labels && i !== frame.hovered) continue;
    if (matters < 50 && --left < 0) continue;
    notes.tag(i, eye.px, eye.py, player.name, rest_of(player, frame), palette.side[player.side], kSideMark[player.side], matters || 10);
  }
}

export function draw_ruler({ run, view, players, lines, palette, eye, notes }: Frame): void {
  const [a, b] = view.ruler ?? [-1, -1];
  if (!players.shown[a] || !players.shown[b]) return;
  const [ax, ay, az, bx, by, bz] = [players.x[a]!, players.y[a]!, players.z[a]!, players.x[b]!, players.y[b]!, players.z[b]!];
  lines.pen(palette.ruler, 2, 14);
  lines.add(ax, ay, az, bx, by, bz, 0.95);
  const place = (x: number, y: number, z: number) => ({ east: x * 1000, north: -z * 1000, up: y * 1000 });
  const { range, bearing, higher } = measure(run.origin, place(ax, ay, az), place(bx, by, bz));
  if (!eye.project((ax + bx) / 2, (ay + by) / 2, (az + bz) / 2) || !eye.on_screen(60)) return;
  const text = `${quantity_text(range, 'm')}  ${heading_text(bearing)}  ${climb_words(higher / 1000)}`;
  notes.tag(-1, eye.px, eye.py, text, '', palette.ruler, null, 97);
}

const paths = new WeakMap<Ghost, GhostPoint[]>();

function path_of(run: Run, player: Player, ghost: Ghost): GhostPoint[] {
  return made(paths, ghost, () => {
    const start = { east: 0, north: 0, up: 0 };
    place_at(player.motion, ghost.t, start);
    const heading = ghost.heading === null ? null : ghost.heading - convergence(run.origin, start);
    return ghost_path(player, { ...ghost, heading }, kGhostSpan);
  });
}

/** Where it leads, to be in the picture. */
export function ghost_points({ run, view: { ghost } }: Frame): Vector3[] {
  const player = ghost && run.players[ghost.player];
  return ghost && player ? path_of(run, player, ghost).map(spot_of) : [];
}

export function draw_ghost({ run, view, lines, palette, eye, notes }: Frame): void {
  const { ghost } = view;
  const player = ghost && run.players[ghost.player];
  if (!ghost || !player) return;
  const path = path_of(run, player, ghost);
  lines.pen(palette.ghost, 2.2);
  // a second drawn, a second left out: the dashes tell the speed
  for (let i = 0; i + 1 < path.length; ++i) {
    if (Math.floor(path[i]!.t - ghost.t + 1e-6) % 2) continue;
    const [a, b] = [path[i]!, path[i + 1]!];
    lines.add(x_of(a), y_of(a), z_of(a), x_of(b), y_of(b), z_of(b), 0.95);
  }
  const end = path.at(-1);
  const now = path.find((point) => point.t >= view.time - 1e-6);
  if (now && view.time >= ghost.t && eye.project(x_of(now), y_of(now), z_of(now)))
    notes.mark('diamond', eye.px, eye.py, 6, palette.ghost, 2);
  if (!end || !eye.project(x_of(end), y_of(end), z_of(end)) || !eye.on_screen(60)) return;
  notes.mark('triangle', eye.px, eye.py, 7, palette.ghost, 2);
  notes.reserve(eye.px - 9 * eye.ui, eye.py - 9 * eye.ui, 18 * eye.ui, 18 * eye.ui);
  notes.tag(-2, eye.px, eye.py, ghost.label || 'what if', `+${kGhostSpan} s`, palette.ghost, null, 96);
}

const kRings = 4;
const kSides = 72;

/** Around (x, y, z), from a bearing (rad) so far on; all around unless told. */
export function draw_arc({ lines }: Frame, x: number, y: number, z: number, km: number, alpha: number, from = 0, span = 2 * Math.PI): void {
  for (let k = 0; k < kSides; ++k) {
    const [a, b] = [from + (span * k) / kSides, from + (span * (k + 1)) / kSides];
    lines.add(x + km * Math.sin(a), y, z - km * Math.cos(a), x + km * Math.sin(b), y, z - km * Math.cos(b), alpha);
  }
}

export function draw_rings(frame: Frame): void {
  const { view, players, lines, palette, eye, notes } = frame;
  const i = view.selected;
  if (!view.layers.rings || !players.shown[i]) return;
  const [x, y, z] = [players.x[i]!, players.y[i]!, players.z[i]!];
  const step = round_up(eye.stance.height / far_km() / (2 * kRings)) * far_km();
  lines.pen(palette.faint, 1.2);
  for (let k = 1; k <= kRings; ++k) {
    draw_arc(frame, x, y, z, k * step, 0.7);
    if (eye.project(x, y, z - k * step) && eye.on_screen()) notes.write(range_words(k * step), eye.px, eye.py, palette.faint);
  }
}

/** With where the selected player is from there. */
export function draw_bullseye(frame: Frame): void {
  const { run, view, players, lines, palette, eye, notes } = frame;
  if (!view.layers.bullseye) return;
  const km = 9 * eye.ui * eye.km_per_px(0, 0, 0);
  lines.pen(palette.ruler, 1.6);
  for (const part of [1, 0.5]) draw_arc(frame, 0, 0, 0, part * km, 0.95);
  lines.add(-km * 1.5, 0, 0, km * 1.5, 0, 0, 0.95);
  lines.add(0, 0, -km * 1.5, 0, 0, km * 1.5, 0.95);
  if (!eye.project(0, 0, 0) || !eye.on_screen(20)) return;
  const i = view.selected;
  const place = { east: players.x[i]! * 1000, north: -players.z[i]! * 1000, up: 0 };
  const { range, bearing } = measure(run.origin, { east: 0, north: 0, up: 0 }, place);
  const rest = players.shown[i] ? `${run.players[i]!.name} ${heading_text(bearing)} ${range_words(range / 1000)}` : '';
  notes.tag(-50, eye.px, eye.py, 'bullseye', rest, palette.ruler, null, 92);
}
