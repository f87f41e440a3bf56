// SPDX-License-Identifier: MIT
/** When a player is told from outside what to do, by the story. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { told_since } from '../src/live/overruled.tsx';
import type { Run } from '../src/run/run.ts';

test('a player is told what to do from the first order to the last', () => {
  const line = (t: number, who: number, text: string, kind = 'order') => ({ t, who, text, kind });
  const run = {
    story: [
      line(1, 0, 'is told to go by tree bvr'), line(5, 0, 'is taken over by a person'), line(6, 1, 'is told: weapons tight'), line(7, 1, 'is taken over by a person'), line(8, 1, 'is handed back to tree bvr'),
      line(9, 0, 'is handed back to tree bvr'), line(11, 0, 'is taken over by a person', 'kill'),
    ],
  } as unknown as Run;
  const since = (player: number, t: number): number | null => told_since(run, player, t);
  assert.deepEqual([since(0, 4), since(0, 5), since(0, 8), since(0, 9), since(0, 20)], [null, 5, 5, null, null]);
  assert.deepEqual([since(1, 5), since(1, 20)], [null, 6]);
});
