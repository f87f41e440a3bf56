// SPDX-License-Identifier: MIT
/** Which arbiters the page can put in a composite's place, and how to ask the program the same. */
import type { ActionField, Run, Tree, TreeNode } from '../run/run.ts';
import { kArbiters } from './arbitrate.ts';
import { kAll, type Change } from './retrace.ts';

export interface ParamChoice {
  name: string;
  /** Of its number; "" for none. */
  unit: string;
  values: (string | number)[] | { min: number; max: number };
  value: string | number;
}
export interface ArbiterChoice {
  type: string;
  params: ParamChoice[];
}

/** Arbiters that the page cannot put anywhere but can replace: all that just have children. */
const kReplaceable: ReadonlySet<string> = new Set(['weighted_random', 'verify', 'vote_grid', 'utility']);
/** StrongestFew keeps no more. */
const kMostTop = 8;

/** The program asks for units. */
const kUnits: Record<string, string> = { min_time: 's', hold: 's' };

function param(node: TreeNode, name: string, values: ParamChoice['values'], otherwise: string | number): ParamChoice {
  const given = node.params[name];
  return { name, unit: kUnits[name] ?? '', values, value: typeof given === 'number' || typeof given === 'string' ? given : otherwise };
}

/** The parameters of an arbiter at this node; null: it is none for these fields. */
function params_of(type: string, node: TreeNode, fields: readonly ActionField[]): ParamChoice[] | null {
  const tops = Array.from({ length: Math.min(node.children.length, kMostTop) }, (_, i) => i + 1);
  switch (type) {
    case 'fusion':
      return [param(node, 'top', [kAll, ...tops], kAll), param(node, 'conflicts', ['blend', 'drop'], 'blend')];
    case 'paper_fusion':
      return [param(node, 'high_vote', { min: 0, max: 100 }, 50)];
    case 'motor_schema': {
      const angles = fields.filter((f) => f.blend === 'angle').map((f) => f.name);
      const lengths = fields.filter((f) => f.blend === 'mean').map((f) => f.name);
      if (angles.length === 0 || lengths.length === 0) return null;
      const speed = lengths.includes('speed') ? 'speed' : lengths[0]!;
      return [
        param(node, 'direction', angles, angles[0]!),
        param(node, 'magnitude', lengths, speed),
        param(node, 'unit_vote', { min: 1, max: 100 }, 40),
      ];
    }
    case 'commitment':
      return [
        param(node, 'margin', { min: 0, max: 100 }, 5),
        param(node, 'min_time', { min: 0, max: 60 }, 0),
        param(node, 'hold', { min: 0, max: 60 }, 0),
      ];
    default:
      return [];
  }
}

/** Arbiters that are nothing without parameters. */
const kDemanding: ReadonlySet<string> = new Set(['paper_fusion', 'motor_schema', 'commitment']);

/** The node's own arbiter first; nothing for nodes that are no arbiter, or one of another build. */
export function arbiters_for(run: Run, tree: Tree, node: number): ArbiterChoice[] {
  const at = tree.nodes[node]!;
  if (!(at.type in kArbiters) && !kReplaceable.has(at.type)) return [];
  const fields = run.platforms[tree.kind].action;
  const types = [at.type, ...Object.keys(kArbiters).filter((type) => type !== at.type)];
  return types.flatMap((type) => {
    const params = params_of(type, at, fields);
    return params ? [{ type, params }] : [];
  });
}

/** Arbiters that need them have all parameters, those that were not given as arbiters_for says. */
export function complete(run: Run, change: Change): Change {
  const { nodes, kind } = run.trees[change.tree]!;
  const { type, node } = change;
  if (type === undefined || !kDemanding.has(type) || type === nodes[node]!.type) return change;
  const params = params_of(type, nodes[node]!, run.platforms[kind].action) ?? [];
  return { ...change, params: { ...Object.fromEntries(params.map(({ name, value }) => [name, value])), ...change.params } };
}

/** A word of a shell's command line. */
function quoted(text: string): string {
  return `'${text.replaceAll("'", "'\\''")}'`;
}

/** The tree that a player begins with; a path without the name of a tree is about it. */
function first_tree(run: Run, player: number): number {
  const first = run.players[player]!.decisions.shape[0];
  return first === undefined ? -1 : run.shapes[first]!.tree;
}

/** The same question for the terminal; RUN stands for the folder of the run. */
export function command_of(run: Run, player: number, changes: readonly Change[]): string {
  const own_tree = first_tree(run, player);
  const sets = changes.flatMap((change) => {
    const { tree, node, type, vote, params } = complete(run, change);
    const { name, nodes } = run.trees[tree]!;
    const { type: was, params: own } = nodes[node]!;
    const path = `${tree === own_tree ? '' : `${name}:`}${nodes[node]!.path}`;
    const given = Object.entries(params ?? {})
      .filter(([name, value]) => value !== kAll || typeof own[name] === 'number')
      .map(([name, value]) => [name, value === kAll ? 'null' : value] as const);
    return [
      ...(type !== undefined && type !== was ? [`${path}=${type}`] : []),
      ...given.map(([name, value]) => `${path}.${name}=${value}${kUnits[name] ? ` ${kUnits[name]}` : ''}`),
      ...(vote !== undefined ? [`${path}.vote=${vote}`] : []),
    ];
  });
  return ['eyrie whatif RUN', `--player ${run.players[player]!.name}`, ...sets.map((set) => `--set ${quoted(set)}`)].join(' ');
}
