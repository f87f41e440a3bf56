// SPDX-License-Identifier: MIT
/** What a node answered, and whose recommendation led, in words. */
import type { Run, Shape } from '../run/run.ts';
import { general } from './text.ts';

/** What a node has to say of itself: "failed: no target", "not asked", "running, votes 40". */
export function answer_words(shape: Shape, node: number): string {
  const status = shape.status[node] ?? null;
  if (status === null) return 'not asked';
  if (status === 'failure') return shape.why[node] ? `failed: ${shape.why[node]}` : 'failed';
  return shape.vote[node]! > 0 ? `${status}, votes ${general(shape.vote[node]!)}` : status;
}

/** The nodes from the leader up to the root. */
export function path_of_leader(run: Run, shape: Shape): Set<number> {
  const way = new Set<number>();
  const { nodes } = run.trees[shape.tree]!;
  for (let node = shape.leader; node >= 0; node = nodes[node]!.parent) way.add(node);
  return way;
}
