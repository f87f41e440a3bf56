// SPDX-License-Identifier: MIT
/** Areas on a flat canvas, as far as they are in front of the eye; the radar's volume is two of them, its lower and its upper face,
 * each half of the veil. */
import type { Eye } from '../eye.ts';
import { css, type Palette } from '../palette.ts';
import { corner_of, kColumns, kRows, kTrackVeil, type Volume } from '../radar.ts';

/** km: nothing nearer to the eye is drawn. */
const kNear = 0.05;

/** Adds the polygon with these corners (x y z each, in the scene) to the path: `count` of them from number `first`. */
export function trace_area(path: Path2D, eye: Eye, corners: ArrayLike<number>, first = 0, count = corners.length / 3): void {
  let begun = false;
  const put = (x: number, y: number, z: number): void => {
    eye.project(x, y, z);
    if (begun) path.lineTo(eye.px, eye.py);
    else path.moveTo(eye.px, eye.py);
    begun = true;
  };
  for (let i = 0; i < count; ++i) {
    const a = 3 * (first + i);
    const b = 3 * (first + ((i + 1) % count));
    const [ax, ay, az] = [corners[a]!, corners[a + 1]!, corners[a + 2]!];
    const [bx, by, bz] = [corners[b]!, corners[b + 1]!, corners[b + 2]!];
    const before = eye.depth_of(ax, ay, az) - kNear;
    const after = eye.depth_of(bx, by, bz) - kNear;
    if (before >= 0) put(ax, ay, az);
    if (before >= 0 === after >= 0) continue;
    const share = before / (before - after);
    put(ax + (bx - ax) * share, ay + (by - ay) * share, az + (bz - az) * share);
  }
  if (begun) path.closePath();
}

/** Corners of a circle on the ground. */
export function circle_on_ground(x: number, z: number, radius: number, corners = 64): Float64Array {
  const out = new Float64Array(3 * corners);
  for (let k = 0; k < corners; ++k) {
    out[3 * k] = x + radius * Math.cos((2 * Math.PI * k) / corners);
    out[3 * k + 2] = z + radius * Math.sin((2 * Math.PI * k) / corners);
  }
  return out;
}

/** Share of the veil that is left at its far end. */
const kFar = 0.3;

/** The antenna, then one row of the front. */
const face = new Float32Array(3 * (kColumns + 2));

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
    const from = 3 * corner_of(0, row);
    face.set(corners.subarray(0, 3));
    face.set(corners.subarray(from, from + 3 * (kColumns + 1)), 3);
    const path = new Path2D();
    trace_area(path, eye, face);
    context.fillStyle = shade_of(context, eye, palette.radar, veil);
    context.fill(path);
  }
}
