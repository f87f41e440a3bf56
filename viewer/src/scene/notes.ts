// SPDX-License-Identifier: MIT
/** A flat canvas over the scene for all that is writing or a mark: labels that keep out of each other's way. */
import type { Eye } from './eye.ts';
import { css, fill, stroke, type Palette } from './palette.ts';

export type Mark = 'circle' | 'square' | 'diamond' | 'triangle' | 'cross';

interface Tag {
  key: number;
  px: number;
  py: number;
  /** Written in full strength, then the rest in a fainter one. */
  text: string;
  rest: string;
  tint: number;
  mark: Mark | null;
  priority: number;
}

/** Corners of marks, in radii; a circle has none, and of a cross this is one of its strokes. */
const kOutlines: Partial<Record<Mark, readonly (readonly [x: number, y: number])[]>> = {
  square: [[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
  diamond: [[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]],
  triangle: [[0, -1.2], [1.1, 0.8], [-1.1, 0.8]],
  cross: [[-1, -1], [1, 1]],
};
const kFont = 11.5;
const kFamily = 'ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace';
/** Where a label is tried: directions, then distances (px). */
const kWays: readonly (readonly [number, number])[] = [[1, -0.6], [1, 0.6], [-1, -0.6], [-1, 0.6], [0, -1], [0, 1]];
const kRings = [13, 30, 52, 78, 108, 150, 200, 260] as const;
/** Of these only for what must be seen. */
const kLast = 3;

function is_clear(taken: readonly number[], x: number, y: number, width: number, height: number): boolean {
  for (let i = 0; i < taken.length; i += 4)
    if (x < taken[i]! + taken[i + 2]! && x + width > taken[i]! && y < taken[i + 1]! + taken[i + 3]! && y + height > taken[i + 1]!) return false;
  return true;
}

export class Notes {
  readonly canvas = document.createElement('canvas');
  context: CanvasRenderingContext2D;
  covered: readonly number[] = [];  // x y width height of what lies over the picture.
  private tags: Tag[] = [];
  private readonly taken: number[] = [];  // x y width height of what is taken already.
  readonly boxes: number[] = [];  // The same of all that is written: no two of them overlap.
  private readonly slots = new Map<number, number>();
  private letter = 7;
  private ratio = 1;

  /** `slow`: drawn by the processor, and better so without the detour over what only stands in for a graphics card. */
  constructor(private readonly eye: Eye, public palette: Palette, slow: boolean) {
    const context = this.canvas.getContext('2d', { willReadFrequently: slow });
    if (!context) throw new Error('no 2-D canvas');
    this.context = context;
  }

  resize(ratio: number): void {
    this.ratio = ratio;
    this.canvas.width = Math.round(this.eye.width * ratio);
    this.canvas.height = Math.round(this.eye.height * ratio);
    this.font();
    this.letter = this.context.measureText('0000000000').width / 10;
  }

  private font(): void {
    this.context.font = `${kFont * this.eye.ui}px ${kFamily}`;
    this.context.textBaseline = 'middle';
  }

  begin(): void {
    const c = this.context;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.eye.width, this.eye.height);
    this.font();
    this.tags = [];
    this.boxes.length = 0;
    this.taken.splice(0, Infinity, ...this.covered);
  }

  /** Outlined, or filled, `radius` and `width` in px of a small screen. */
  mark(kind: Mark, px: number, py: number, radius: number, tint: number, width = 1.5, filled = false, alpha = 1): void {
    const c = this.context;
    const r = radius * this.eye.ui;
    c.beginPath();
    const outline = kOutlines[kind];
    if (!outline) c.arc(px, py, r, 0, 2 * Math.PI);
    outline?.forEach(([x, y], i) => (i ? c.lineTo(px + r * x, py + r * y) : c.moveTo(px + r * x, py + r * y)));
    if (kind === 'cross') {
      c.moveTo(px + r, py - r);
      c.lineTo(px - r, py + r);
    } else {
      c.closePath();
    }
    if (filled) fill(c, tint, alpha);
    else stroke(c, tint, width * this.eye.ui, alpha);
  }

  /** Four corners around a place. */
  bracket(px: number, py: number, radius: number, tint: number): void {
    const c = this.context;
    const r = radius * this.eye.ui;
    const arm = r * 0.45;
    c.beginPath();
    for (let k = 0; k < 4; ++k) {
      const sx = k & 1 ? 1 : -1;
      const sy = k & 2 ? 1 : -1;
      c.moveTo(px + sx * r, py + sy * (r - arm));
      c.lineTo(px + sx * r, py + sy * r);
      c.lineTo(px + sx * (r - arm), py + sy * r);
    }
    stroke(c, tint, 1.6 * this.eye.ui);
  }

  /** Bare writing on a faint ground, kept clear of by labels; left out where something stands. */
  write(text: string, px: number, py: number, tint: number, align: 'center' | 'right' = 'center'): void {
    const c = this.context;
    const width = (text.length * this.letter) + 6 * this.eye.ui;
    const height = 15 * this.eye.ui;
    const left = px - (align === 'right' ? width : width / 2);
    if (!this.is_whole(left, py - height / 2, width, height) || !is_clear(this.taken, left, py - height / 2, width, height)) return;
    c.fillStyle = css(this.palette.chip, 0.62);
    c.fillRect(left, py - height / 2, width, height);
    c.fillStyle = css(tint);
    c.textAlign = 'left';
    c.fillText(text, left + 3 * this.eye.ui, py + 0.5);
    this.settle(left, py - height / 2, width, height);
  }

  /** A figure in the middle of a mark. */
  figure(text: string, px: number, py: number, tint: number): void {
    const c = this.context;
    c.textAlign = 'center';
    c.fillStyle = css(tint);
    c.fillText(text, px, py + 0.5);
  }

  reserve(x: number, y: number, width: number, height: number): void {
    this.taken.push(x, y, width, height);
  }

  /** A label beside a place, where there is room; the same `key` stays on its side if it can. Above 90 always shown. */
  tag(key: number, px: number, py: number, text: string, rest: string, tint: number, mark: Mark | null, priority: number): void {
    this.tags.push({ key, px, py, text, rest, tint, mark, priority });
  }

  /** Something is written there. */
  private settle(...box: [number, number, number, number]): void {
    this.reserve(...box);
    this.boxes.push(...box);
  }

  /** Not cut off by the edge. */
  private is_whole(x: number, y: number, width: number, height: number): boolean {
    return x >= 2 && y >= 2 && x + width <= this.eye.width - 2 && y + height <= this.eye.height - 2;
  }

  private readonly spot = { x: 0, y: 0 };
  private aim(tag: Tag, slot: number, width: number, height: number): void {
    const [wx, wy] = kWays[slot % kWays.length]!;
    const far = kRings[Math.floor(slot / kWays.length)]! * this.eye.ui;
    this.spot.x = tag.px + wx * far + (wx > 0 ? 0 : wx < 0 ? -width : -width / 2);
    this.spot.y = tag.py + wy * far - height / 2 + (wx === 0 ? (wy * height) / 2 : 0);
  }

  private place(tag: Tag, width: number, height: number): number {
    const before = this.slots.get(tag.key);
    const must = tag.priority >= 90;
    const rings = tag.priority > 20 ? kRings.length - (must ? 0 : kLast) : 1;
    // what must be seen may stand on a mark, but never on writing or below a button
    for (const taken of must ? [this.taken, [...this.boxes, ...this.covered]] : [this.taken])
      for (let k = -1; k < kWays.length * rings; ++k) {
        const slot = k < 0 ? before : k;
        if (slot === undefined) continue;
        this.aim(tag, slot, width, height);
        const { x, y } = this.spot;
        if (this.is_whole(x, y, width, height) && is_clear(taken, x, y, width, height)) return slot;
      }
    return -1;
  }

  /** Labels, the important ones first. */
  end(): void {
    const { ui } = this.eye;
    const height = 16 * ui;
    for (const tag of this.tags.sort((a, b) => b.priority - a.priority || a.key - b.key)) {
      const lead = (tag.mark ? 15 : 5) * ui;
      const wide = (): number => lead + (tag.text.length + (tag.rest ? tag.rest.length + 1 : 0)) * this.letter + 5 * ui;
      let [width, slot] = [wide(), this.place(tag, wide(), height)];
      if (slot < 0 && tag.rest) {
        tag.rest = '';
        [width, slot] = [wide(), this.place(tag, wide(), height)];
      }
      if (slot < 0) continue;
      this.slots.set(tag.key, slot);
      this.draw(tag, slot, width, height, lead);
      this.settle(this.spot.x, this.spot.y, width, height);
    }
  }

  private draw(tag: Tag, slot: number, width: number, height: number, lead: number): void {
    const c = this.context;
    const { spot, palette, eye: { ui } } = this;
    const middle = spot.y + height / 2;
    if (slot >= kWays.length) {
      c.beginPath();
      c.moveTo(tag.px, tag.py);
      c.lineTo(Math.min(spot.x + width, Math.max(spot.x, tag.px)), Math.min(spot.y + height, Math.max(spot.y, tag.py)));
      stroke(c, tag.tint, ui, 0.5);
    }
    c.beginPath();
    c.roundRect(spot.x, spot.y, width, height, tag.mark === 'circle' ? height / 2 : 2 * ui);
    fill(c, palette.chip, 0.8);
    if (tag.priority >= 90) stroke(c, tag.tint, ui);
    if (tag.mark) this.mark(tag.mark, spot.x + 8.5 * ui, middle, 3.6, tag.tint, 1.5, tag.mark !== 'cross');
    c.textAlign = 'left';
    c.fillStyle = css(palette.text);
    c.fillText(tag.text, spot.x + lead, middle + 0.5);
    if (tag.rest) {
      c.fillStyle = css(palette.faint);
      c.fillText(tag.rest, spot.x + lead + (tag.text.length + 1) * this.letter, middle + 0.5);
    }
  }
}
