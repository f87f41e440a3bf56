// SPDX-License-Identifier: MIT
/** Fire and smoke on a flat canvas: a soft disc for each colour, scaled to what is needed. */
import { made } from '../../made.ts';
import type { Eye } from '../eye.ts';
import type { Discs } from '../painter.ts';
import { css } from '../palette.ts';

const kMost = 1024;
/** px of a disc that is scaled. */
const kSize = 64;
/** CSS px: larger ones are not drawn larger. */
const kLargest = 256;

function disc_of(tint: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = kSize;
  const context = canvas.getContext('2d')!;
  const middle = kSize / 2;
  const shade = context.createRadialGradient(middle, middle, 0.35 * middle, middle, middle, middle);
  // by halves, as a smooth step goes
  for (const [at, alpha] of [[0, 1], [0.25, 0.84], [0.5, 0.5], [0.75, 0.16], [1, 0]] as const) shade.addColorStop(at, css(tint, alpha));
  context.fillStyle = shade;
  context.fillRect(0, 0, kSize, kSize);
  return canvas;
}

/** As many as fit; what is beyond is left out. */
export class FlatPuffs implements Discs {
  private puffs: Parameters<Discs['add']>[] = [];
  private readonly discs = new Map<number, HTMLCanvasElement>();

  add(...puff: Parameters<Discs['add']>): void {
    if (this.puffs.length < kMost) this.puffs.push(puff);
  }

  draw(context: CanvasRenderingContext2D, eye: Eye): void {
    for (const [x, y, z, km, least, tint, alpha] of this.puffs) {
      if (!eye.project(x, y, z) || !eye.on_screen(kLargest)) continue;
      const radius = Math.min(kLargest, Math.max(least * eye.ui, km / eye.km_per_px_at()));
      const disc = made(this.discs, tint, () => disc_of(tint));
      context.globalAlpha = Math.min(1, alpha);
      context.drawImage(disc, eye.px - radius, eye.py - radius, 2 * radius, 2 * radius);
    }
    context.globalAlpha = 1;
    this.puffs = [];
  }
}
