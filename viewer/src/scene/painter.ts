// SPDX-License-Identifier: MIT
/** What the layers draw with, and what puts it on the screen: with a graphics card (gl), or without (flat). */
import type { Frame } from './frame.ts';
import type { Palette } from './palette.ts';
import type { Volume } from './radar.ts';

/** Segments in scene units. */
export interface Pens {
  /** What follows has this colour and width (CSS px), and dashes as long as this with their gaps (CSS px); 0: solid. */
  pen(tint: number, width: number, dash?: number): void;
  /** From opacity to opacity. */
  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, alpha: number, to_alpha?: number): void;
}

/** Soft discs that face the eye: fire, smoke and flashes. */
export interface Discs {
  /** `radius` in scene units, but at least `least` CSS px. */
  add(x: number, y: number, z: number, radius: number, least: number, tint: number, alpha: number): void;
}

export interface Painter {
  readonly lines: Pens;
  readonly puffs: Discs;
  /** Size of the picture in CSS px, and how many of its own pixels are drawn for each of those. */
  resize(width: number, height: number, ratio: number): void;
  paint(palette: Palette): void;
  /** Lines and puffs of the next picture follow. */
  begin(): void;
  /** The picture: ground, everybody, the radar's volume, and what was given to lines and puffs. */
  draw(frame: Frame, volume: Volume | null): void;
  dispose(): void;
}
