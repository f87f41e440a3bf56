// SPDX-License-Identifier: MIT
/** Lines on a flat canvas: what looks the same is stroked in one go. */
import type { Eye } from '../eye.ts';
import type { Pens } from '../painter.ts';
import { css } from '../palette.ts';

const kNumbers = 6;
/** Of opacity. */
const kLevels = 24;
/** For each px. */
const kWidths = 4;

interface Pen {
  tint: number;
  width: number;
  dash: number;
  /** A path for each level of opacity that was used, and where it ends. */
  paths: (Path2D | undefined)[];
  ends: Float64Array;
}

export class FlatLines implements Pens {
  private readonly pens: Pen[] = [];
  private pen_count = 0;
  private current = 0;
  private count = 0;
  private places = new Float64Array(2048 * kNumbers);
  private styles = new Uint16Array(2048);

  begin(): void {
    this.count = 0;
    this.pen_count = 0;
  }

  pen(tint: number, wanted: number, dash = 0): void {
    const { pens } = this;
    // smoke has a width of its own for each of its ages
    const width = Math.max(1, Math.round(wanted * kWidths)) / kWidths;
    for (let i = 0; i < this.pen_count; ++i) {
      const pen = pens[i]!;
      if (pen.tint !== tint || pen.width !== width || pen.dash !== dash) continue;
      this.current = i;
      return;
    }
    this.current = this.pen_count++;
    const pen = (pens[this.current] ??= { tint, width, dash, paths: [], ends: new Float64Array(2 * kLevels + 2) });
    pen.tint = tint;
    pen.width = width;
    pen.dash = dash;
  }

  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, alpha: number, to_alpha = alpha): void {
    const level = Math.round(((alpha + to_alpha) / 2) * kLevels);
    if (level <= 0) return;
    if (this.count === this.styles.length) this.grow();
    const p = this.places;
    let i = this.count * kNumbers;
    p[i++] = ax;
    p[i++] = ay;
    p[i++] = az;
    p[i++] = bx;
    p[i++] = by;
    p[i] = bz;
    this.styles[this.count++] = this.current * (kLevels + 1) + level;
  }

  private grow(): void {
    const { places, styles } = this;
    this.places = new Float64Array(2 * places.length);
    this.places.set(places);
    this.styles = new Uint16Array(2 * styles.length);
    this.styles.set(styles);
  }

  /** Segments that follow each other become one line. */
  private trace(eye: Eye): void {
    const { places: p, styles, pens } = this;
    for (let k = 0, i = 0; k < this.count; ++k, i += kNumbers) {
      if (!eye.segment(p[i]!, p[i + 1]!, p[i + 2]!, p[i + 3]!, p[i + 4]!, p[i + 5]!)) continue;
      const pen = pens[Math.floor(styles[k]! / (kLevels + 1))]!;
      const level = styles[k]! % (kLevels + 1);
      const { ends } = pen;
      let path = pen.paths[level];
      if (!path || ends[2 * level] !== eye.px || ends[2 * level + 1] !== eye.py) {
        path ??= pen.paths[level] = new Path2D();
        path.moveTo(eye.px, eye.py);
      }
      path.lineTo(eye.qx, eye.qy);
      ends[2 * level] = eye.qx;
      ends[2 * level + 1] = eye.qy;
    }
  }

  draw(context: CanvasRenderingContext2D, eye: Eye): void {
    this.trace(eye);
    for (let i = 0; i < this.pen_count; ++i) {
      const { tint, width, dash, paths } = this.pens[i]!;
      context.lineWidth = width * eye.ui;
      context.setLineDash(dash > 0 ? [0.55 * dash * eye.ui, 0.45 * dash * eye.ui] : []);
      paths.forEach((path, level) => {
        if (!path) return;
        context.strokeStyle = css(tint, level / kLevels);
        context.stroke(path);
      });
      paths.length = 0;
    }
    context.setLineDash([]);
  }
}
