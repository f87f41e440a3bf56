// SPDX-License-Identifier: MIT
/** How a node decides, and what several kinds of nodes share: src/ubf/merging.hpp. */
import type { ActionField, TreeNode } from '../run/run.ts';
import type { Proposal } from './proposal.ts';

export type Params = TreeNode['params'];

/** Makes `out`, which arrives cleared, of what the children answered, in the order of the tree. Returns
 * kDone, or the position of a child that it would have to ask and that was not asked. */
export interface Decider {
  /** `now` in s, for those who remember. */
  (children: readonly Proposal[], out: Proposal, now: number): number;
  /** Loses what it remembers, as after a tick in which it was not asked; who remembers nothing has none. */
  forget?: () => void;
}
export const kDone = -1;

/** Makes a Decider for a node with these children (nodes of the tree); null: not with these parameters. */
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
