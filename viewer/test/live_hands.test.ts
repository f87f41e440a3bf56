// SPDX-License-Identifier: MIT
/** What a person at the controls asks for, from keys and sticks to an order. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { next_target, order_of, pulled, steered, type Wanted } from '../src/live/hands.ts';
import type { TrackSeen } from '../src/run/run.ts';

const kWanted: Wanted = { player: 0, heading: 6.2, altitude: 7000, speed: 250, climb: null, load_factor: null, target: 0, gun: false, radar: true, pointer: false, stick: false };

test('a held key turns, climbs and speeds up with time, within what can be flown', () => {
  assert.equal(steered(kWanted, [0, 0, 0], 1), kWanted);
  const right = steered(kWanted, [1, 0, 0], 0.5);
  assert.ok(right.heading < 0.3 && right.heading > 0, 'round by north');
  assert.deepEqual([right.altitude, right.speed], [7000, 250]);
  assert.equal(steered(kWanted, [0, -1, 0], 1000).altitude, 60);
  assert.equal(steered(kWanted, [0, 0, -1], 1000).speed, 60);
  const pointed = { ...kWanted, pointer: true, climb: 0.2 };
  assert.deepEqual([steered(pointed, [0, 1, 0], 0.1).pointer, steered(pointed, [0, 1, 0], 0.1).climb], [false, null]);
  assert.equal(steered(pointed, [0, 0, 1], 0.1).pointer, true);
});

test('a stick turns the way that is flown, as hard as it is moved, and let go leaves it', () => {
  const flown = { heading: 6.2, climb: 0.1 };
  const begun = pulled({ ...kWanted, stick: true }, [0, 0, 0], flown, 0.05);
  assert.deepEqual([begun.heading, begun.climb, begun.load_factor, begun.speed], [6.2, 0.1, null, 250]);
  const half = pulled(begun, [0.3, 0.4, 1], flown, 1);
  assert.deepEqual([half.load_factor, half.climb, half.speed], [5, 0.5, 275]);
  assert.ok(half.heading > 0.2 && half.heading < 0.3, 'round by north');
  assert.deepEqual([pulled(begun, [1, 1, 0], flown, 1).load_factor, pulled(begun, [0, -1, 0], { heading: 1, climb: -1 }, 1).climb], [9, -1.5]);
  const let_go = pulled(half, [0, 0, 0], { heading: 0.1, climb: 0.3 }, 1);
  assert.deepEqual([let_go.heading, let_go.climb, let_go.load_factor], [0.1, 0.3, null]);
  assert.deepEqual(pulled(let_go, [0, 0, 0], { heading: 0.2, climb: 0.2 }, 1), let_go, 'and does not drift');
});

test('targets follow each other from the nearest on, and none but those who are known as hostile', () => {
  const track = (id: number, east: number, identity: TrackSeen['identity']): TrackSeen => ({ id, truth: 1, identity, is_target: false, place: { east, north: 0, up: 0 }, age: 0 });
  const others = [track(8, 100, 'friendly'), track(9, 500, 'unknown'), track(4, 300, 'unknown')];
  const next = (tracks: TrackSeen[]) => (now: number): number => next_target(tracks, { east: 0, north: 0 }, now);
  assert.deepEqual([0, 4, 9, 55].map(next(others)), [0, 0, 0, 0]);
  assert.deepEqual([0, 9, 7, 5].map(next([track(7, 900, 'hostile'), track(5, 700, 'hostile'), ...others])), [5, 5, 5, 7]);
});

test('an order has everything that holds, and what is done once', () => {
  assert.deepEqual(order_of(kWanted, {}), { heading: 6.2, altitude: 7000, speed: 250, target: 0, gun: false, radar: true });
  assert.deepEqual(order_of({ ...kWanted, climb: 0.123456, target: 4 }, { shoot: true }), { heading: 6.2, speed: 250, climb: 0.1235, target: 4, gun: false, radar: true, shoot: true });
  assert.equal(order_of({ ...kWanted, climb: 0, load_factor: 4.5 }, {})['load_factor'], 4.5);
});
