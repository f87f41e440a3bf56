// SPDX-License-Identifier: MIT
/** What would have been decided with other votes, arbiters and parameters. */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { arbiters_for, command_of, what_if, with_param, type Change, type WhatIfResult } from '../src/decide/what_if.ts';
import type { Run } from '../src/run/run.ts';
import { find, leaf, node, run_of, type NodeSpec, type Said } from './decide_run.ts';

const kPursue: Said = { vote: 40, heading: 1.5, speed: 250, target: 3 };
const kFollow: Said = { vote: 20, heading: 0.5, speed: 200, mode: 1 };
const kSaid: Record<string, Said>[] = [
  { avoid: { status: 'failure' }, pursue: { status: 'failure' }, follow: kFollow },
  { avoid: { status: 'failure' }, pursue: kPursue, follow: kFollow },
  { avoid: { vote: 100, altitude: 3000 }, pursue: kPursue, follow: kFollow },
  { avoid: { status: 'failure' }, pursue: kPursue, follow: kFollow },
];

function fight(type: string): NodeSpec {
  return node('fight', type, [node('survive', 'winner_takes_all', [leaf('avoid')]), leaf('pursue'), leaf('follow')]);
}
function asked(run: Run, label: string, change: Omit<Change, 'tree' | 'node'>): WhatIfResult {
  return what_if(run, 0, [{ tree: 0, node: find(run, label), ...change }]);
}

describe('an arbiter in place of another', () => {
  const run = run_of(fight('winner_takes_all'), kSaid);
  test('changes the decisions in which it chooses otherwise', () => {
    const result = asked(run, 'fight', { type: 'per_field' });
    assert.deepEqual([result.decisions, result.different, result.unknown, result.caution], [4, 3, 0, '']);
    assert.deepEqual(result.spans, [[0.1, run.players[0]!.decisions.t[3]]]);
    const { index, flown, other, fields } = result.first!;
    assert.deepEqual([index, flown, other], [1, 'pursue', 'pursue']);
    assert.deepEqual(fields, [{ name: 'mode', flown: '-', other: 'follow', difference: null }]);
    assert.deepEqual([...result.leader], [run.shapes[0]!.leader, ...[1, 2, 3].map((i) => run.shapes[i]!.leader)]);
  });
  test('blends values decision by decision and says by how much', () => {
    const result = asked(run, 'fight', { type: 'fusion' });
    assert.equal(result.different, 3);
    const speed = result.first!.fields.find((f) => f.name === 'speed')!;
    assert.deepEqual([result.first!.flown, result.first!.other], ['pursue', 'fight']);
    assert.deepEqual([speed.flown, speed.other], ['486 kt', '454 kt']);
    assert.ok(Math.abs(speed.difference! + 50 / 3) < 1e-9);
    assert.ok(result.first!.fields.find((f) => f.name === 'heading')!.difference! < 0);
  });
  test('is no change if it says the same', () => {
    assert.equal(asked(run, 'fight', { type: 'winner_takes_all' }).different, 0);
    assert.equal(asked(run, 'survive', { type: 'fusion' }).different, 0);
    assert.equal(asked(run, 'fight', { type: 'fusion', params: { top: 1 } }).different, 0);
  });
  test('has what parameters it needs', () => {
    const result = asked(run, 'fight', { type: 'paper_fusion' });
    assert.deepEqual([result.unknown, result.different], [0, 3]);
    assert.deepEqual(result.first!.fields.map((f) => f.name), ['heading', 'speed', 'mode', 'target']);
  });
  test('with parameters that it cannot have leaves decisions unknown', () => {
    const result = asked(run, 'fight', { type: 'motor_schema', params: { direction: 'altitude' } });
    assert.deepEqual([result.unknown, result.different], [4, 0]);
    assert.equal(result.why_unknown, 'motor_schema cannot be with these parameters');
    assert.deepEqual([...result.leader], [-2, -2, -2, -2]);
  });
});

test('the blend of what was flown is made again, so that rounding is no difference', () => {
  const run = run_of(fight('fusion'), kSaid);
  const { value } = run.players[0]!.decisions;
  run.players[0]!.decisions.value = (n, f) => value(n, f)?.map((x) => Math.round(x * 1e4) / 1e4) ?? null;
  assert.equal(asked(run, 'avoid', { vote: 100 }).different, 0);
  assert.equal(asked(run, 'avoid', { vote: 1 }).different, 0);
  assert.equal(asked(run, 'follow', { vote: 40 }).different, 3);
});

