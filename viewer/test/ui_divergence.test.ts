// SPDX-License-Identifier: MIT
/** Where two runs part. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Run } from '../src/run/run.ts';
import { first_difference, first_other_line, type Divergence } from '../src/ui/compare.tsx';
import { kBreaks, kPursues, kStory, told_run } from './ui_run.ts';

function between(a: Run, b: Run): Divergence | null {
  return first_difference({ run: a, player: a.players[0]! }, { run: b, player: b.players[0]! });
}

test('the same run does not part from itself', () => {
  assert.equal(between(told_run([kPursues, kBreaks]), told_run([kPursues, kBreaks])), null);
});

test('another leader is named with its vote', () => {
  const parted = between(told_run([kPursues, kPursues, kBreaks]), told_run([kPursues, kBreaks, kBreaks]));
  assert.deepEqual(parted, { t: 0.1, step: 5, words: 'pursue with 40 leads, in B break with 70' });
});

test('another value of the action counts, though who leads is the same', () => {
  const turned = { ...kPursues, pursue: { vote: 40, heading: 1.5 } };
  const parted = between(told_run([kPursues, kPursues]), told_run([kPursues, turned]));
  assert.equal(parted?.step, 5);
  assert.equal(parted?.words, 'heading 057°, in B 086°');
});

test('a value of somebody who lost does not count', () => {
  assert.equal(between(told_run([kPursues]), told_run([{ ...kPursues, navigate: { vote: 10, heading: 0.5 } }])), null);
});

test('the same word may have another number in another run', () => {
  const holds = told_run([{ ...kPursues, pursue: { vote: 40, heading: 1, mode: 0 } }]);
  const also_holds = told_run([{ ...kPursues, pursue: { vote: 40, heading: 1, mode: 1 } }]);
  assert.equal(between(holds, also_holds)?.words, 'mode hold, in B follow');
  assert.equal(between(holds, { ...also_holds, texts: ['follow', 'hold'] }), null);
});

test('one goes on after the other has ended', () => {
  const parted = between(told_run([kPursues]), told_run([kPursues, kPursues]));
  assert.deepEqual([parted?.step, parted?.words], [5, 'only in B does it go on deciding']);
});

test('the first story line that only one run has is found in either', () => {
  const whole = told_run([kPursues]);
  const less = told_run([kPursues], kStory.filter((_, i) => i !== 2));
  assert.equal(first_other_line(whole, whole), null);
  assert.deepEqual(first_other_line(whole, less), { of: 0, line: 2 });
  assert.deepEqual(first_other_line(less, whole), { of: 1, line: 2 });
});

test('lines of one moment may stand in another order', () => {
  const [a, b] = [{ ...kStory[0]!, t: 1 }, { ...kStory[1]!, t: 1 }];
  assert.equal(first_other_line(told_run([kPursues], [a, b]), told_run([kPursues], [b, a])), null);
});
