// SPDX-License-Identifier: MIT
/** What every layer draws from and into. Each is a function of this alone, so a picture depends on nothing before it. */
import type { Place, Run } from '../run/run.ts';
import type { View } from '../store.ts';
import { height_text, size_of_unit, spoken } from '../words/text.ts';
import type { Eyesight } from './beliefs.ts';
import type { Eye } from './eye.ts';
import type { Poses } from './motion.ts';
import type { Mark, Notes } from './notes.ts';
import type { Other } from './other.ts';
import type { Discs, Pens } from './painter.ts';
import type { Palette } from './palette.ts';

export interface Frame {
  run: Run;
  other: Other | null;  // Flown on otherwise; null: nobody has asked.
  view: View;
  players: Poses;
  missiles: Poses;
  sight: Eyesight | null;  // What the selected player believes; null: there is none, or it is not alive.
  eye: Eye;
  lines: Pens;
  puffs: Discs;
  notes: Notes;
  palette: Palette;
  hovered: number;  // Under the pointer; -1: nobody.
}

/** More players than these are a crowd: smaller, and only those who matter are named. */
export const kCrowd = 40;

/** km: one of the far, or of the near, lengths that people read. */
export const far_km = (): number => size_of_unit(spoken().far) / 1000;
export const near_km = (): number => size_of_unit(spoken().near) / 1000;

/** Shapes tell the sides apart where colours do not. */
export const kSideMark: Record<'blue' | 'red' | 'none', Mark> = { blue: 'circle', red: 'square', none: 'diamond' };

/** A place of the run in the scene's units. */
export const x_of = (place: Place): number => place.east / 1000;
export const y_of = (place: Place): number => place.up / 1000;
export const z_of = (place: Place): number => -place.north / 1000;

/** "14 nmi" */
export function range_words(km: number): string {
  const value = km / far_km();
  return `${value < 9.95 ? value.toFixed(1) : value.toFixed(0)} ${spoken().far[0]}`;
}

/** "27400 ft": in hundreds. */
export function height_words(km: number): string {
  const hundred = 100 * near_km();
  return height_text(Math.round(km / hundred) * hundred * 1000);
}

/** "+2400 ft": how much higher, in hundreds; without a sign if that is none. */
export function climb_words(km: number): string {
  const size = height_words(Math.abs(km));
  return size.startsWith('0 ') ? size : `${km < 0 ? '-' : '+'}${size}`;
}