describe('another vote of a leaf', () => {
  const run = run_of(fight('winner_takes_all'), kSaid);
  test('wins or loses', () => {
    const result = asked(run, 'follow', { vote: 41 });
    assert.deepEqual([result.different, result.first?.index, result.first?.other], [2, 1, 'follow']);
    assert.deepEqual(result.spans.map(([from]) => from), [0.1, run.players[0]!.decisions.t[3]]);
  });
  test('leaves ties to the earlier child', () => assert.equal(asked(run, 'follow', { vote: 40 }).different, 0));
  test('of 0 abstains', () => assert.equal(asked(run, 'follow', { vote: 0 }).different, 1));
  test('does not touch votes that are not by that parameter', () => {
    const given = node('fight', 'winner_takes_all', [leaf('break', { params: { vote: 70 } }), leaf('pursue')]);
    const at = (vote: number) => ({ break: { vote, heading: 1 }, pursue: kPursue });
    const near = run_of(given, [at(80), at(70)]);
    const result = asked(near, 'break', { vote: 5 });
    assert.deepEqual([result.different, result.first?.index], [1, 1]);
  });
  test('is unknown where a leaf has more than one and the page does not know which', () => {
    const at = (vote: number) => ({ scatter: { vote, heading: 1 }, pursue: kPursue });
    const run = run_of(node('fight', 'winner_takes_all', [leaf('scatter'), leaf('pursue')]), [at(80), at(70), at(0)]);
    const result = asked(run, 'scatter', { vote: 5 });
    assert.deepEqual([result.unknown, result.different, result.why_unknown],
      [2, 0, 'scatter has more than one vote, and which of them this was is not in the page']);
  });
  test('changes nothing in another tree', () => {
    const other: Run = { ...run, shapes: run.shapes.map((s, i) => (i < 3 ? s : { ...s, tree: 1 })), trees: [run.trees[0]!, run.trees[0]!] };
    const result = asked(other, 'follow', { vote: 41 });
    assert.equal(result.different, 1);
    assert.equal(result.leader[3], find(run, 'pursue'));
  });
});

describe('nodes above', () => {
  const kHolds: Said = { status: 'success' };
  test('sequencers hand on whatever the tree in charge says', () => {
    const spec = node('root', 'sequencer', [fight('winner_takes_all'), leaf('rest'), leaf('condition')], { remembers: true });
    const said = kSaid.map((one): Record<string, Said> => ({ ...one, condition: { status: 'failure' }, root: {} }));
    const run = run_of(spec, said, (all) => { all[0] = all[1]!; });
    assert.equal(asked(run, 'fight', { type: 'per_field' }).different, 3);
    const silent = asked(run, 'follow', { vote: 0 });
    assert.deepEqual([silent.different, silent.unknown, silent.first?.other, silent.caution], [1, 0, 'nobody', '']);
  });
  test('a selector that would ask who was not asked is unknown', () => {
    const spec = node('root', 'selector', [fight('winner_takes_all'), leaf('home', { remembers: true })]);
    const run = run_of(spec, kSaid);
    const result = asked(run, 'follow', { vote: 0 });
    assert.deepEqual([result.unknown, result.different], [1, 0]);
    assert.equal(result.why_unknown, 'home was not asked in flight, and root would have asked it');
    assert.match(result.caution, /^From 00:00\.0 on root would have asked or halted others/);
    assert.equal(asked(run, 'pursue', { vote: 5 }).caution, '');
  });
  test('a selector that would stop earlier is known, but it would halt what was asked', () => {
    const spec = node('root', 'selector', [fight('winner_takes_all'), leaf('home', { remembers: true })]);
    const silent: Said = { ...kFollow, vote: 0 };
    const said = { avoid: { status: 'failure' }, pursue: { status: 'failure' }, follow: silent, home: { vote: 5, speed: 100 } } as const;
    const run = run_of(spec, [said]);
    run.trees[0]!.nodes[find(run, 'follow')]!.params = { vote: 0 };
    const result = asked(run, 'follow', { vote: 20 });
    assert.deepEqual([result.different, result.unknown, result.first?.other], [1, 0, 'follow']);
    assert.match(result.caution, /root would have asked or halted others/);
  });
  test('a loop that answered something of its own is unknown', () => {
    const said = kSaid.map((one): Record<string, Said> => ({ ...one, pursue: { ...kPursue, ...kHolds }, root: {} }));
    const run = run_of(node('root', 'repeat', [fight('winner_takes_all')]), said, (all) => { all[0] = { ...all[1]!, status: 'running' }; });
    assert.equal(asked(run, 'fight', { type: 'per_field' }).unknown, 3);
  });
  test('a loop over tracks asks more often than the page has', () => {
    const said = kSaid.map((one): Record<string, Said> => ({ ...one, root: {} }));
    const run = run_of(node('root', 'for_each', [fight('winner_takes_all')]), said, (all) => { all[0] = all[1]!; });
    const result = asked(run, 'fight', { type: 'per_field' });
    assert.deepEqual([result.different, result.unknown, result.why_unknown],
      [0, 4, 'root asks once for each of several, and the page has one of the answers']);
  });
  test('what somebody thinks of each candidate is not in the page', () => {
    const run = run_of(fight('winner_takes_all'), kSaid);
    run.trees[0]!.nodes[find(run, 'pursue')]!.appraises = true;
    const grid = { 'grid.field': 'heading' };
    const result = asked(run, 'fight', { type: 'vote_grid', params: grid });
    assert.deepEqual([result.different, result.unknown], [0, 4]);
    assert.equal(result.why_unknown, 'pursue judges each candidate of fight, and its judgements are not in the page');
    assert.equal(asked(run, 'survive', { type: 'vote_grid', params: grid }).unknown, 0);
  });
  test('a decorator that only hands on does so, one that chooses by votes does not', () => {
    const said = kSaid.map((one) => ({ ...one, root: {} }));
    const limited = (type: string) =>
      run_of(node('root', type, [fight('winner_takes_all')]), said, (all) => { all[0] = all[1]!; });
    assert.equal(asked(limited('timeout'), 'fight', { type: 'per_field' }).different, 3);
    const drawn = asked(limited('weighted_random'), 'fight', { type: 'per_field' });
    assert.deepEqual([drawn.different, drawn.unknown], [0, 3]);
    assert.equal(drawn.why_unknown, 'what root (weighted_random) makes of it depends on more than this page has');
  });
  test('a parallel that counts otherwise and halts is told', () => {
    const kids = [fight('winner_takes_all'), leaf('shoot', { remembers: true })];
    const spec = node('root', 'parallel', kids, { params: { success_count: 1 } });
    const said = { avoid: { status: 'failure' }, pursue: { ...kPursue, ...kHolds }, follow: kFollow, shoot: { vote: 5 } } as const;
    const result = asked(run_of(spec, [said]), 'follow', { vote: 50 });
    assert.equal(result.different, 1);
    assert.match(result.caution, /root would have asked or halted others/);
  });
});

