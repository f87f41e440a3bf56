// SPDX-License-Identifier: MIT
/** How large everybody is drawn, and how turned: never smaller on screen than can be read. */
import type { Eye } from './eye.ts';
import { kCrowd } from './frame.ts';
import type { Poses } from './poses.ts';
import type { ShapeName } from './shapes.ts';

/** Least length on screen, CSS px. */
const kLeast: Record<ShapeName, number> = { eagle: 30, fulcrum: 28, fighter: 27, truck: 14, missile: 13 };
const kCrowded = 0.72;

/** Scene units for each m of a model so many km long. */
export function size_of(name: ShapeName, length: number, poses: Poses, i: number, eye: Eye): number {
  const least = kLeast[name] * eye.ui * (poses.count > kCrowd ? kCrowded : 1);
  return 0.001 * Math.max(1, (least * eye.km_per_px(poses.x[i]!, poses.y[i]!, poses.z[i]!)) / length);
}

/** Columns of the turn by roll, then pitch, then heading, times `size`; then the place. */
export function write_matrix(out: Float32Array, at: number, poses: Poses, i: number, size: number): void {
  const sh = Math.sin(poses.heading[i]!);
  const ch = Math.cos(poses.heading[i]!);
  const sp = Math.sin(poses.pitch[i]!);
  const cp = Math.cos(poses.pitch[i]!);
  const sr = Math.sin(poses.roll[i]!);
  const cr = Math.cos(poses.roll[i]!);
  out[at] = (ch * cr + sh * sp * sr) * size;
  out[at + 1] = -cp * sr * size;
  out[at + 2] = (sh * cr - ch * sp * sr) * size;
  out[at + 3] = 0;
  out[at + 4] = (ch * sr - sh * sp * cr) * size;
  out[at + 5] = cp * cr * size;
  out[at + 6] = (sh * sr + ch * sp * cr) * size;
  out[at + 7] = 0;
  out[at + 8] = -sh * cp * size;
  out[at + 9] = -sp * size;
  out[at + 10] = ch * cp * size;
  out[at + 11] = 0;
  out[at + 12] = poses.x[i]!;
  out[at + 13] = poses.y[i]!;
  out[at + 14] = poses.z[i]!;
  out[at + 15] = 1;
}
