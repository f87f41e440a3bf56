// SPDX-License-Identifier: MIT
/** Of a long story the part around the present stands in the list. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stretch_of } from '../src/ui/story.tsx';

const fresh = { first: 0, last: 240 };

test('a short story is all there', () => {
  for (const total of [0, 1, 100, 240]) {
    const all = stretch_of(-1, total, fresh);
    assert.deepEqual(all, { first: 0, last: total });
    for (let at = -1; at < total; ++at) assert.equal(stretch_of(at, total, all), all, `${at} of ${total}`);
  }
});

test('a long one moves on with the present, seldom, and never without it', () => {
  const total = 5000;
  let now = fresh;
  let moves = 0;
  const follow = (at: number): void => {
    const next = stretch_of(at, total, now);
    if (next !== now) ++moves;
    now = next;
    assert.ok(now.first >= 0 && now.last <= total && now.last - now.first === 240, `${now.first} to ${now.last}`);
    if (at >= 0) assert.ok(at >= now.first && at < now.last, `${at} is not in ${now.first} to ${now.last}`);
  };
  for (let at = -1; at < total; ++at) follow(at);
  assert.ok(moves < total / 50, `${moves} moves`);
  for (const at of [0, 4999, 2500, 2600, 17, -1]) follow(at);
});

test('what was opened by hand stays until the present leaves it', () => {
  const wide = { first: 1000, last: 1480 };
  assert.equal(stretch_of(1200, 5000, wide), wide);
  assert.deepEqual(stretch_of(4000, 5000, wide), { first: 3880, last: 4120 });
});

test('another filter leaves fewer lines than were shown', () => {
  assert.deepEqual(stretch_of(10, 30, { first: 1000, last: 1240 }), { first: 0, last: 30 });
  assert.deepEqual(stretch_of(250, 300, { first: 1000, last: 1240 }), { first: 60, last: 300 });
});
