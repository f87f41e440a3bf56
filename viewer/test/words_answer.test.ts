// SPDX-License-Identifier: MIT
/** What nodes answered, in words. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answer_words, path_of_leader } from '../src/words/answer.ts';
import { find, leaf, node, run_of } from './words_run.ts';

const kTree = node('root', 'per_field', [
  node('survive', 'winner_takes_all', [leaf('avoid'), leaf('break')]), leaf('release'), leaf('follow'), leaf('hostile_track'),
]);

test('answers are told in words', () => {
  const run = run_of(kTree, [{ avoid: { status: 'failure' }, break: { status: 'failure' }, release: { vote: 60, target: 2 }, hostile_track: { status: 'success' } }]);
  const shape = run.shapes[0]!;
  shape.why[find(run, 'avoid')] = 'the ground is far';
  const told = (label: string) => answer_words(shape, find(run, label));
  assert.deepEqual(['release', 'follow', 'break', 'avoid', 'hostile_track'].map(told),
    ['running, votes 60', 'not asked', 'failed', 'failed: the ground is far', 'success']);
});

test('the way from the leader goes up to the root', () => {
  const run = run_of(kTree, [{ break: { vote: 15, heading: 3 }, avoid: { status: 'failure' } }, { root: { status: 'failure' } }]);
  assert.deepEqual(path_of_leader(run, run.shapes[0]!), new Set([find(run, 'break'), find(run, 'survive'), 0]));
  assert.deepEqual(path_of_leader(run, run.shapes[1]!), new Set());
});
