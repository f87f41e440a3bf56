// SPDX-License-Identifier: MIT
/** What ranges and bearings are told by: rings around the selected player, and the bullseye, which is the scenario's reference. */
import { heading_text } from '../words/text.ts';
import { far_km, type Frame, range_words } from './frame.ts';
import { measure } from './geo.ts';
import { round_up } from './grid.ts';

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
