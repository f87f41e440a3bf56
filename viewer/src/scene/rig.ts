// SPDX-License-Identifier: MIT
/** Where the camera stands, and how it gets from where it is to where it should be. */
import type { Vector3 } from 'three';
import type { Pose } from '../store.ts';
import { turn } from './motion.ts';

/** Looks at (x, y, z) km; `height` km of the scene fit into the picture there. */
export interface Stance {
  x: number;
  y: number;
  z: number;
  height: number;
  azimuth: number;  // rad from north, where it looks to.
  polar: number;  // rad from straight down.
  fov: number;  // rad, vertical.
}

export const kFov = 0.7;
/** So narrow that what is high stands where it is on the map. */
export const kFlatFov = 0.06;
const kLowest = 1.54;
const kSmallest = 0.05;
const kLargest = 3000;

/** s until two thirds of a way are done: for the hand on the mouse, for a change of camera, to keep up with the fight. */
export const kPace = { hand: 0.05, change: 0.18, chase: 0.3 } as const;

/** Moves `out` along its direction of view so that all points, and with `ground` that below, are in the picture. False: there are none. */
export function fit(out: Stance, points: readonly Vector3[], aspect: number, least: number, margin = 0.8, ground = true): boolean {
  const [sa, ca, sp, cp] = [Math.sin(out.azimuth), Math.cos(out.azimuth), Math.sin(out.polar), Math.cos(out.polar)];
  const tan_v = Math.tan(out.fov / 2);
  const up_reach = tan_v * margin;
  const side_reach = tan_v * aspect * margin;
  let [left, right, top, bottom] = [-Infinity, -Infinity, -Infinity, -Infinity];
  if (!points.length) return false;
  for (const { x, y, z } of points) {
    const r = x * ca + z * sa;
    for (const level of ground ? [y, 0] : [y]) {
      const u = x * sa * cp + level * sp - z * ca * cp;
      const b = -x * sa * sp + level * cp + z * ca * sp;
      // how far back the eye must stand for each edge of the picture to pass outside of the point
      right = Math.max(right, r + b * side_reach);
      left = Math.max(left, -r + b * side_reach);
      top = Math.max(top, u + b * up_reach);
      bottom = Math.max(bottom, -u + b * up_reach);
    }
  }
  const eye_r = (right - left) / 2;
  const eye_u = (top - bottom) / 2;
  const eye_b = Math.max((right + left) / (2 * side_reach), (top + bottom) / (2 * up_reach));
  const eye_y = eye_u * sp + eye_b * cp;
  const level = points.reduce((sum, { y }) => sum + y, 0) / points.length;
  const distance = Math.max((eye_y - level) / cp, least / (2 * tan_v));
  // with `least` in force the eye steps back along its line of sight, whose foot stays
  const foot_b = eye_b - (eye_y - level) / cp;
  out.x = eye_r * ca + eye_u * sa * cp - foot_b * sa * sp;
  out.y = level;
  out.z = eye_r * sa - eye_u * ca * cp + foot_b * ca * sp;
  out.height = 2 * tan_v * distance;
  return true;
}

/** km of the scene that fit into the picture's height midway between two places, so that both are in it. (dx, dy, dz): from one to the other. */
export function height_for_both({ azimuth, polar, fov }: Stance, dx: number, dy: number, dz: number, aspect: number, margin = 0.8): number {
  const [sa, ca, sp, cp] = [Math.sin(azimuth), Math.cos(azimuth), Math.sin(polar), Math.cos(polar)];
  const ahead = dx * sa - dz * ca;
  const [right, up, nearer] = [dx * ca + dz * sa, ahead * cp + dy * sp, dy * cp - ahead * sp].map(Math.abs) as [number, number, number];
  return Math.max(up, right / aspect) / margin + nearer * Math.tan(fov / 2);
}

const kPlaces = ['x', 'y', 'z'] as const;
const kAngles = ['polar', 'fov'] as const;
/** rad, and shares of a size, that nobody sees. */
const kFine = 8e-4;

