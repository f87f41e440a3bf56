// SPDX-License-Identifier: MIT
/** Where a proposal that lost would have led. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Gauges, Motion } from '../src/run/run.ts';
import { ghost_path, turn_rate } from '../src/scene/ghost.ts';
import { turn } from '../src/scene/motion.ts';
import type { Ghost } from '../src/store.ts';

const near = (a: number, b: number, by: number): void => assert.ok(Math.abs(a - b) <= by, `${a} is not within ${by} of ${b}`);

/** East at 250 m/s and 8000 m for two minutes. */
function level_flight(): { motion: Motion; gauges: Gauges; kind: 'aircraft' } {
  const t = Float64Array.from({ length: 121 }, (_, i) => i);
  const same = (value: number) => new Float64Array(t.length).fill(value);
  return {
    kind: 'aircraft',
    motion: { t, east: t.map((s) => 250 * s), north: same(0), up: same(8000), heading: same(Math.PI / 2), pitch: same(0), roll: same(0) },
    gauges: { speed: same(250), mach: same(0.8), load_factor: same(1), fuel: same(3000) },
  };
}
const ghost = (patch: Partial<Ghost>): Ghost => ({ player: 0, t: 10, heading: null, altitude: null, speed: null, label: '', ...patch });

test('the rate of turn is that of a level turn', () => {
  near(turn_rate(250, 4), 0.1519, 1e-4);
  near(turn_rate(125, 4), 2 * turn_rate(250, 4), 1e-12);
});

test('with nothing asked for it is what was flown', () => {
  const path = ghost_path(level_flight(), ghost({}));
  assert.equal(path.length, 61);
  for (const point of path) {
    near(point.east, 250 * point.t, 1e-6);
    near(point.north, 0, 1e-6);
    near(point.up, 8000, 1e-9);
  }
});

test('it turns the short way at a plausible rate and then flies straight', () => {
  const path = ghost_path(level_flight(), ghost({ heading: 0 }));
  const last = path.at(-1)!;
  near(turn(last.heading, 0), 0, 1e-9);
  assert.ok(last.north > 0, 'to the left, which is north');
  let most = 0;
  for (let i = 1; i < path.length; ++i) most = Math.max(most, Math.abs(turn(path[i - 1]!.heading, path[i]!.heading)) / 0.5);
  near(most, turn_rate(250, 4), 1e-9);
  // a quarter of a circle takes as long as it should, and the time to roll into it
  const done = path.find((point) => Math.abs(turn(point.heading, 0)) < 1e-6)!;
  near(done.t - 10, Math.PI / 2 / turn_rate(250, 4), 1.5);
  // it moves at its speed
  const [a, b] = [path.at(-2)!, last];
  near(Math.hypot(b.east - a.east, b.north - a.north), 125, 0.1);
});

test('a half turn ends where the radius says', () => {
  const path = ghost_path(level_flight(), ghost({ heading: (3 * Math.PI) / 2 - 0.01 }), 60, 0.05);
  const radius = 250 / turn_rate(250, 4);
  const last = path.at(-1)!;
  near(Math.abs(last.north), 2 * radius, 0.1 * radius);
});

test('it climbs towards the altitude and levels off', () => {
  const path = ghost_path(level_flight(), ghost({ altitude: 9000 }), 60);
  near(path.at(-1)!.up, 9000, 15);
  let before = 8000;
  for (const point of path) {
    assert.ok(point.up >= before - 1 && point.up < 9050);
    assert.ok(point.up - before <= 250 * Math.sin(0.35) * 0.5 + 1e-9, 'not steeper than a fighter climbs');
    before = point.up;
  }
});

test('it does not dive into the ground', () => {
  const path = ghost_path(level_flight(), ghost({ altitude: -500 }), 120);
  assert.ok(path.every((point) => point.up >= 0));
});

test('it speeds up no faster than an engine can', () => {
  const path = ghost_path(level_flight(), ghost({ speed: 400 }));
  const [a, b] = [path.at(-2)!, path.at(-1)!];
  near(Math.hypot(b.east - a.east, b.north - a.north) / 0.5, 250 + 4 * 30, 0.5);
});

test('it begins where the player was', () => {
  const [first] = ghost_path(level_flight(), ghost({ t: 33.3, heading: 1 }));
  assert.ok(first);
  near(first.east, 250 * 33.3, 1e-6);
  near(first.t, 33.3, 0);
});
