// SPDX-License-Identifier: MIT
/** Fire and smoke on a flat canvas: a soft disc for each colour, scaled to what is needed. */
import type { Eye } from '../eye.ts';
import type { Discs } from '../painter.ts';
import { css } from '../palette.ts';

const kNumbers = 7;
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
  private readonly numbers = new Float64Array(kMost * kNumbers);
  private readonly discs = new Map<number, HTMLCanvasElement>();
  private count = 0;

  begin(): void {
    this.count = 0;
  }

  add(x: number, y: number, z: number, radius: number, least: number, tint: number, alpha: number): void {
    if (this.count === kMost) return;
    this.numbers.set([x, y, z, radius, least, tint, alpha], kNumbers * this.count++);
  }

  draw(context: CanvasRenderingContext2D, eye: Eye): void {
    const n = this.numbers;
    for (let k = 0, i = 0; k < this.count; ++k, i += kNumbers) {
      if (!eye.project(n[i]!, n[i + 1]!, n[i + 2]!) || !eye.on_screen(kLargest)) continue;
      const radius = Math.min(kLargest, Math.max(n[i + 4]! * eye.ui, n[i + 3]! / eye.km_per_px_at()));
      const tint = n[i + 5]!;
      let disc = this.discs.get(tint);
      if (!disc) this.discs.set(tint, (disc = disc_of(tint)));
      context.globalAlpha = Math.min(1, n[i + 6]!);
      context.drawImage(disc, eye.px - radius, eye.py - radius, 2 * radius, 2 * radius);
    }
    context.globalAlpha = 1;
  }
}
