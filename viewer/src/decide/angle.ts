// SPDX-License-Identifier: MIT
/** Angles, rad: src/core/angle.hpp. */

export const kTau = 2 * Math.PI;

/** The same direction in (-pi, pi]. */
export function wrap_pi(x: number): number {
  if (x > -Math.PI && x <= Math.PI) return x;
  const turned = x - kTau * Math.ceil((x - Math.PI) / kTau);
  return turned <= -Math.PI || turned > Math.PI ? Math.PI : turned;
}

/** The same direction in [0, 2 pi). */
export function wrap_tau(x: number): number {
  if (x >= 0 && x < kTau) return x;
  const turned = x - kTau * Math.floor(x / kTau);
  return turned < 0 || turned >= kTau ? 0 : turned;
}

/** The shortest turn from one heading to another, in (-pi, pi]; positive is clockwise. */
export function angle_between(from: number, to: number): number {
  return wrap_pi(to - from);
}
