// SPDX-License-Identifier: MIT
/** What is made once. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { made } from '../src/made.ts';

test('what is asked for is made the first time, null too', () => {
  const map = new Map<string, string | null>();
  assert.equal(made(map, 'a', () => 'one'), 'one');
  assert.equal(made(map, 'a', () => 'two'), 'one');
  assert.equal(made(map, 'b', () => null), null);
  assert.equal(made(map, 'b', () => 'three'), null);
});