export class Rig {
  /** Places of `now` and `goal` are from the anchor: what both travel with. */
  readonly anchor = { x: 0, y: 0, z: 0 };
  readonly goal: Stance;
  private readonly now: Stance;
  pace: number = kPace.change;
  /** No gliding: for those who asked their system for less motion. */
  constructor(start: Stance, private readonly still = false) {
    this.goal = { ...start };
    this.now = { ...start };
  }

  /** What is followed moved: all go along. */
  carry(x: number, y: number, z: number): void {
    Object.assign(this.anchor, { x, y, z });
  }

  /** Something else is followed: the camera stays where it is for now. */
  rebase(x: number, y: number, z: number): void {
    for (const stance of [this.now, this.goal]) {
      stance.x += this.anchor.x - x;
      stance.y += this.anchor.y - y;
      stance.z += this.anchor.z - z;
    }
    this.carry(x, y, z);
  }

  orbit(azimuth: number, polar: number): void {
    this.goal.azimuth += azimuth;
    this.goal.polar = Math.min(kLowest, Math.max(0.02, this.goal.polar + polar));
    this.pace = kPace.hand;
  }

  /** In units of the picture's height: to the right and up. */
  pan(right: number, up: number): void {
    const { goal } = this;
    const [sa, ca] = [Math.sin(goal.azimuth), Math.cos(goal.azimuth)];
    const ahead = (up * goal.height) / Math.max(0.25, Math.cos(goal.polar));
    goal.x += right * goal.height * ca + ahead * sa;
    goal.z += right * goal.height * sa - ahead * ca;
    this.pace = kPace.hand;
  }

  /** Towards the point (x, z) at the height of the middle, or the middle itself. */
  zoom(factor: number, x?: number, z?: number): void {
    const { goal } = this;
    const height = Math.min(kLargest, Math.max(kSmallest, goal.height * factor));
    const share = 1 - height / goal.height;
    if (x !== undefined && z !== undefined) {
      goal.x += (x - this.anchor.x - goal.x) * share;
      goal.z += (z - this.anchor.z - goal.z) * share;
    }
    goal.height = height;
    this.pace = kPace.hand;
  }

  /** Glides for `dt` s. True: not yet there. */
  step(dt: number): boolean {
    const { now, goal } = this;
    const share = this.still ? 1 : 1 - Math.exp(-dt / this.pace);
    const swing = turn(now.azimuth, goal.azimuth);
    const growth = Math.log(goal.height / now.height);
    let moving = Math.abs(swing) > kFine || Math.abs(growth) > kFine;
    now.azimuth += swing * share;
    const before = now.height;
    now.height *= Math.exp(growth * share);
    for (const key of kAngles) {
      const gap = goal[key] - now[key];
      if (Math.abs(gap) > kFine) moving = true;
      now[key] += gap * share;
    }
    // places go with the size, so that what is zoomed at stays where it is on screen
    const along = Math.abs(growth) > 1e-3 ? (before - now.height) / (before - goal.height) : share;
    for (const key of kPlaces) {
      const gap = goal[key] - now[key];
      if (Math.abs(gap) > goal.height * kFine) moving = true;
      now[key] += gap * along;
    }
    if (!moving || this.still) this.arrive();
    return moving && !this.still;
  }

  /** Where it will rest. */
  pose(): Pose {
    const { goal, anchor } = this;
    return [goal.x + anchor.x, goal.y + anchor.y, goal.z + anchor.z, goal.height, goal.azimuth, goal.polar];
  }

  place([x, y, z, height, azimuth, polar]: Pose): void {
    const { goal, anchor } = this;
    Object.assign(goal, {
      x: x - anchor.x, y: y - anchor.y, z: z - anchor.z, height: Math.min(kLargest, Math.max(kSmallest, height)),
      azimuth, polar: Math.min(kLowest, Math.max(0, polar)),
    });
    this.pace = kPace.change;
  }

  /** At once where it should be. */
  arrive(): void {
    Object.assign(this.now, this.goal);
  }

  stance(): Stance {
    const { now, anchor } = this;
    return { ...now, x: now.x + anchor.x, y: now.y + anchor.y, z: now.z + anchor.z };
  }
}
