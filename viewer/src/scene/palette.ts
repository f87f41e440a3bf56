// SPDX-License-Identifier: MIT
/** The picture's colours, 0xRRGGBB, after Okabe and Ito's set that colour-blind people can tell apart; and how
 * models are lit: by the sky from above, by the ground from below, and by a sun. */
import { made } from '../made.ts';
import type { Side } from '../run/run.ts';
import type { View } from '../store.ts';

/** In the dark, and in the light. */
const kBoth = {
  sky: [0x06090e, 0xdce5ee],
  sea: [0x0c131b, 0xf4f7fa],
  land: [0x1a242d, 0xe3e5dc],
  shore: [0x51687c, 0x8d9aa5],
  grid: [0x6f879d, 0x7d8f9f],
  text: [0xe6edf4, 0x15202b],
  faint: [0x93a3b3, 0x52616f],
  chip: [0x0a1017, 0xffffff],
  side: [{ blue: 0x56b4e9, red: 0xf27a35, none: 0xc3cbd3 }, { blue: 0x0072b2, red: 0xd55e00, none: 0x5b6670 }],
  radar: [0x2fc69b, 0x007a5a],
  veil: [0.085, 0.07],  // opacity of the radar's volume in search
  zone: [0xe08fbd, 0x9c3f74],
  ruler: [0xf0e442, 0x6b5900],
  ghost: [0xffffff, 0x000000],
  fire: [0xff8c1a, 0xf07800],  // what burns, its core, and what is left of it
  core: [0xfff2c4, 0xffd75e],
  smoke: [0x8d98a3, 0x6c757d],
} as const;

export type Palette = { [K in Exclude<keyof typeof kBoth, 'side'>]: number } & { side: Record<Side, number> };

function palette(i: 0 | 1): Palette {
  return Object.fromEntries(Object.entries(kBoth).map(([name, both]) => [name, both[i]])) as Palette;
}
const [kDark, kLight] = [palette(0), palette(1)];

export function palette_of(theme: View['theme']): Palette {
  return theme === 'dark' ? kDark : kLight;
}

const styles = new Map<number, string>();

/** What a 2-D canvas calls the colour. */
export function css(tint: number, alpha = 1): string {
  const key = tint * 256 + Math.round(alpha * 255);
  return made(styles, key, () => `rgba(${tint >> 16},${(tint >> 8) & 255},${tint & 255},${alpha})`);
}

/** Fills the pen's path, or another one. */
export function fill(pen: CanvasRenderingContext2D, tint: number, alpha = 1, path?: Path2D, rule?: CanvasFillRule): void {
  pen.fillStyle = css(tint, alpha);
  if (path) pen.fill(path, rule);
  else pen.fill();
}

/** Draws along the pen's path, so many px wide. */
export function stroke(pen: CanvasRenderingContext2D, tint: number, width: number, alpha = 1): void {
  pen.strokeStyle = css(tint, alpha);
  pen.lineWidth = width;
  pen.stroke();
}

export const kSky = 0xffffff;
export const kGround = 0x56606b;
/** Of sky and ground. */
export const kDiffuse = 1.6;
export const kSunlight = 1.9;
/** To the sun, in the scene. */
export const kSun = [-0.6, 1, 0.5] as const;
