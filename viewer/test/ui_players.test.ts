// SPDX-License-Identifier: MIT
/** What stands above the players of a flight. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Flight, Run } from '../src/run/run.ts';
import { types_text } from '../src/ui/players.tsx';

test('a flight says how many it has of each type, of the most first', () => {
  const run = { players: ['Su-27SM', 'F-15C', 'F-15C', 'F-16C'].map((type) => ({ type })) } as Run;
  const said = (...members: number[]): string => types_text(run, { members } as Flight);
  assert.deepEqual([said(1, 2), said(0, 1, 2), said(3)], ['2 × F-15C', '2 × F-15C, 1 × Su-27SM', '1 × F-16C']);
});
