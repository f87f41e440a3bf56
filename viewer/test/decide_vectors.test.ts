// SPDX-License-Identifier: MIT
/** The page's arbiters against what the program's made of the same proposals (EYRIE_VECTORS). */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { decider_of, kDone, type Decider, type Proposal } from '../src/decide/arbitrate.ts';
import { make_proposal } from '../src/decide/proposal.ts';
import type { ActionField, Status, TreeNode } from '../src/run/run.ts';

interface Answer {
  status: Status;
  vote: number;
  leader: number;
  action: (number | null)[];
  supplier: number[];
}
interface Tick {
  t: number;
  /** By field; null: it has no value. */
  state: (number | null)[];
  leaves: { node: number; status: Status; vote: number; action: (number | null)[] }[];
  /** Per node; null: not asked. */
  expected: (Answer | null)[];
}
interface Case {
  tree: Omit<TreeNode, 'children'>[];
  /** One after the other: some nodes remember. */
  ticks: Tick[];
}
interface Vectors {
  action: ActionField[];
  cases: Case[];
}

const kFile = process.env['EYRIE_VECTORS'];
const kTolerance = 1e-9;

function children_of({ tree }: Case, node: number): number[] {
  return tree.flatMap(({ parent }, child) => (parent === node ? [child] : []));
}

function leaf(fields: number, node: number, { leaves }: Tick): Proposal {
  const out = make_proposal(fields);
  const said = leaves.find((l) => l.node === node);
  if (!said) return out;
  out.status = said.status;
  if (said.status === 'failure') return out;
  out.vote = said.vote;
  said.action.forEach((value, f) => {
    if (value === null) return;
    out.action[f] = value;
    out.supplier[f] = node;
  });
  if (said.vote > 0 || said.action.some((value) => value !== null)) out.leader = node;
  return out;
}

function near(a: number, b: number): boolean {
  return Math.abs(a - b) <= kTolerance * Math.max(1, Math.abs(a), Math.abs(b));
}

function compare(got: Proposal, want: Answer, where: string): void {
  assert.equal(got.status, want.status, `${where}: status`);
  assert.equal(got.vote, want.vote, `${where}: vote`);
  assert.equal(got.leader, want.leader, `${where}: leader`);
  assert.deepEqual([...got.supplier], want.supplier, `${where}: who supplied what`);
  want.action.forEach((value, f) => {
    const mine = got.action[f]!;
    assert.ok(value === null ? Number.isNaN(mine) : near(mine, value), `${where}: field ${f} is ${mine}, not ${value}`);
  });
}

function deciders({ action }: Vectors, one: Case): (Decider | null)[] {
  return one.tree.map(({ type, params }, node) => {
    const children = children_of(one, node);
    if (!children.length) return null;
    const decide = decider_of(type, params, action, node, children);
    assert.ok(decide, `${type} ${JSON.stringify(params)} is not arbitrated here`);
    return decide;
  });
}

/** Children first; nodes that were not asked stay so, and have forgotten. */
function answers({ action }: Vectors, one: Case, all_decide: (Decider | null)[], tick: Tick): Proposal[] {
  const all: Proposal[] = [];
  for (let node = one.tree.length - 1; node >= 0; --node) {
    all[node] = leaf(action.length, node, tick);
    const decide = all_decide[node];
    if (tick.expected[node] === null) decide?.forget?.();
    else if (decide) {
      const missing = decide(children_of(one, node).map((child) => all[child]!), all[node]!, { t: tick.t, state: (field) => tick.state[field] ?? NaN });
      assert.equal(missing, kDone, `${one.tree[node]!.path} asks child ${missing}, which was not asked`);
    }
  }
  return all;
}

test('the arbiters of the page answer as those of the program', { skip: kFile ? false : 'EYRIE_VECTORS is not set' }, () => {
  assert.ok(existsSync(kFile!), `EYRIE_VECTORS names ${kFile}, which is not there`);
  const vectors = JSON.parse(readFileSync(kFile!, 'utf8')) as Vectors;
  for (const field of vectors.action) field.quantum = 0; // unlike in a page
  assert.ok(vectors.cases.length > 0);
  vectors.cases.forEach((one, number) => {
    const decide = deciders(vectors, one);
    for (const tick of one.ticks) {
      const all = answers(vectors, one, decide, tick);
      tick.expected.forEach((want, node) => {
        if (want) compare(all[node]!, want, `case ${number} at ${tick.t.toFixed(1)}, ${one.tree[node]!.path}`);
      });
    }
  });
});
