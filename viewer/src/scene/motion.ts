// SPDX-License-Identifier: MIT
/** Where something is between the samples of its motion, and where everybody is at one time. */
import { MathUtils, Vector3 } from 'three';
import { last_at, type Missile, type Motion, type Place, type Player } from '../run/run.ts';

export interface Pose extends Place {
  heading: number;  // rad, as in Motion.
  pitch: number;
  roll: number;
}

/** A thing with a life: a player or a missile. */
export type Mover = Pick<Player | Missile, 'born' | 'gone' | 'end' | 'motion'>;

export function new_pose(): Pose {
  return { east: 0, north: 0, up: 0, heading: 0, pitch: 0, roll: 0 };
}

/** The angle from `a` to `b` the short way round, rad in [-pi, pi). */
export function turn(a: number, b: number): number {
  return wrapped(b - a + Math.PI) - Math.PI;
}
/** The same direction in [0, 2 pi). */
export function wrapped(angle: number): number {
  return MathUtils.euclideanModulo(angle, 2 * Math.PI);
}

/** Whether it is there to be seen. What is only cut off by the end of the run is still seen then. */
export function is_shown(mover: Mover, t: number): boolean {
  if (t < mover.born) return false;
  return t < mover.gone || (t === mover.gone && (mover.end === '' || mover.end === 'flying'));
}

/** d(values)/dt at sample `i`: the slope of the parabola through it and its neighbours. */
function slope(t: Float64Array, values: Float64Array, i: number): number {
  const last = t.length - 1;
  if (last === 0) return 0;
  if (i === 0) return (values[1]! - values[0]!) / (t[1]! - t[0]! || 1);
  const before = t[i]! - t[i - 1]!;
  const rise = (values[i]! - values[i - 1]!) / (before || 1);
  if (i === last) return rise;
  const after = t[i + 1]! - t[i]!;
  const next = (values[i + 1]! - values[i]!) / (after || 1);
  return (rise * after + next * before) / (before + after || 1);
}

/** Cubic Hermite between samples `i` and `i + 1`, at the share `u` of the way. */
function hermite(t: Float64Array, values: Float64Array, i: number, u: number): number {
  const span = t[i + 1]! - t[i]!;
  const v = 1 - u;
  return values[i]! * (1 + 2 * u) * v * v + values[i + 1]! * (3 - 2 * u) * u * u
    + span * u * v * (slope(t, values, i) * v - slope(t, values, i + 1) * u);
}

function angle(values: Float64Array, i: number, u: number): number {
  const a = values[i]!;
  return u > 0 ? a + turn(a, values[i + 1]!) * u : a;
}

/** The sample not after `t` within the motion, and how far `t` is on the way to the next (0 at the ends). */
const found = { i: 0, u: 0 };
function find(motion: Motion, t: number): boolean {
  const times = motion.t;
  const i = Math.max(0, last_at(times, t));
  const span = i + 1 < times.length ? times[i + 1]! - times[i]! : 0;
  found.i = i;
  found.u = span > 0 ? Math.min(1, Math.max(0, (t - times[i]!) / span)) : 0;
  return times.length > 0;
}

const kAxes = ['east', 'north', 'up'] as const;
function locate(motion: Motion, out: Place): void {
  const { i, u } = found;
  for (const axis of kAxes) out[axis] = u > 0 ? hermite(motion.t, motion[axis], i, u) : motion[axis][i]!;
}

/** The place at `t`; before the first and after the last sample, those. False: it has none. */
export function place_at(motion: Motion, t: number, out: Place): boolean {
  if (!find(motion, t)) return false;
  locate(motion, out);
  return true;
}

/** As place_at, with the attitude. */
export function pose_at(motion: Motion, t: number, out: Pose): boolean {
  if (!find(motion, t)) return false;
  locate(motion, out);
  const { i, u } = found;
  out.heading = wrapped(angle(motion.heading, i, u));
  out.pitch = angle(motion.pitch, i, u);
  out.roll = angle(motion.roll, i, u);
  return true;
}

/** m/s upward at `t`. */
export function climb_at(motion: Motion, t: number): number {
  if (!find(motion, t)) return 0;
  const { i, u } = found;
  const here = slope(motion.t, motion.up, i);
  return u > 0 ? here + (slope(motion.t, motion.up, i + 1) - here) * u : here;
}

/** A gauge at `t`, linear between the samples. */
export function gauge_at(motion: Motion, gauge: Float64Array, t: number): number {
  if (!find(motion, t) || gauge.length === 0) return NaN;
  const { i, u } = found;
  return u > 0 ? gauge[i]! + (gauge[i + 1]! - gauge[i]!) * u : gauge[i]!;
}

/** s */
const kMourned = 10;

/** In the scene, km. */
export const spot_of = ({ east, north, up }: Place): Vector3 => new Vector3(east / 1000, up / 1000, -north / 1000);

/** Of a long way, one of so many samples and the last say where it went. */
const kSeldom = 16;

export class Poses {
  shown: Uint8Array = new Uint8Array(0);
  noted: Uint8Array = new Uint8Array(0);  // Shown, or lost so lately that one still wants to see where.
  x: Float64Array = new Float64Array(0);
  y: Float64Array = new Float64Array(0);
  z: Float64Array = new Float64Array(0);
  heading: Float64Array = new Float64Array(0);
  pitch: Float64Array = new Float64Array(0);
  roll: Float64Array = new Float64Array(0);
  private time = NaN;
  private readonly pose = new_pose();

  /** There may be more of them later. */
  constructor(private readonly movers: readonly Mover[]) {}

  private grow(): void {
    const array = (): Float64Array => new Float64Array(this.movers.length);
    this.shown = new Uint8Array(this.movers.length);
    this.noted = new Uint8Array(this.movers.length);
    [this.x, this.y, this.z, this.heading, this.pitch, this.roll] = [array(), array(), array(), array(), array(), array()];
    this.time = NaN;
  }

  get count(): number {
    return this.movers.length;
  }

  /** Places on the ways of all. */
  ways(): Vector3[] {
    return this.movers.flatMap(({ motion: { east, north, up } }) => [...east.keys()].filter((i) => i % kSeldom === 0 || i === east.length - 1)
      .map((i) => spot_of({ east: east[i]!, north: north[i]!, up: up[i]! })));
  }
  /** Where those are who are noted. */
  spots(): Vector3[] {
    return [...this.noted.keys()].filter((i) => this.noted[i]).map((i) => new Vector3(this.x[i], this.y[i], this.z[i]));
  }

  /** Of those who are not there (yet, or any more) the first or the last place remains. */
  update(t: number): void {
    if (this.movers.length > this.shown.length) this.grow();
    if (t === this.time) return;
    this.time = t;
    const { pose } = this;
    for (let i = 0; i < this.movers.length; ++i) {
      const mover = this.movers[i]!;
      const known = pose_at(mover.motion, Math.min(t, mover.gone), pose);
      this.shown[i] = known && is_shown(mover, t) ? 1 : 0;
      this.noted[i] = known && t >= mover.born && (this.shown[i] || (mover.end === 'lost' && t < mover.gone + kMourned)) ? 1 : 0;
      if (!known) continue;
      this.x[i] = pose.east / 1000;
      this.y[i] = pose.up / 1000;
      this.z[i] = -pose.north / 1000;
      this.heading[i] = pose.heading;
      this.pitch[i] = pose.pitch;
      this.roll[i] = pose.roll;
    }
  }
}
