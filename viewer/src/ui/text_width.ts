// SPDX-License-Identifier: MIT
/** How wide words are in pictures. */

let measuring: CanvasRenderingContext2D | null = null;
const kMeasured = new Map<string, number>();

/** px, in the font of the page. */
export function text_width(text: string, size: number): number {
  const key = `${size}/${text}`;
  let width = kMeasured.get(key);
  if (width === undefined) {
    measuring ??= document.createElement('canvas').getContext('2d')!;
    measuring.font = `${size}px system-ui, sans-serif`;
    kMeasured.set(key, (width = measuring.measureText(text).width));
  }
  return width;
}
