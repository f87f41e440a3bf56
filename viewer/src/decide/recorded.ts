// SPDX-License-Identifier: MIT
/** What was recorded of a node, as a Proposal. */
import type { Decisions, Shape, Tree } from '../run/run.ts';
import { same_suppliers, type Proposal } from './proposal.ts';

/** What goes up from these is nobody's but theirs. */
const kOwn: ReadonlySet<string> = new Set(['fusion', 'paper_fusion']);
const kNobody = new Int16Array(0);

/** By field who supplied what a node proposed; empty if it proposed nothing. */
export function suppliers(shape: Shape, node: number): Int16Array {
  return shape.supplier[node] ?? kNobody;
}

/** Whether a node set any field. */
export function proposed_action(shape: Shape, node: number): boolean {
  return suppliers(shape, node).some((supplier) => supplier >= 0);
}

/** What of a node's answer does not change while the shape lasts; `out.action` is left empty. */
export function read_answer(tree: Tree, shape: Shape, node: number, out: Proposal): void {
  out.status = shape.status[node] ?? null;
  out.vote = shape.vote[node]!;
  out.action.fill(NaN);
  out.supplier.fill(-1);
  out.supplier.set(suppliers(shape, node));
  out.leader = leader_of(tree, shape, node);
}

/** Whose recommendation a node's answer was; -1: nobody's. Only the root's is recorded. */
export function leader_of(tree: Tree, shape: Shape, node: number): number {
  if (node === 0) return shape.leader;
  const proposed = shape.vote[node]! > 0 || proposed_action(shape, node);
  if (shape.status[node] === null || shape.status[node] === 'failure' || !proposed) return -1;
  const { type, children } = tree.nodes[node]!;
  const mine = suppliers(shape, node);
  if (children.length === 0 || kOwn.has(type) || mine.includes(node)) return node;
  const whole = children.filter((c) => shape.status[c] !== null && shape.status[c] !== 'failure');
  const alike = whole.filter((c) => same_suppliers(suppliers(shape, c), mine));
  const of = alike.length > 0 ? alike : whole;
  const best = of.reduce((a, b) => (shape.vote[b]! > shape.vote[a]! ? b : a), of[0]!);
  return best === undefined ? -1 : leader_of(tree, shape, best);
}

/** Fills in the values of recorded answers, decision by decision. */
export class Loader {
  private readonly loads: { action: Float64Array; field: number; column: Float64Array }[] = [];

  constructor(private readonly decisions: Decisions) {}

  /** Adds the fields of an answer that was read with read_answer. */
  add({ action, supplier }: Proposal): void {
    for (let field = 0; field < supplier.length; ++field) {
      const column = supplier[field]! >= 0 ? this.decisions.value(supplier[field]!, field) : null;
      if (column) this.loads.push({ action, field, column });
    }
  }
  load(decision: number): void {
    for (const { action, field, column } of this.loads) action[field] = column[decision]!;
  }
}
