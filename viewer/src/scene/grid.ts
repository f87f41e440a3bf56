// SPDX-License-Identifier: MIT
/** The grid on the ground in the far lengths that people read, and how much of the picture is ground. */
import { kReach } from './coast.ts';
import type { Eye } from './eye.ts';
import { far_km } from './frame.ts';
import type { Pens } from './painter.ts';
import type { Palette } from './palette.ts';

/** Up to here (shares of the reach) the ground has its own colour; at the second it has become the sky's. */
export const kClear = 0.35;
export const kHazy = 0.95;
/** Lines of the grid on each side of the middle, and of the pieces in which each fades. */
const kHalf = 14;
const kPieces = 10;
/** Of the far lengths. */
const [kFinest, kCoarsest] = [0.1, 500];
/** Each so many lines there is a stronger one, that reaches further. */
const kCoarse = 10;

export interface Grid {
  step: number;  // nmi between lines.
  /** km: the ground seen in the middle of the picture, or lower down if the view is flat. */
  x: number;
  z: number;
}

/** 1, 2 or 5 times a power of ten, not smaller than x, or not larger. */
export function round_up(x: number): number {
  return round_of(x, (all) => all.find((one) => one >= x * (1 - 1e-9)));
}
export function round_down(x: number): number {
  return round_of(x, (all) => all.findLast((one) => one <= x * (1 + 1e-9)));
}
function round_of(x: number, choose: (all: number[]) => number | undefined): number {
  const power = Math.floor(Math.log10(x) + 1e-9);
  // the nearest numbers to what is written
  return choose([1, 2, 5, 10].map((one) => Number(`${one}e${power}`)))!;
}

/** Some eight lines to the height of the picture. */
export function grid_of(eye: Eye): Grid {
  if (!eye.hit(eye.width / 2, eye.height * (0.5 + 0.32 * Math.sin(eye.stance.polar)))) return { step: 1, x: 0, z: 0 };
  const { ground_x: x, ground_z: z } = eye;
  const wanted = (eye.km_per_px(x, 0, z) * eye.height) / far_km() / 8;
  return { step: Math.min(kCoarsest, Math.max(kFinest, round_up(wanted))), x, z };
}

function lay(lines: Pens, km: number, x: number, z: number): void {
  const radius = kHalf * km;
  const [mx, mz] = [Math.round(x / km) * km, Math.round(z / km) * km];
  const alpha = (a: number, b: number): number => 0.5 * Math.max(0, 1 - (a * a + b * b) / (radius * radius));
  for (let k = -kHalf; k <= kHalf; ++k)
    for (let piece = 0; piece < kPieces; ++piece) {
      const from = radius * ((2 * piece) / kPieces - 1);
      const to = radius * ((2 * (piece + 1)) / kPieces - 1);
      const off = k * km;
      const [a, b] = [alpha(off, from), alpha(off, to)];
      if (a === 0 && b === 0) continue;
      lines.add(mx + off, 0, mz + from, mx + off, 0, mz + to, a, b);
      lines.add(mx + from, 0, mz + off, mx + to, 0, mz + off, a, b);
    }
}

export function draw_grid(lines: Pens, { step, x, z }: Grid, palette: Palette): void {
  const km = step * far_km();
  lines.pen(palette.grid, 0.9);
  lay(lines, km, x, z);
  lay(lines, km * kCoarse, Math.round(x / km) * km, Math.round(z / km) * km);
}

/** Whether all of the picture is ground in its own colour: the sea then needs no drawing. */
export function is_near(eye: Eye, x: number, z: number): boolean {
  for (const px of [0, eye.width])
    for (const py of [0, eye.height]) {
      if (!eye.hit(px, py)) return false;
      const { ground_x, ground_z } = eye;
      if (Math.max(Math.hypot(ground_x - x, ground_z - z), Math.hypot(ground_x, ground_z)) > kClear * kReach) return false;
    }
  return true;
}
