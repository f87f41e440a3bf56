// SPDX-License-Identifier: MIT
/** Where things are between samples. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import type { Motion } from '../src/run/run.ts';
import { climb_at, gauge_at, is_shown, new_pose, place_at, pose_at, turn, Poses } from '../src/scene/motion.ts';

function motion_of(times: number[], at: (t: number) => Partial<Record<Exclude<keyof Motion, 't'>, number>>): Motion {
  const column = (key: Exclude<keyof Motion, 't'>) => Float64Array.from(times, (t) => at(t)[key] ?? 0);
  return {
    t: Float64Array.from(times), east: column('east'), north: column('north'), up: column('up'),
    heading: column('heading'), pitch: column('pitch'), roll: column('roll'),
  };
}

const near = (a: number, b: number, by = 1e-9): void => assert.ok(Math.abs(a - b) <= by, `${a} is not within ${by} of ${b}`);
const full = 2 * Math.PI;

test('a turn is the short way round', () => {
  near(turn(0.1, 0.3), 0.2);
  near(turn(full - 0.1, 0.1), 0.2);
  near(turn(0.1, full - 0.1), -0.2);
  near(Math.abs(turn(0, Math.PI)), Math.PI);
});

test('a straight line stays straight whatever the spacing of samples', () => {
  const motion = motion_of([0, 1, 1.5, 4, 9], (t) => ({ east: 250 * t, north: -10 * t, up: 7000 + 3 * t }));
  const pose = new_pose();
  for (const t of [0, 0.3, 1, 1.2, 2.7, 5, 8.99, 9]) {
    assert.ok(place_at(motion, t, pose));
    near(pose.east, 250 * t, 1e-9);
    near(pose.north, -10 * t, 1e-9);
    near(pose.up, 7000 + 3 * t, 1e-9);
  }
  near(climb_at(motion, 3), 3);
});

test('a circle flown at one sample a second is followed within a meter', () => {
  const [radius, rate] = [1500, 0.17];
  const times = Array.from({ length: 40 }, (_, i) => i);
  const motion = motion_of(times, (t) =>
    ({ east: radius * Math.sin(rate * t), north: radius * Math.cos(rate * t), heading: (rate * t + 1.57) % full }));
  const pose = new_pose();
  for (let t = 2; t < 37; t += 0.13) {
    pose_at(motion, t, pose);
    near(pose.east, radius * Math.sin(rate * t), 1);
    near(pose.north, radius * Math.cos(rate * t), 1);
    near(turn(pose.heading, rate * t + 1.57), 0, 1e-9);
  }
});

test('heading goes through north and stays in its range', () => {
  const motion = motion_of([0, 1], (t) => ({ heading: t === 0 ? full - 0.2 : 0.2, roll: t === 0 ? -3 : 3 }));
  const pose = new_pose();
  pose_at(motion, 0.25, pose);
  near(pose.heading, full - 0.1);
  pose_at(motion, 0.75, pose);
  near(pose.heading, 0.1);
  // through inverted flight, not back through level
  assert.ok(Math.abs(pose.roll) > 3);
});

test('before the first and after the last sample it stands there', () => {
  const motion = motion_of([5, 6, 7], (t) => ({ east: 100 * t }));
  const pose = new_pose();
  assert.ok(place_at(motion, 1, pose));
  near(pose.east, 500);
  assert.ok(place_at(motion, 99, pose));
  near(pose.east, 700);
  assert.equal(place_at(motion_of([], () => ({})), 0, pose), false);
});

test('a single sample is enough', () => {
  const pose = new_pose();
  assert.ok(pose_at(motion_of([3], () => ({ east: 7, heading: 1 })), 3.5, pose));
  near(pose.east, 7);
  near(pose.heading, 1);
});

test('gauges are linear between samples', () => {
  const motion = motion_of([0, 2, 4], () => ({}));
  near(gauge_at(motion, Float64Array.of(100, 200, 100), 1), 150);
  near(gauge_at(motion, Float64Array.of(100, 200, 100), 10), 100);
  assert.ok(Number.isNaN(gauge_at(motion, new Float64Array(), 1)));
});

test('nobody is seen before birth or after its end', () => {
  const motion = motion_of([5, 6, 7], (t) => ({ east: 1000 * t, north: 2000, up: 3000 }));
  const lost = { born: 5, gone: 7, end: 'lost' as const, motion };
  assert.equal(is_shown(lost, 4.9), false);
  assert.equal(is_shown(lost, 5), true);
  assert.equal(is_shown(lost, 7), false);
  // the run ended, not the flight
  assert.equal(is_shown({ ...lost, end: '' }, 7), true);
  assert.equal(is_shown({ ...lost, end: 'flying' }, 7), true);
});

test('poses are in kilometers with z south and keep the last place of the lost', () => {
  const motion = motion_of([5, 6, 7], (t) => ({ east: 1000 * t, north: 2000, up: 3000 }));
  const poses = new Poses([{ born: 5, gone: 7, end: 'lost' as const, motion }]);
  poses.update(6);
  assert.deepEqual([poses.shown[0], poses.noted[0], poses.x[0], poses.y[0], poses.z[0]], [1, 1, 6, 3, -2]);
  assert.deepEqual(poses.spots(), [new Vector3(6, 3, -2)]);
  poses.update(8);
  assert.deepEqual([poses.shown[0], poses.noted[0], poses.x[0]], [0, 1, 7]);
  poses.update(60);
  assert.deepEqual([poses.shown[0], poses.noted[0]], [0, 0]);
  assert.deepEqual(poses.spots(), [], 'who is long gone does not count');
  poses.update(1);
  assert.deepEqual([poses.shown[0], poses.noted[0]], [0, 0]);
});
