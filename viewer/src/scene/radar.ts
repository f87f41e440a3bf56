// SPDX-License-Identifier: MIT
/** What the selected player's radar sweeps: a sector of a shell, brightest at the antenna. */
import type { Frame } from './frame.ts';
import type { Pens } from './painter.ts';

export const kColumns = 36;
export const kRows = 4;
/** How much stronger the veil of one is that follows a target. */
export const kTrackVeil = 1.9;

export interface Volume {
  corners: Float32Array;  // x y z of the antenna, then of the front, row by row from the lowest.
  track: boolean;  // It follows one target, and is drawn stronger.
}

const volume: Volume = { corners: new Float32Array(3 + (kColumns + 1) * (kRows + 1) * 3), track: false };

/** Of that column and row, where its corner is among all. */
export function corner_of(column: number, row: number): number {
  return 1 + row * (kColumns + 1) + column;
}

/** The four edges from the antenna, and the rim. */
function outline(lines: Pens, p: Float32Array, alpha: number): void {
  const join = (a: number, b: number, from: number, to: number): void =>
    lines.add(p[3 * a]!, p[3 * a + 1]!, p[3 * a + 2]!, p[3 * b]!, p[3 * b + 1]!, p[3 * b + 2]!, from, to);
  for (const c of [0, kColumns]) {
    join(0, corner_of(c, 0), alpha, alpha * 0.5);
    join(0, corner_of(c, kRows), alpha, alpha * 0.5);
    for (let r = 0; r < kRows; ++r) join(corner_of(c, r), corner_of(c, r + 1), alpha * 0.5, alpha * 0.5);
  }
  for (const r of [0, kRows])
    for (let c = 0; c < kColumns; ++c) join(corner_of(c, r), corner_of(c + 1, r), alpha * 0.5, alpha * 0.5);
}

/** Draws the edges, and says what is between them; null: there is none. */
export function draw_radar({ view, players, palette, lines, sight }: Frame): Volume | null {
  const player = sight?.player;
  const scan = sight?.now.scan;
  const radar = player?.radar;
  if (!view.layers.radar || !player || !radar || !scan || scan.mode === 'off') return null;
  const i = player.index;
  const heading = players.heading[i]! + scan.azimuth;
  const range = radar.range / 1000;
  const [x, y, z] = [players.x[i]!, players.y[i]!, players.z[i]!];
  const { corners } = volume;
  corners.set([x, y, z]);
  for (let row = 0; row <= kRows; ++row) {
    const elevation = Math.min(1.55, Math.max(-1.55, scan.elevation + radar.elevation * ((2 * row) / kRows - 1)));
    const level = Math.cos(elevation) * range;
    for (let column = 0; column <= kColumns; ++column) {
      const azimuth = heading + radar.azimuth * ((2 * column) / kColumns - 1);
      const at = 3 * corner_of(column, row);
      corners[at] = x + Math.sin(azimuth) * level;
      corners[at + 1] = y + Math.sin(elevation) * range;
      corners[at + 2] = z - Math.cos(azimuth) * level;
    }
  }
  volume.track = scan.mode === 'track';
  lines.pen(palette.radar, volume.track ? 1.6 : 1);
  outline(lines, corners, volume.track ? 0.8 : 0.45);
  return volume;
}
