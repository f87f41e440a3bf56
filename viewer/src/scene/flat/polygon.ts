// SPDX-License-Identifier: MIT
/** Areas on the ground as they are seen, as far as they are in front of the eye. */
import type { Eye } from '../eye.ts';

/** km: nothing nearer to the eye is drawn. */
const kNear = 0.05;

/** Where the segment from a to b passes the plane just in front of the eye, as a share of it. */
function passes(eye: Eye, ax: number, az: number, bx: number, bz: number): number {
  const a = eye.depth_of(ax, 0, az) - kNear;
  const b = eye.depth_of(bx, 0, bz) - kNear;
  return a / (a - b);
}

/** Adds the polygon with these corners (x z, km) to the path. */
export function trace_ground(path: Path2D, eye: Eye, corners: ArrayLike<number>, first = 0, count = corners.length): void {
  let begun = false;
  const put = (x: number, z: number): void => {
    eye.project(x, 0, z);
    if (begun) path.lineTo(eye.px, eye.py);
    else path.moveTo(eye.px, eye.py);
    begun = true;
  };
  for (let i = 0; i < count; i += 2) {
    const [ax, az] = [corners[first + i]!, corners[first + i + 1]!];
    const next = (i + 2) % count;
    const [bx, bz] = [corners[first + next]!, corners[first + next + 1]!];
    const a_seen = eye.depth_of(ax, 0, az) >= kNear;
    if (a_seen) put(ax, az);
    if (a_seen === eye.depth_of(bx, 0, bz) >= kNear) continue;
    const share = passes(eye, ax, az, bx, bz);
    put(ax + (bx - ax) * share, az + (bz - az) * share);
  }
  if (begun) path.closePath();
}

/** Corners of a circle on the ground. */
export function circle_on_ground(x: number, z: number, radius: number, corners = 64): Float64Array {
  const out = new Float64Array(2 * corners);
  for (let k = 0; k < corners; ++k) {
    out[2 * k] = x + radius * Math.cos((2 * Math.PI * k) / corners);
    out[2 * k + 1] = z + radius * Math.sin((2 * Math.PI * k) / corners);
  }
  return out;
}