describe('what can be chosen', () => {
  const spec = node('fight', 'fusion', [leaf('pursue'), leaf('follow')], { params: { top: 2, conflicts: 'drop' } });
  const run = run_of(spec, [{ pursue: kPursue, follow: kFollow }]);
  const change = (more: Omit<Change, 'tree' | 'node'>): Change => ({ tree: 0, node: 0, ...more });
  test('begins with what is there', () => {
    const [own, ...others] = arbiters_for(run, run.trees[0]!, 0);
    assert.deepEqual(own, { type: 'fusion', params: [
      { name: 'top', unit: '', values: ['all', 1, 2], value: 2 }, { name: 'conflicts', unit: '', values: ['blend', 'drop'], value: 'drop' },
    ] });
    assert.deepEqual(others.map((o) => o.type), ['winner_takes_all', 'per_field', 'paper_fusion', 'motor_schema', 'priority',
      'commitment', 'verify', 'vote_grid', 'utility']);
    assert.deepEqual(arbiters_for(run, run.trees[0]!, 1), []);
  });
  test('has the field that a new arbiter is about, with its own range', () => {
    const names = (type: string, given = {}) =>
      arbiters_for(run, run.trees[0]!, 0, given).find((o) => o.type === type)!.params.map(({ name, unit }) => `${name} ${unit}`.trim());
    assert.deepEqual(names('verify'), ['bounds.field', 'bounds.heading.min deg', 'bounds.heading.max deg', 'fallback']);
    assert.deepEqual(names('verify', { 'bounds.field': 'altitude' }).slice(1, 3), ['bounds.altitude.min ft', 'bounds.altitude.max ft']);
    assert.deepEqual(names('utility', { 'grid.field': 'speed' }).slice(1), ['grid.speed.from kt', 'grid.speed.to kt', 'grid.speed.steps',
      'grid.speed.reach kt', 'grid.speed.spread kt']);
    const lower = with_param(run, run.trees[0]!, 0, 'verify', { 'bounds.field': 'altitude', 'bounds.altitude.min': 2000 }, 'bounds.altitude.max', 9000);
    assert.deepEqual(lower, { 'bounds.field': 'altitude', 'bounds.altitude.min': 2000, 'bounds.altitude.max': 9000, fallback: 'false' });
    assert.deepEqual(Object.keys(with_param(run, run.trees[0]!, 0, 'verify', lower, 'bounds.field', 'speed')),
      ['bounds.field', 'bounds.speed.min', 'bounds.speed.max', 'fallback']);
    assert.equal(command_of(run, 0, [change({ type: 'verify', params: lower })]), "eyrie whatif RUN --player eagle2 --set 'root=verify' " +
      "--set 'root.fallback=false' --set 'root.bounds={altitude: {min: 2000 ft, max: 9000 ft}}'");
  });
  test('of a grid or of bounds that flew is given to the terminal whole', () => {
    const params = { 'grid.heading.from': 0, 'grid.heading.to': 6, 'grid.heading.steps': 12, 'grid.heading.reach': 0.5,
      'grid.speed.from': 100, 'grid.speed.to': 200, 'grid.speed.steps': 11, 'grid.speed.reach': 50 };
    const flown = run_of(node('fight', 'vote_grid', [leaf('pursue')], { params }), [{ pursue: kPursue }]);
    const [own] = arbiters_for(flown, flown.trees[0]!, 0);
    assert.deepEqual(own!.params.filter(({ name }) => name.startsWith('grid.speed')).map(({ value }) => value), [194.384449244, 388.768898488, 11, 97.192224622]);
    assert.equal(command_of(flown, 0, [change({ params: { 'grid.heading.reach': 40 } })]), "eyrie whatif RUN --player eagle2 --set 'root.grid={" +
      'heading: {from: 0 deg, to: 6 rad, steps: 12, reach: 40 deg}, speed: {from: 100 m/s, to: 200 m/s, steps: 11, reach: 50 m/s}}\'');
    assert.equal(asked(flown, 'fight', { params: { 'grid.heading.steps': 5 } }).different, 1);
  });
  test('is a command for the terminal', () => {
    const pursue = { tree: 0, node: 1, vote: 70 };
    assert.equal(command_of(run, 0, [change({ type: 'per_field' }), pursue]),
      "eyrie whatif RUN --player eagle2 --set 'root=per_field' --set 'root/pursue.vote=70'");
    assert.equal(command_of(run, 0, [change({ type: 'fusion', params: { top: 'all', conflicts: 'blend' } })]),
      "eyrie whatif RUN --player eagle2 --set 'root.top=null' --set 'root.conflicts=blend'");
    assert.equal(command_of(run, 0, [change({ type: 'paper_fusion' })]),
      "eyrie whatif RUN --player eagle2 --set 'root=paper_fusion' --set 'root.high_vote=50'");
    const two: Run = { ...run, trees: [...run.trees, { ...run.trees[0]!, name: 'home' }] };
    assert.match(command_of(two, 0, [{ ...pursue, tree: 1 }]), /--set 'home:root\/pursue.vote=70'$/);
  });
});

