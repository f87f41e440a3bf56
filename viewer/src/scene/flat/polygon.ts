// SPDX-License-Identifier: MIT
/** Areas as they are seen, as far as they are in front of the eye. */
import type { Eye } from '../eye.ts';

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
