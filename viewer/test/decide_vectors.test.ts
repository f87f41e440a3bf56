// SPDX-License-Identifier: MIT
/** The page's arbiters against what the program's made of the same proposals (EYRIE_VECTORS). */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { decider_of, kDone, type Proposal } from '../src/decide/arbitrate.ts';
import { make_proposal } from '../src/decide/proposal.ts';
import type { ActionField, Status, TreeNode } from '../src/run/run.ts';

interface Answer {
  status: Status;
  vote: number;
  leader: number;
  action: (number | null)[];
  supplier: number[];
}
interface Case {
  tree: Omit<TreeNode, 'children'>[];
  leaves: { node: number; status: Status; vote: number; action: (number | null)[] }[];
  /** Per node; null: not asked. */
  expected: (Answer | null)[];
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

function leaf(fields: number, node: number, { leaves }: Case): Proposal {
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

/** Children first; nodes that were not asked stay so. */
function answers(vectors: Vectors, one: Case): Proposal[] {
  const all: Proposal[] = [];
  for (let node = one.tree.length - 1; node >= 0; --node) {
    const kids = children_of(one, node).map((child) => all[child]!);
    all[node] = leaf(vectors.action.length, node, one);
    if (kids.length === 0 || one.expected[node] === null) continue;
    const { type, params, path } = one.tree[node]!;
    const decide = decider_of(type, params, vectors.action, node);
    assert.ok(decide, `${type} ${JSON.stringify(params)} is not arbitrated here`);
    const missing = decide(kids, all[node]!);
    assert.equal(missing, kDone, `${path} asks child ${missing}, which was not asked`);
  }
  return all;
}

test('the arbiters of the page answer as those of the program', { skip: kFile ? false : 'EYRIE_VECTORS is not set' }, () => {
  assert.ok(existsSync(kFile!), `EYRIE_VECTORS names ${kFile}, which is not there`);
  const vectors = JSON.parse(readFileSync(kFile!, 'utf8')) as Vectors;
  assert.ok(vectors.cases.length > 0);
  vectors.cases.forEach((one, number) => {
    const all = answers(vectors, one);
    one.expected.forEach((want, node) => {
      if (want) compare(all[node]!, want, `case ${number}, ${one.tree[node]!.path}`);
    });
  });
});
