// SPDX-License-Identifier: MIT
/** How a node decides, and what several kinds of nodes share: src/ubf/merging.hpp. */
import type { ActionField, TreeNode } from '../run/run.ts';
import { copy, is_heard, type Proposal } from './proposal.ts';

export type Params = TreeNode['params'];

/** When it is decided, for those who remember, and what of the state conditions read. */
export interface Moment {
  /** s */
  t: number;
  /** A field of the platform's state; NaN: it has no value. */
  state(field: number): number;
}

/** Makes `out`, which arrives cleared, of what the children answered, in the order of the tree. Returns
 * kDone, or the position of a child that it would have to ask and that was not asked. */
export interface Decider {
  (children: readonly Proposal[], out: Proposal, moment: Moment): number;
  /** Loses what it remembers, as after a tick in which it was not asked; who remembers nothing has none. */
  forget?: () => void;
}
export const kDone = -1;

/** Makes a Decider for a node with these children (nodes of the tree); null: it cannot be with these parameters. */
export type Maker = (params: Params, fields: readonly ActionField[], children: readonly number[]) => Decider | null;

/** Each field from the highest vote that set it, the earlier of equals, of those that `counts`. */
export function merge_fields(children: readonly Proposal[], out: Proposal, counts: (child: Proposal) => boolean): void {
  for (let f = 0; f < out.action.length; ++f) {
    let vote = -1;
    for (const child of children) {
      if (!counts(child) || Number.isNaN(child.action[f]!) || !(child.vote > vote)) continue;
      vote = child.vote;
      out.action[f] = child.action[f]!;
      out.supplier[f] = child.supplier[f]!;
    }
  }
}

/** The child with the highest vote, the earlier of equals. */
export function strongest_of(children: readonly Proposal[]): Proposal | null {
  let strongest: Proposal | null = null;
  for (const child of children) if (is_heard(child) && !(strongest && child.vote <= strongest.vote)) strongest = child;
  return strongest;
}

/** Vote and status of what several were mixed to are those of the strongest. */
export function as_strongest(children: readonly Proposal[], out: Proposal): Proposal | null {
  const strongest = strongest_of(children);
  out.status = strongest ? strongest.status : 'failure';
  out.vote = strongest ? strongest.vote : 0;
  return strongest;
}

/** All arbiters ask every child every time. */
export function asks_all(decide: (children: readonly Proposal[], out: Proposal, moment: Moment) => void): Decider {
  return (children, out, moment) => {
    for (let i = 0; i < children.length; ++i) if (children[i]!.status === null) return i;
    decide(children, out, moment);
    return kDone;
  };
}

/** Hands on what a child said; nobody's is a failure. */
export function take(winner: Proposal | null | undefined, out: Proposal): void {
  if (winner) copy(winner, out);
  else out.status = 'failure';
}
