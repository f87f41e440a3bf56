// SPDX-License-Identifier: MIT
/** The radar's volume on a flat canvas: its lower and its upper face, each half of the veil. */
import type { Eye } from '../eye.ts';
import { css, type Palette } from '../palette.ts';
import { corner_of, kColumns, kRows, kTrackVeil, type Volume } from '../radar.ts';

/** Share of the veil that is left at its far end. */
const kFar = 0.3;

/** Whether all of the face is in front of the eye. */
function trace(path: Path2D, eye: Eye, p: Float32Array, row: number): boolean {
  const put = (corner: number): boolean => {
    if (!eye.project(p[3 * corner]!, p[3 * corner + 1]!, p[3 * corner + 2]!)) return false;
    if (corner === 0) path.moveTo(eye.px, eye.py);
    else path.lineTo(eye.px, eye.py);
    return true;
  };
  if (!put(0)) return false;
  for (let column = 0; column <= kColumns; ++column) if (!put(corner_of(column, row))) return false;
  path.closePath();
  return true;
}

export function draw_volume(context: CanvasRenderingContext2D, eye: Eye, palette: Palette, { corners, track }: Volume): void {
  const veil = (palette.veil * (track ? kTrackVeil : 1)) / 2;
  for (const row of [0, kRows]) {
    const path = new Path2D();
    if (!trace(path, eye, corners, row)) continue;
    const middle = 3 * corner_of(kColumns / 2, row);
    eye.project(corners[middle]!, corners[middle + 1]!, corners[middle + 2]!);
    const [far_x, far_y] = [eye.px, eye.py];
    eye.project(corners[0]!, corners[1]!, corners[2]!);
    const shade = context.createRadialGradient(eye.px, eye.py, 0, eye.px, eye.py, Math.max(1, Math.hypot(far_x - eye.px, far_y - eye.py)));
    shade.addColorStop(0, css(palette.radar, veil));
    shade.addColorStop(1, css(palette.radar, veil * kFar));
    context.fillStyle = shade;
    context.fill(path);
  }
}
