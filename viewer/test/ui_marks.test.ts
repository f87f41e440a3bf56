// SPDX-License-Identifier: MIT
/** Which events stand on the timeline and how near, which is meant by a click, and where the keys go. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Side } from '../src/run/run.ts';
import { clusters_of, kMarks as kLooks, marks_of, neighbor, pick_cluster, type Mark, type MarkKind } from '../src/ui/marks.ts';
import { fight_of } from '../src/ui/actions.ts';
import { filtered, first_moment, moments_of } from '../src/ui/story.tsx';
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

test('marks of a lane never touch: near ones are one glyph, of what matters most, with their number', () => {
  const at = (t: number, kind: MarkKind = 'contact', side: Side = 'blue'): Mark => ({ line: 0, t, kind, side });
  const marks = [at(0), at(10), at(12, 'kill'), at(12, 'launch', 'red'), at(300), ...Array.from({ length: 30 }, (_, i) => at(560 + i)), at(600, 'home')];
  const told = (range: [number, number], width: number) => clusters_of(marks, range, width, 12).map((one) => [one.side, one.kind, one.marks.length]);
  assert.deepEqual(told([0, 600], 600), [['blue', 'kill', 3], ['blue', 'contact', 1], ['blue', 'contact', 30], ['blue', 'home', 1], ['red', 'launch', 1]]);
  assert.deepEqual(told([0, 60], 600), [['blue', 'contact', 1], ['blue', 'contact', 1], ['blue', 'kill', 1], ['red', 'launch', 1]], 'closer they part');
  for (const width of [200, 390, 1280, 3840])
    for (const range of [[0, 600], [555, 595], [0, 30]] as [number, number][]) {
      const all = clusters_of(marks, range, width, 12);
      all.forEach((one, i) => {
        assert.ok(one.x >= 6 && one.end <= width, 'whole at the ends');
        const next = all[i + 1];
        if (next?.lane === one.lane) assert.ok(one.end + 2 <= next.x - 6, `${one.end} and ${next.x} of ${width}`);
      });
    }
});

test('a click means the glyph that is near, of two that of its lane', () => {
  const clusters = clusters_of([...kMarks.slice(0, 1), { ...kMarks[0]!, side: 'red', kind: 'defend' }], [0, 1], 1000, 12);
  const kind = (x: number, part: number) => pick_cluster(clusters, 2, x, part, 12)?.kind;
  assert.deepEqual([kind(100, 0.5), kind(104, 0.9), kind(108, 0), kind(140, 0.5)], ['contact', 'defend', 'contact', undefined]);
  assert.equal(pick_cluster(clusters.slice(0, 1), 2, 100, 0.9, 12)?.kind, 'contact', 'and of one lane that of the other');
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
