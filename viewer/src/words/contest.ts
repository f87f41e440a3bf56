// SPDX-License-Identifier: MIT
/** One decision in words and numbers, as `eyrie explain` tells it: src/debrief/why.cpp. */
import { source_of, type Run, type Shape, type Tree } from '../run/run.ts';
import { general } from './text.ts';

/** Somebody who proposed a field that another one won. */
export interface Rival {
  node: number;
  value: number;
  /** The votes that stood against each other where both were compared: of the branch with the rival, and of
   * the branch with the winner. */
  vote: number;
  against: number;
  decided_by: string;  // What decided there; empty: these votes.
  /** Whether its branch brought the field up to there, neither lost it below nor abstained. */
  came_up: boolean;
  /** The winner made its value of this one and others. */
  blended: boolean;
}
export interface Won {
  field: number;  // Index into the platform's action.
  value: number;
  winner: number;
  blended: boolean;  // The winner is an arbiter that made it of what its children said.
  held: boolean;  // The winner proposed it earlier, and a node above holds it.
  reason: string;
  rivals: Rival[];  // What a blend is made of, then those that came up, then the others; by vote, the highest first.
}

/** Whether a node, or somebody below it, proposes a field now. */
function proposes(shape: Shape, node: number, field: number): boolean {
  return (shape.supplier[node]?.[field] ?? -1) >= 0;
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

/** What decided between the branches in which two nodes part; empty: their votes. */
function decided_by({ nodes }: Tree, a: number, b: number): string {
  return nodes[nodes[nodes[a]!.depth > nodes[b]!.depth ? a : b]!.parent]!.decided_by;
}

/** Whether the field that an arbiter blended is made of what a leaf proposed. */
function is_part(tree: Tree, shape: Shape, leaf: number, arbiter: number, field: number): boolean {
  return tree.nodes[arbiter]!.children.some((child) => {
    const from = shape.supplier[child]?.[field] ?? -1;
    return from >= 0 && shape.counted[child]! > 0
      && (from === leaf || (tree.nodes[from]!.children.length > 0 && is_part(tree, shape, leaf, from, field)));
  });
}

/** What decided in the place of votes. */
function decided(by: string): string {
  return by ? `, and ${by} decided` : ', and votes did not decide';
}

/** "voted 40 against 10", or how else a field was won. */
export function reason({ held, rivals }: Pick<Won, 'held' | 'rivals'>): string {
  if (held) return 'held from an earlier decision';
  const next = rivals[0];
  if (!next) return 'nobody else asked for it';
  if (next.blended) return `blended of ${rivals.filter((one) => one.blended).length}`;
  if (!next.came_up) return "nobody else's came up to it";
  const [mine, its] = [general(next.against), general(next.vote)];
  if (next.decided_by || next.vote > next.against) return `${mine} against ${its}${decided(next.decided_by)}`;
  return next.against > next.vote ? `voted ${mine} against ${its}` : `voted ${its} as the other did, and comes first`;
}

/** One decision of a player: who won each field of the action, and against whom. */
export function contest(run: Run, player: number, index: number): Won[] {
  const { decisions } = run.players[player]!;
  const shape = run.shapes[decisions.shape[index]!]!;
  const tree = run.trees[shape.tree]!;
  const value = (node: number, field: number) => decisions.value(node, field)?.[index] ?? NaN;

  const won = (winner: number, field: number): Won => {
    const held = shape.held[0]![field]!;
    const blended = !held && tree.nodes[winner]!.children.length > 0;
    const rivals = tree.nodes.flatMap(({ children }, node): Rival[] => {
      if (node === winner || children.length > 0 || !proposes(shape, node, field)) return [];
      let [its, mine] = parting(tree, node, winner);
      const by = decided_by(tree, its, mine);
      while (!proposes(shape, mine, field) || shape.held[mine]![field] !== held) mine = tree.nodes[mine]!.parent; // up to who holds it; the root has it
      const [vote, against] = [shape.counted[its]!, shape.counted[mine]!];
      return [{
        node, value: value(node, field), vote, against, decided_by: by,
        came_up: proposes(shape, its, field) && (vote > 0 || against === 0), blended: blended && is_part(tree, shape, node, winner, field),
      }];
    });
    rivals.sort((a, b) => +b.blended - +a.blended || +b.came_up - +a.came_up || b.vote - a.vote || a.node - b.node);
    return { field, value: value(source_of(shape, 0, field), field), winner, blended, held, reason: reason({ held, rivals }), rivals };
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

/** Which conditions made a node hold, or what made it fail: itself, or what is below one that has no words of its own. */
function causes(tree: Tree, shape: Shape, node: number, answer: 'success' | 'failure'): number[] {
  const proposes_some = shape.supplier[node]?.some((supplier) => supplier >= 0);
  if (shape.status[node] !== answer || (answer === 'success' && proposes_some)) return [];
  const { label, type, children } = tree.nodes[node]!;
  const all = label === type ? children.flatMap((child) => causes(tree, shape, child, answer)) : [];
  return all.length ? all : [node];
}

/** Because of what a node was not asked: what the sibling that was asked last has to say, if that failed. */
function because_of(tree: Tree, shape: Shape, left: number, parent: number): string {
  const before = tree.nodes[parent]?.children.filter((child) => child < left && (shape.status[child] ?? null) !== null).at(-1);
  const failed = before === undefined ? [] : causes(tree, shape, before, 'failure').map((node) =>
    `${tree.nodes[node]!.label} ${shape.why[node] === 'does not hold' ? 'does not hold' : answer_words(shape, node)}`);
  return failed.length ? `: ${failed.join(', ')}` : '';
}

/** Where a sequencer went, and because of what: " for wvr: in_sight holds". */
function transition(tree: Tree, shape: Shape, sequencer: number): string {
  let to = '';
  let because = '';
  for (const child of tree.nodes[sequencer]!.children) {
    if (shape.status[child] === null) continue;
    if (shape.vote[child]! > 0) to = ` for ${tree.nodes[child]!.label}`;
    else because += causes(tree, shape, child, 'success').map((one, i) => `${because || i ? ', ' : ': '}${tree.nodes[one]!.label} holds`).join('');
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
      : `${label} was not asked${because_of(tree, shape, left, parent)}`;
  }
  if (shape.status[before] === 'failure') return `${then.label} ${answer_words(shape, before)}`;
  if (shape.leader < 0 || shape.status[parting(tree, shape.leader, before)[1]] === 'failure') {
    let last = before; // to which it came up
    while (shape.supplier[tree.nodes[last]!.parent]) last = tree.nodes[last]!.parent;
    const by = tree.nodes[last]!.parent;
    const keeper = tree.nodes[by];
    return keeper && shape.supplier[last]
      ? `${then.label} was kept back by ${keeper.label}${shape.why[by] ? `: ${shape.why[by]}` : ''}`
      : `${then.label} proposed nothing`;
  }
  const [mine, its] = parting(tree, shape.leader, before);
  const [voted, against] = [shape.counted[its]!, shape.counted[mine]!];
  // the first above it that handed on another one's instead
  const hands_on = (node: number) => shape.supplier[node]?.some((from) => from === before || (from >= 0 && tree.nodes[from]!.children.length > 0));
  let lost = before;
  while (lost !== its && (lost === before || hands_on(lost))) lost = tree.nodes[lost]!.parent;
  const came_up = !shape.supplier[before]?.some((from) => from >= 0) || lost === before || hands_on(lost);
  const by = decided_by(tree, mine, its);
  return `${then.label}${came_up ? '' : ` lost in ${tree.nodes[lost]!.label}, which`} voted ${general(voted)} against ${general(against)}${by || voted > against ? decided(by) : voted === against ? ', and comes later' : ''}`;
}
