// SPDX-License-Identifier: MIT
/** What is asked of a tree instead of what was flown, in the words of `eyrie whatif --set`. */
import type { Run } from '../run/run.ts';

export interface Change {
  /** Index into Run.trees. */
  tree: number;
  node: number;
  /** Another type for the node. */
  type?: string;
  /** Values of parameters as a file has them: "30", "12 nmi", "{heading: {min: 0 deg}}". */
  params: Record<string, string>;
}

/** The tree that a player begins with; a path without the name of a tree is about it. */
function first_tree(run: Run, player: number): number {
  const first = run.players[player]!.decisions.shape[0];
  return first === undefined ? -1 : run.shapes[first]!.tree;
}

export function sets_of(run: Run, player: number, changes: readonly Change[]): string[] {
  const own = first_tree(run, player);
  return changes.flatMap(({ tree, node, type, params }) => {
    const { name, nodes } = run.trees[tree]!;
    const path = `${tree === own ? '' : `${name}:`}${nodes[node]!.path}`;
    return [...(type === undefined ? [] : [`${path}=${type}`]), ...Object.entries(params).map(([key, value]) => `${path}.${key}=${value}`)];
  });
}

/** A word of a shell's command line. */
function quoted(text: string): string {
  return `'${text.replaceAll("'", "'\\''")}'`;
}

/** The same question for the terminal; RUN stands for the folder of the run. */
export function command_of(run: Run, player: number, changes: readonly Change[]): string {
  const sets = sets_of(run, player, changes).map((set) => `--set ${quoted(set)}`);
  return ['eyrie whatif RUN', `--player ${run.players[player]!.name}`, ...sets].join(' ');
}
