// SPDX-License-Identifier: MIT
/** Which events stand on the timeline, which is meant by a click, and where the keys go. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kMarks as kLooks, marks_of, neighbor, pick_mark } from '../src/ui/marks.ts';
import { fight_of } from '../src/ui/actions.ts';
import { first_moment, moments_of } from '../src/ui/moments.tsx';
import { filtered } from '../src/ui/story.tsx';
import { kPursues, kStory, page_of, told_run } from './ui_run.ts';

const kRun = told_run([kPursues]);
const kMarks = marks_of(kRun);

test('events that matter have a mark on the lane of their side', () => {
  assert.deepEqual(kMarks.map((m) => [m.line, m.kind, m.side]), [
    [0, 'contact', 'blue'], [1, 'launch', 'blue'], [3, 'defend', 'red'], [4, 'kill', 'blue'],
  ]);
});

test('every kind of mark looks different', () => {
  const paths = Object.values(kLooks).map((glyph) => glyph.path);
  assert.equal(new Set(paths).size, paths.length);
});

test('a click means the nearest event, of near ones the one that matters more', () => {
  assert.equal(pick_mark(kMarks, 0.12, 0.05)?.kind, 'contact');
  assert.equal(pick_mark(kMarks, 0.345, 0.2)?.kind, 'kill');
  assert.equal(pick_mark(kMarks, 0.9, 0.2), null);
});

test('keys go to the next time in either direction, and nowhere at the end', () => {
  assert.equal(neighbor([3, 1, 2], 1, 1), 2);
  assert.equal(neighbor([3, 1, 2], 3, -1), 2);
  assert.equal(neighbor([3, 1, 2], 3, 1), null);
  assert.equal(neighbor([3, 1, 2], 1.995, 1), 3);
});

test('the story is filtered by who did it or to whom, by kind and by words', () => {
  assert.deepEqual(filtered(kRun, { who: -1, kind: '', text: '' }), [0, 1, 2, 3, 4]);
  assert.deepEqual(filtered(kRun, { who: 1, kind: '', text: '' }), [1, 2, 3, 4]);
  assert.deepEqual(filtered(kRun, { who: -1, kind: 'kill', text: '' }), [4]);
  assert.deepEqual(filtered(kRun, { who: 0, kind: '', text: ' FOX ' }), [1]);
});

test('the key moments are the first shot, who was lost, leads and phases, and the page opens at the shot', () => {
  const line = (t: number, kind: string, decider: number) => ({ ...kStory[0]!, t, kind, decider });
  const story = [line(0, 'phase', 0), line(2, 'phase', 0), line(3, 'launch', 0), line(4, 'launch', 1), line(5, 'kill', 1), line(6, 'lead_change', 0)];
  const run = told_run([kPursues], story);
  assert.deepEqual(moments_of(run).map((m) => [m.line, m.title]),
    [[1, 'A phase begins'], [2, 'First shot'], [4, 'Why did bogey1 die?'], [5, 'The lead changes']]);
  assert.equal(first_moment(run), 2);
  assert.deepEqual(fight_of(page_of(run)), [-57, 65]);
  assert.equal(fight_of(page_of(told_run([kPursues], []))), null);
  assert.equal(first_moment(told_run([kPursues], story.filter(({ kind }) => kind !== 'launch'))), 2);
  assert.equal(first_moment(told_run([kPursues], [])), -1);
  const many = moments_of(told_run([kPursues], [...Array.from({ length: 99 }, (_, i) => line(2 + i, 'phase', 0)), line(200, 'kill', 1)]));
  assert.ok(many.length < 20 && many.at(-1)!.line === 99, 'of many those that matter most');
});
