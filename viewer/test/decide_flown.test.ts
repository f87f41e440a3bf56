// SPDX-License-Identifier: MIT
/** Flights as the page has them: what it arbitrates of them must be what `eyrie whatif` does (EYRIE_CHECKED, EYRIE_PROGRAM). */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { promisify } from 'node:util';
import { arbiters_for, command_of, what_if, type Change } from '../src/decide/what_if.ts';
import { decode } from '../src/run/decode.ts';
import type { Run } from '../src/run/run.ts';
import { words_of, type WhatIfJson } from './terminal.ts';

const { env } = process;
const kFolder = env['EYRIE_CHECKED'] ?? '';
const kProgram = env['EYRIE_PROGRAM'] ?? '';
const kSkip = kFolder && kProgram ? false : 'EYRIE_CHECKED or EYRIE_PROGRAM is not set: nothing to compare with';

function data_of(page: string): string {
  const [, data] = /<script[^>]*type="application\/x-eyrie-run"[^>]*>([^<]+)</.exec(page) ?? [];
  assert.ok(data, 'there is no run in the page');
  return data;
}

async function ask(command: string): Promise<WhatIfJson> {
  const [, , , ...args] = words_of(command);
  const { stdout } = await promisify(execFile)(kProgram, ['whatif', kFolder, ...args, '--json'], { maxBuffer: 1 << 28 });
  return JSON.parse(stdout) as WhatIfJson;
}

let run: Run;

async function compare(player: number, changes: Change[]): Promise<number> {
  const command = command_of(run, player, changes);
  const mine = what_if(run, player, changes);
  const { decisions, different, first } = await ask(command);
  assert.deepEqual([mine.why_unknown, mine.caution], ['', ''], command);
  assert.deepEqual([mine.decisions, mine.different], [decisions, different], command);
  const { step } = run.players[player]!.decisions;
  assert.deepEqual(mine.first && [step[mine.first.index], mine.first.flown, mine.first.other],
    first ? [first.step, first.leader.flown, first.leader.other] : null, command);
  assert.deepEqual((mine.first?.fields ?? []).map(({ name, flown, other }) => ({ name, flown, other })),
    (first?.fields ?? []).map(({ name, flown, other }) => ({ name, flown, other })), command);
  return different;
}

describe('what a flight would have decided, as the program says', { skip: kSkip }, () => {
  before(async () => {
    run = await decode(data_of(readFileSync(join(kFolder, 'debrief.html'), 'utf8')));
  });
  const player_of = (name: string): number => run.players.findIndex((p) => p.name === name);
  const tree_of = (name: string): number => run.trees.findIndex((t) => t.name === name);
  const change = (tree: string, path: string, more: Omit<Change, 'tree' | 'node'>): Change =>
    ({ tree: tree_of(tree), node: run.trees[tree_of(tree)]!.nodes.findIndex((n) => n.path === path), ...more });

  for (const [player, tree] of [['careful1', 'careful'], ['balanced1', 'balanced'], ['weighing1', 'weighing']] as const)
    test(`with every arbiter in every place of ${tree}`, async () => {
      const index = tree_of(tree);
      const { nodes } = run.trees[index]!;
      const places = [...nodes.keys()].filter((node) => nodes[node]!.label !== 'survive' || tree === 'careful');
      let others = 0;
      for (const node of places) {
        const asked = arbiters_for(run, run.trees[index]!, node).slice(1).map(({ type }) => compare(player_of(player), [{ tree: index, node, type }]));
        for (const different of await Promise.all(asked)) others += Number(different > 0);
      }
      assert.ok(others > 5, `only ${others} changes change anything`);
    });

  test('with other limits, and with a fallback that is none', async () => {
    const [who, at] = [player_of('careful2'), (more: Change['params']) => change('careful', 'root', { params: more! })];
    assert.ok((await compare(who, [at({ 'bounds.altitude.min': 25000 })])) > 0);
    assert.ok((await compare(who, [at({ 'bounds.heading.min': 80, 'bounds.heading.max': 100 })])) > 0);
    await compare(who, [at({ fallback: 'false', 'bounds.altitude.max': 20000 })]);
    assert.ok((await compare(who, [change('careful', 'root/fusion', { type: 'verify', params: { 'bounds.field': 'speed', 'bounds.speed.max': 500 } })])) > 0);
  });
  test('with other votes below what checks, and another blend', async () => {
    assert.ok((await compare(player_of('careful2'), [change('careful', 'root/follow_lead', { vote: 45 })])) > 0);
    for (const name of ['careful1', 'careful2']) {
      assert.ok((await compare(player_of(name), [change('careful', 'root/fusion/navigate', { vote: 70 })])) > 0);
      await compare(player_of(name), [change('careful', 'root/fusion', { type: 'per_field' }), change('careful', 'root', { params: { fallback: 'false' } })]);
    }
  });
  test('with another grid, and with other votes on it', async () => {
    const grid = (more: Change['params']) => [change('balanced', 'root', { params: more! })];
    assert.ok((await compare(player_of('balanced1'), grid({ 'grid.heading.steps': 12 }))) > 0);
    assert.ok((await compare(player_of('balanced1'), grid({ 'grid.altitude.from': 20000, 'grid.altitude.reach': 4000 }))) > 0);
    assert.ok((await compare(player_of('balanced1'), [change('balanced', 'root/navigate', { vote: 80 })])) > 0);
    const weighed = (more: Change['params']) => [change('weighing', 'root/utility', { params: more! })];
    assert.ok((await compare(player_of('weighing1'), weighed({ 'grid.speed.spread': 60 }))) > 0);
    assert.ok((await compare(player_of('weighing1'), weighed({ 'grid.heading.steps': 9, 'grid.heading.spread': 20 }))) > 0);
    assert.ok((await compare(player_of('weighing1'), [change('weighing', 'root/utility/navigate', { vote: 80 })])) > 0);
  });
});
