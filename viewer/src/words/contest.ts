// SPDX-License-Identifier: MIT
/** One decision in words and numbers, as `eyrie explain` tells it: src/debrief/decision.cpp. */
import type { Run, Shape, Tree } from '../run/run.ts';
import { general } from './text.ts';

/** Somebody who proposed a field that another one won. */
export interface Rival {
  node: number;
  value: number;
  /** The votes that stood against each other where both were compared: of the branch with the rival, and of
   * the branch with the winner. */
  vote: number;
  against: number;
}
export interface Won {
  field: number;  // Index into the platform's action.
  value: number;
  winner: number;
  blended: boolean;  // The winner is an arbiter that made it of what its children said.
  reason: string;
  rivals: Rival[];  // By vote, the highest first; what a blend is made of, too.
}

/** The branches in which two nodes are where their ways from the root part. Of two of which one is above
 * the other, the upper one is itself. */
export function parting(tree: Tree, a: number, b: number): [number, number] {
  const at: [number, number] = [a, b];
  while (a !== b) {
    if (tree.nodes[a]!.depth >= tree.nodes[b]!.depth) {
      at[0] = a;
      a = tree.nodes[a]!.parent;
    } else {
      at[1] = b;
      b = tree.nodes[b]!.parent;
    }
  }
  return at;
}

/** "voted 40 against 10", or how else a field was won. */
export function reason({ blended, rivals }: Pick<Won, 'blended' | 'rivals'>): string {
  const next = rivals[0];
  if (!next) return 'nobody else asked for it';
  if (blended) return `blended of ${rivals.length}`;
  const [mine, its] = [general(next.against), general(next.vote)];
  if (next.against > next.vote) return `voted ${mine} against ${its}`;
  return next.against === next.vote
    ? `voted ${its} as the other did, and comes first`
    : `${mine} against ${its}, by its place in the tree`;
}

/** One decision of a player: who won each field of the action, and against whom. */
export function contest(run: Run, player: number, index: number): Won[] {
  const { decisions } = run.players[player]!;
  const shape = run.shapes[decisions.shape[index]!]!;
  const tree = run.trees[shape.tree]!;
  const value = (node: number, field: number) => decisions.value(node, field)?.[index] ?? NaN;

  const won = (winner: number, field: number): Won => {
    const rivals = tree.nodes.flatMap(({ children }, node): Rival[] => {
      if (node === winner || children.length > 0 || !(shape.supplier[node]?.[field]! >= 0)) return [];
      const [its, mine] = parting(tree, node, winner);
      return [{ node, value: value(node, field), vote: shape.counted[its]!, against: shape.counted[mine]! }];
    });
    rivals.sort((a, b) => b.vote - a.vote || a.node - b.node);
    const blended = tree.nodes[winner]!.children.length > 0;
    return { field, value: value(winner, field), winner, blended, reason: reason({ blended, rivals }), rivals };
  };
  return Array.from(shape.supplier[0] ?? []).flatMap((winner, field) => (winner >= 0 ? won(winner, field) : []));
}

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

/** Where a sequencer went, and because of what: " for wvr: in_sight holds". */
function transition(tree: Tree, shape: Shape, sequencer: number): string {
  let to = '';
  let because = '';
  for (const child of tree.nodes[sequencer]!.children) {
    if (shape.status[child] === null) continue;
    const { label } = tree.nodes[child]!;
    if (shape.vote[child]! > 0) to = ` for ${label}`;
    else if (shape.status[child] === 'success' && !shape.supplier[child]?.some((supplier) => supplier >= 0)) because += `${because ? ', ' : ': '}${label} holds`;
  }
  return to + because;
}

/** Why somebody else leads now: what became of who led before, a node of the tree. */
export function why_not(tree: Tree, shape: Shape, before: number): string {
  const then = tree.nodes[before];
  if (!then) return 'nobody led';
  const asked = (node: number) => shape.status[node] !== null;
  if (!asked(before)) {
    let left = before; // the highest node that was not asked
    while (tree.nodes[left]!.parent >= 0 && !asked(tree.nodes[left]!.parent)) left = tree.nodes[left]!.parent;
    const { label, parent } = tree.nodes[left]!;
    return parent >= 0 && tree.nodes[parent]!.type === 'sequencer'
      ? `${label} was left${transition(tree, shape, parent)}`
      : `${label} was not asked`;
  }
  if (shape.status[before] === 'failure') return `${then.label} ${answer_words(shape, before)}`;
  if (shape.leader < 0) return `${then.label} proposed nothing`;
  const [mine, its] = parting(tree, shape.leader, before);
  return `${then.label} voted ${general(shape.counted[its]!)} against ${general(shape.counted[mine]!)}`;
}
