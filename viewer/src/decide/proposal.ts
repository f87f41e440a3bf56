// SPDX-License-Identifier: MIT
/** What a node answered, as a tree's trace notes it: src/ubf/trace.hpp. */
import type { Status } from '../run/run.ts';

export interface Proposal {
  /** Null: it was not asked. */
  status: Status | null;
  vote: number;
  /** By field; NaN: not set. */
  action: Float64Array;
  /** By field the node that supplied it; -1: not set. */
  supplier: Int16Array;
  /** The node whose recommendation it is; -1: nobody's. */
  leader: number;
}

export function make_proposal(fields: number): Proposal {
  return {
    status: null,
    vote: 0,
    action: new Float64Array(fields).fill(NaN),
    supplier: new Int16Array(fields).fill(-1),
    leader: -1,
  };
}

/** Leaves the status alone. */
export function clear(p: Proposal): void {
  p.vote = 0;
  p.action.fill(NaN);
  p.supplier.fill(-1);
  p.leader = -1;
}

export function copy(from: Proposal, to: Proposal): void {
  to.status = from.status;
  to.vote = from.vote;
  to.action.set(from.action);
  to.supplier.set(from.supplier);
  to.leader = from.leader;
}

/** Neither a vote nor any field: no proposal. */
export function is_empty(p: Proposal): boolean {
  if (p.vote !== 0) return false;
  for (let f = 0; f < p.action.length; ++f) if (!Number.isNaN(p.action[f]!)) return false;
  return true;
}

/** It neither failed nor abstained. */
export function is_heard(p: Proposal): boolean {
  return p.vote > 0 && p.status !== 'failure' && p.status !== null;
}

/** As Trace::record: nothing of a failure, nobody leads nothing, and what nobody else supplied is the node's own. */
export function record(p: Proposal, node: number): void {
  if (p.status === 'failure' || is_empty(p)) {
    clear(p);
    return;
  }
  if (p.leader === -1) p.leader = node;
  for (let f = 0; f < p.action.length; ++f) {
    if (Number.isNaN(p.action[f]!)) p.supplier[f] = -1;
    else if (p.supplier[f] === -1) p.supplier[f] = node;
  }
}

export function same_suppliers(a: Int16Array, b: Int16Array): boolean {
  for (let f = 0; f < a.length; ++f) if (a[f] !== b[f]) return false;
  return true;
}

/** Rounding is no difference: this page and the program have other sines. */
const kRounding = 1e-11;

/** Whether two values of a field are one; NaN: not set. */
export function same_value(a: number, b: number): boolean {
  return a === b || Math.abs(a - b) <= kRounding * (Math.abs(a) + Math.abs(b)) || (Number.isNaN(a) && Number.isNaN(b));
}

/** Whether two actions ask for the same, wherever it comes from. */
export function same_action(a: Float64Array, b: Float64Array): boolean {
  for (let f = 0; f < a.length; ++f) if (!same_value(a[f]!, b[f]!)) return false;
  return true;
}

export function same(a: Proposal, b: Proposal): boolean {
  return a === b || a.status === b.status && a.vote === b.vote && a.leader === b.leader &&
    same_suppliers(a.supplier, b.supplier) && same_action(a.action, b.action);
}