describe('arbiters that remember', () => {
  const kWeak: Said = { status: 'failure' };
  /** Pursue, then follow is a little stronger, then pursue falls silent, then both again. */
  const kDithers: Record<string, Said>[] = [
    { pursue: { ...kPursue, vote: 30 }, follow: kFollow },
    { pursue: { ...kPursue, vote: 30 }, follow: { ...kFollow, vote: 33 } },
    { pursue: kWeak, follow: { ...kFollow, vote: 33 } },
    { pursue: { ...kPursue, vote: 30 }, follow: { ...kFollow, vote: 33 } },
    { pursue: { ...kPursue, vote: 30 }, follow: { ...kFollow, vote: 50 } },
  ];
  const spec = (type: string, params = {}): NodeSpec => node('fight', type, [leaf('pursue'), leaf('follow')], { params });
  const leaders = (run: Run, { leader }: WhatIfResult): string[] => [...leader].map((n) => (n < 0 ? '-' : run.trees[0]!.nodes[n]!.label));

  test('stay with what they chose', () => {
    const run = run_of(spec('winner_takes_all'), kDithers);
    const result = asked(run, 'fight', { type: 'commitment', params: { margin: 5, min_time: 0, hold: 0 } });
    assert.deepEqual(leaders(run, result), ['pursue', 'pursue', 'follow', 'follow', 'follow']);
    assert.deepEqual([result.different, result.unknown, result.first?.index], [1, 0, 1]);
    const bridged = asked(run, 'fight', { type: 'commitment', params: { margin: 5, min_time: 0, hold: 1 } });
    assert.deepEqual(leaders(run, bridged), ['pursue', 'pursue', 'pursue', 'pursue', 'follow']);
    assert.equal(bridged.different, 3);
    assert.equal(bridged.spans.length, 1);
  });
  test('say the same however often they are asked', () => {
    const run = run_of(spec('winner_takes_all'), kDithers);
    const ask = (): WhatIfResult => asked(run, 'fight', { type: 'commitment', params: { margin: 0, min_time: 0.25, hold: 0 } });
    assert.deepEqual(ask(), ask());
    assert.deepEqual(leaders(run, ask()), ['pursue', 'pursue', 'follow', 'follow', 'follow']);
  });
  /** As it flies: what the same arbiter makes of its children, decision after decision. */
  function flown(type: string, params: Record<string, number>, decisions: Record<string, Said>[]): Run {
    const run = run_of(spec('winner_takes_all'), decisions);
    const answer = asked(run, 'fight', { type, params });
    const shapes = decisions.map((_, i) => {
      const { shapes: all, players } = run;
      const shape = all[players[0]!.decisions.shape[i]!]!;
      const who = answer.leader[i]!;
      const set = (n: number) => (n === 0 ? shape.supplier[who]! : shape.supplier[n]!);
      return { ...shape, leader: who, vote: shape.vote.map((v, n) => (n === 0 ? shape.vote[who]! : v)), supplier: shape.supplier.map((_, n) => set(n)) };
    });
    const [player] = run.players;
    const anew = { ...player!, decisions: { ...player!.decisions, shape: Int32Array.from(decisions, (_, i) => i) } };
    const tree = { ...run.trees[0]!, nodes: run.trees[0]!.nodes.map((n, i) => (i ? n : { ...n, type, params, remembers: true })) };
    return { ...run, players: [anew], shapes, trees: [tree] };
  }
  test('in flight are made again, and a vote below is known', () => {
    const run = flown('commitment', { margin: 5 }, kDithers);
    const same_again = asked(run, 'pursue', { vote: 30 });
    assert.deepEqual([same_again.unknown, same_again.different, same_again.why_unknown], [0, 0, '']);
    const stronger = asked(run, 'pursue', { vote: 60 });
    assert.deepEqual(leaders(run, stronger), ['pursue', 'pursue', 'follow', 'pursue', 'pursue']);
    assert.deepEqual([stronger.unknown, stronger.different], [0, 2]);
  });
  test('in flight that did what is not understood leave all behind it unknown', () => {
    const run = flown('commitment', { margin: 5 }, kDithers);
    run.shapes[1] = { ...run.shapes[1]!, vote: run.shapes[1]!.vote.map((v, n) => (n === 0 ? 12 : v)) };
    const result = asked(run, 'pursue', { vote: 60 });
    assert.ok(result.unknown >= 3, `${result.unknown} unknown`);
    assert.match(result.why_unknown, /fight remembers hangs on a decision before/);
  });
  test('forget when they are not asked', () => {
    const idle = { pursue: { ...kPursue, vote: 30 }, follow: { ...kFollow, vote: 33 } };
    const run = run_of(spec('winner_takes_all'), [kDithers[0]!, kDithers[1]!, idle]);
    run.shapes[1] = { ...run.shapes[1]!, status: run.shapes[1]!.status.map(() => null), leader: -1 };
    const result = asked(run, 'fight', { type: 'commitment', params: { margin: 5, min_time: 0, hold: 0 } });
    assert.equal(leaders(run, result)[2], 'follow', 'the choice of the first decision is gone');
  });
  test('know less of a run of which not every decision is there', () => {
    const run = { ...run_of(spec('winner_takes_all'), kDithers), about: { thinned: true } } as unknown as Run;
    assert.match(asked(run, 'fight', { type: 'commitment', params: { margin: 5, min_time: 0, hold: 0 } }).caution, /one decision a second/);
    assert.equal(asked(run, 'fight', { type: 'per_field' }).caution, '');
  });
  test('have their command for the terminal', () => {
    const run = run_of(spec('winner_takes_all'), kDithers);
    assert.equal(command_of(run, 0, [{ tree: 0, node: 0, type: 'commitment' }]),
      "eyrie whatif RUN --player eagle2 --set 'root=commitment' --set 'root.margin=5' --set 'root.min_time=0 s' --set 'root.hold=0 s'");
  });
});

test('a whole flight is arbitrated anew', () => {
  const many = Array.from({ length: 16000 }, (_, i) => kSaid[i % kSaid.length]!);
  const run = run_of(fight('winner_takes_all'), many);
  assert.equal(asked(run, 'fight', { type: 'fusion' }).different, 12000);
});
