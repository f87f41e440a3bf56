// SPDX-License-Identifier: MIT
/** Canvases that fit their box, are sharp on every screen and follow the theme. */
import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { made } from '../made.ts';
import { use_page } from './page.ts';
import { use_size, use_view } from './use.ts';

export interface Sheet {
  pen: CanvasRenderingContext2D;
  width: number;  // CSS pixels.
  height: number;
  rem: number;  // CSS pixels of one.
}

export function rem_size(): number {
  return parseFloat(getComputedStyle(document.documentElement).fontSize);
}

/** A custom property of the style sheet, such as "ink". */
export function color(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** px: where times stand on an axis that shows `range` (s) so wide. */
export function on_axis([from, to]: readonly [number, number], width: number): (t: number) => number {
  return (t) => ((t - from) / (to - from)) * width;
}

/** Draws again if the size of the canvas, the theme or one of `inputs` changes. */
export function use_canvas(draw: (sheet: Sheet) => void, inputs: readonly unknown[]): RefObject<HTMLCanvasElement | null> {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [width, height] = use_size(canvas);
  const theme = use_view(use_page().store, (v) => v.theme);
  useLayoutEffect(() => {
    const pen = canvas.current?.getContext('2d');
    if (!pen || !width || !height) return;
    const scale = devicePixelRatio;
    const sheet = pen.canvas;
    sheet.width = Math.round(width * scale);
    sheet.height = Math.round(height * scale);
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    draw({ pen, width, height, rem: rem_size() });
  }, [width, height, theme, ...inputs]);
  return canvas;
}

/** "a long na…": as much of `text` as fits. */
export function fitted(pen: CanvasRenderingContext2D, text: string, room: number): string {
  if (pen.measureText(text).width <= room) return text;
  let end = text.length - 1;
  while (end > 1 && pen.measureText(`${text.slice(0, end)}…`).width > room) --end;
  return end > 1 ? `${text.slice(0, end)}…` : '';
}

let measuring: CanvasRenderingContext2D | null = null;
const kMeasured = new Map<string, number>();

/** px, of words in the font of the page. */
export function text_width(text: string, size: number): number {
  return made(kMeasured, `${size}/${text}`, () => {
    measuring ??= document.createElement('canvas').getContext('2d')!;
    measuring.font = `${size}px system-ui, sans-serif`;
    return measuring.measureText(text).width;
  });
}
