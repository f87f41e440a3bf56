// SPDX-License-Identifier: MIT
/** Lines on a flat canvas, of which what looks the same is stroked in one go; and fire and smoke, a soft disc for each colour, scaled to
 * what is needed. */
import { made } from '../../made.ts';
import type { Eye } from '../eye.ts';
import type { Discs, Pens } from '../painter.ts';
import { css } from '../palette.ts';

/** Of opacity. */
const kLevels = 24;
/** For each px. */
const kWidths = 4;

interface Pen {
  tint: number;
  width: number;
  dash: number;
  segments: number[][];  // For each level of opacity that was used, x y z of both ends of each segment.
}

/** Segments that follow each other become one line. */
function trace(eye: Eye, p: number[]): Path2D | null {
  let path: Path2D | null = null;
  let [x, y] = [NaN, NaN];
  for (let i = 0; i < p.length; i += 6) {
    if (!eye.segment(p[i]!, p[i + 1]!, p[i + 2]!, p[i + 3]!, p[i + 4]!, p[i + 5]!)) continue;
    path ??= new Path2D();
    if (x !== eye.px || y !== eye.py) path.moveTo(eye.px, eye.py);
    path.lineTo(eye.qx, eye.qy);
    [x, y] = [eye.qx, eye.qy];
  }
  return path;
}

export class FlatLines implements Pens {
  private readonly pens = new Map<string, Pen>();
  private current: Pen | null = null;

  clear(): void {
    this.pens.clear();
  }

  pen(tint: number, wanted: number, dash = 0): void {
    // smoke has a width of its own for each of its ages
    const width = Math.max(1, Math.round(wanted * kWidths)) / kWidths;
    this.current = made(this.pens, `${tint} ${width} ${dash}`, () => ({ tint, width, dash, segments: [] }));
  }

  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, alpha: number, to_alpha = alpha): void {
    const level = Math.round(((alpha + to_alpha) / 2) * kLevels);
    if (level > 0) (this.current!.segments[level] ??= []).push(ax, ay, az, bx, by, bz);
  }

  draw(context: CanvasRenderingContext2D, eye: Eye): void {
    for (const { tint, width, dash, segments } of this.pens.values()) {
      context.lineWidth = width * eye.ui;
      context.setLineDash(dash > 0 ? [0.55 * dash * eye.ui, 0.45 * dash * eye.ui] : []);
      segments.forEach((places, level) => {
        const path = trace(eye, places);
        if (!path) return;
        context.strokeStyle = css(tint, level / kLevels);
        context.stroke(path);
      });
    }
    context.setLineDash([]);
  }
}

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
