// SPDX-License-Identifier: MIT
/** Where a proposal that lost would have led: a point that turns, climbs and speeds up as a fighter plausibly does. */
import { MathUtils } from 'three';
import type { Place, Player } from '../run/run.ts';
import type { Ghost } from '../store.ts';
import { climb_at, gauge_at, new_pose, pose_at, turn } from './motion.ts';

const { clamp } = MathUtils;
const kGravity = 9.80665;
/** Load factor of the turn, and how long it takes to roll into it (s). */
const kLoad = 4;
const kRollTime = 1;
/** Steepest flight paths (rad), and how soon the climb goes for the altitude (s) and with which acceleration (m/s2). */
const kSteepestClimb = 0.35;
const kSteepestDive = 0.5;
const kLevelTime = 4;
const kPull = 2 * kGravity;
/** m/s2 along the path. */
const kAccelerate = 4;
const kBrake = 6;
/** Slower than this (m/s) nothing of this flies; vehicles keep their own speed. */
const kSlowest = 60;

export interface GhostPoint extends Place {
  t: number;
  heading: number;
}

/** rad/s of a level turn at a load factor `n`: Anderson, Aircraft Performance and Design, eq. 6.11. */
export function turn_rate(speed: number, n: number): number {
  return (kGravity * Math.sqrt(n * n - 1)) / speed;
}

/**
 * From the player's place at ghost.t, a point each `step` s for `span` s. What the ghost leaves open (null) is as flown.
 * Its heading counts from the map's north here.
 */
export function ghost_path(player: Pick<Player, 'motion' | 'gauges' | 'kind'>, ghost: Ghost, span = 30, step = 0.5): GhostPoint[] {
  const { motion, gauges } = player;
  const flown = new_pose();
  if (!pose_at(motion, ghost.t, flown)) return [];
  const now = { t: ghost.t, ...flown };
  const slowest = player.kind === 'vehicle' ? 1 : kSlowest;
  const speed_flown = (t: number): number => Math.max(slowest, gauge_at(motion, gauges.speed, t) || slowest);
  let speed = speed_flown(ghost.t);
  let climb = climb_at(motion, ghost.t);
  const path: GhostPoint[] = [{ t: now.t, east: now.east, north: now.north, up: now.up, heading: now.heading }];
  for (let k = 1; k * step <= span + 1e-9; ++k) {
    const since = k * step;
    now.t = ghost.t + since;
    pose_at(motion, now.t, flown);

    speed = ghost.speed === null ? speed_flown(now.t) : clamp(Math.max(slowest, ghost.speed), speed - kBrake * step, speed + kAccelerate * step);

    const before = now.heading;
    if (ghost.heading === null) {
      now.heading = flown.heading;
    } else {
      const most = turn_rate(speed, kLoad) * Math.min(1, since / kRollTime) * step;
      now.heading += clamp(turn(now.heading, ghost.heading), -most, most);
    }

    if (ghost.altitude === null) {
      now.up = flown.up;
      climb = climb_at(motion, now.t);
    } else {
      const wanted = clamp((ghost.altitude - now.up) / kLevelTime, -speed * Math.sin(kSteepestDive), speed * Math.sin(kSteepestClimb));
      climb = clamp(wanted, climb - kPull * step, climb + kPull * step);
      now.up = Math.max(0, now.up + climb * step);
    }

    const course = before + turn(before, now.heading) / 2;
    const level = Math.sqrt(Math.max(0, speed * speed - climb * climb)) * step;
    now.east += level * Math.sin(course);
    now.north += level * Math.cos(course);
    path.push({ t: now.t, east: now.east, north: now.north, up: now.up, heading: now.heading });
  }
  return path;
}
