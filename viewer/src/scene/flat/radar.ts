// SPDX-License-Identifier: MIT
/** The radar's volume on a flat canvas: its lower and its upper face, each half of the veil. */
import type { Eye } from '../eye.ts';
import { css, type Palette } from '../palette.ts';
import { corner_of, kColumns, kRows, kTrackVeil, type Volume } from '../radar.ts';
import { trace_area } from './polygon.ts';

/** Share of the veil that is left at its far end. */
const kFar = 0.3;

/** The antenna, then one row of the front. */
const face = new Float32Array(3 * (kColumns + 2));

function take_face(corners: Float32Array, row: number): void {
  const from = 3 * corner_of(0, row);
  face.set(corners.subarray(0, 3));
  face.set(corners.subarray(from, from + 3 * (kColumns + 1)), 3);
}

/** Brightest at the antenna, if that is in front of the eye. */
function shade_of(context: CanvasRenderingContext2D, eye: Eye, tint: number, veil: number): CanvasGradient | string {
  const middle = 3 * (1 + kColumns / 2);
  if (!eye.project(face[middle]!, face[middle + 1]!, face[middle + 2]!)) return css(tint, veil);
  const [far_x, far_y] = [eye.px, eye.py];
  if (!eye.project(face[0]!, face[1]!, face[2]!)) return css(tint, veil * kFar);
  const reach = Math.max(1, Math.hypot(far_x - eye.px, far_y - eye.py));
  const shade = context.createRadialGradient(eye.px, eye.py, 0, eye.px, eye.py, reach);
  shade.addColorStop(0, css(tint, veil));
  shade.addColorStop(1, css(tint, veil * kFar));
  return shade;
}

export function draw_volume(context: CanvasRenderingContext2D, eye: Eye, palette: Palette, { corners, track }: Volume): void {
  const veil = (palette.veil * (track ? kTrackVeil : 1)) / 2;
  for (const row of [0, kRows]) {
    take_face(corners, row);
    const path = new Path2D();
    trace_area(path, eye, face);
    context.fillStyle = shade_of(context, eye, palette.radar, veil);
    context.fill(path);
  }
}
