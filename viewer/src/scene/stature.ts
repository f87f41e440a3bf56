// SPDX-License-Identifier: MIT
/** How large everybody is drawn, and how turned: never smaller on screen than can be read. */
import { Euler, Matrix4, Vector3 } from 'three';
import type { Eye } from './eye.ts';
import { kCrowd } from './frame.ts';
import type { Poses } from './motion.ts';
import type { ShapeName } from './shapes.ts';

/** Least length on screen, CSS px. */
const kLeast: Record<ShapeName, number> = { eagle: 30, fulcrum: 28, fighter: 27, truck: 14, missile: 13 };
const kCrowded = 0.72;

/** Scene units for each m of a model so many km long. */
export function size_of(name: ShapeName, length: number, poses: Poses, i: number, eye: Eye): number {
  const least = kLeast[name] * eye.ui * (poses.count > kCrowd ? kCrowded : 1);
  return 0.001 * Math.max(1, (least * eye.km_per_px(poses.x[i]!, poses.y[i]!, poses.z[i]!)) / length);
}

const [matrix, angles, scale] = [new Matrix4(), new Euler(0, 0, 0, 'YXZ'), new Vector3()];

/** The turn by roll, then pitch, then heading, times `size`; then the place. The next call changes it. */
export function matrix_of(poses: Poses, i: number, size: number): Matrix4 {
  angles.set(poses.pitch[i]!, -poses.heading[i]!, -poses.roll[i]!);
  return matrix.makeRotationFromEuler(angles).scale(scale.setScalar(size)).setPosition(poses.x[i]!, poses.y[i]!, poses.z[i]!);
}
