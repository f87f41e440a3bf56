// SPDX-License-Identifier: MIT
/** What strips and trees draw. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resample } from '../src/ui/series.ts';
import { fill_of, leader_spans, spans_of } from '../src/ui/spans.ts';
import { layout_tree } from '../src/ui/tree_view.tsx';
import { command_of, sets_of, ask } from '../src/ui/what_if_answer.ts';
import { kBreaks, kPursues, page_of, told_run } from './ui_run.ts';

const kRun = told_run([kPursues, kPursues, kBreaks, kPursues]);
const [kEagle] = kRun.players;

test('spans are whoever led in a row, to where the player left', () => {
  assert.deepEqual(leader_spans(kRun, kEagle!).map((s) => [s.label, s.first, s.end, s.from, s.to]), [
    ['pursue', 0, 2, 0, 0.2], ['break', 2, 3, 0.2, 0.3], ['pursue', 3, 4, 0.3, 0.4],
  ]);
  assert.deepEqual(spans_of(kRun, kEagle!, (i) => (i < 2 ? -2 : -1)).map((s) => s.label), ['unknown', 'nobody']);
});

test('a behavior has its colour by its name, no two that come with Eyrie the same, and black words can be read on it', () => {
  const names = ['navigate', 'follow_lead', 'pursue', 'release_weapon', 'shoot_gun', 'break_turn', 'egress', 'avoid_ground', 'lead_pursuit',
    'pure_pursuit', 'lag_pursuit', 'high_yo_yo', 'low_yo_yo', 'merge_turn', 'reacquire', 'jink', 'extend', 'snapshot', 'avoid_collision',
    'crank', 'notch', 'drag', 'last_ditch'];
  assert.equal(new Set(names.map(fill_of)).size, names.length);
  const light = (fill: string): number => [1, 3, 5].map((i) => parseInt(fill.slice(i, i + 2), 16) / 255)
    .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i]!, 0);
  for (const name of names) assert.ok((light(fill_of(name)) + 0.05) / (light('#10161c') + 0.05) > 4.5, name);
  assert.equal(fill_of('nobody'), fill_of('unknown'));
});

test('series are read between their samples, and not beyond them', () => {
  const series = { t: Float64Array.of(1, 2, 3, 20), v: Float64Array.of(10, 20, NaN, 40) };
  assert.deepEqual(resample(series, [0, 1, 1.5, 2, 2.5, 3.5, 20, 21], false, 20.5), [null, 10, 15, 20, 20, null, 40, null]);
  assert.deepEqual(resample(series, [1.9, 2.1, 19], true, 20), [10, 20, null]);
});

test('of a tree what is not open is counted, and rows do not overlap', () => {
  const tree = kRun.trees[0]!;
  const open = layout_tree(tree, () => true, () => 100);
  assert.equal(open.placed.length, 4);
  const rows = open.placed.filter((p) => p.node > 0).map((p) => p.y);
  assert.ok(rows.every((y, i) => i === 0 || y - rows[i - 1]! >= 17));
  const closed = layout_tree(tree, () => false, () => 100);
  assert.deepEqual(closed.placed.map((p) => [p.node, p.hidden, p.link]), [[0, 3, '']]);
});

test('questions add up node by node, and what is as flown is asked no more', () => {
  const { run, changes } = page_of(kRun);
  ask(changes, { tree: 0, node: 1, params: { vote: '30' } });
  ask(changes, { tree: 0, node: 0, type: 'fusion', params: { top: '2' } });
  assert.deepEqual(sets_of(run, 0, changes.get()), ['root/break.vote=30', 'root=fusion', 'root.top=2']);
  assert.equal(command_of(run, 0, changes.get()),
    "eyrie whatif RUN --player eagle2 --set 'root/break.vote=30' --set 'root=fusion' --set 'root.top=2'");
  ask(changes, { tree: 0, node: 0, params: {} });
  ask(changes, { tree: 0, node: 1, params: {} });
  assert.deepEqual(changes.get(), []);
});
