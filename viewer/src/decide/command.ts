// SPDX-License-Identifier: MIT
/** How to ask the program what is asked of the page. */
import type { ActionField, Run, TreeNode } from '../run/run.ts';
import { completed } from './choices.ts';
import { kAll, type Change } from './retrace.ts';
import { about_field, flown_text, is_grouped, unit_of, with_unit } from './units.ts';

/** A word of a shell's command line. */
function quoted(text: string): string {
  return `'${text.replaceAll("'", "'\\''")}'`;
}

/** The tree that a player begins with; a path without the name of a tree is about it. */
function first_tree(run: Run, player: number): number {
  const first = run.players[player]!.decisions.shape[0];
  return first === undefined ? -1 : run.shapes[first]!.tree;
}

/** "bounds={altitude: {min: 1000 ft}}": limits and axes are given whole. */
function groups(own: TreeNode['params'], given: Record<string, number | string>, fields: readonly ActionField[]): string[] {
  const groups = new Map<string, Map<string, string[]>>();
  const asked = Object.keys(given).map((name) => about_field(name)?.group);
  for (const name of new Set([...Object.keys(own), ...Object.keys(given)])) {
    const about = about_field(name);
    if (!about || !asked.includes(about.group)) continue;
    const value = name in given ? with_unit(given[name]!, unit_of(name, fields).symbol) : flown_text(name, own[name] as number, fields);
    const group = groups.get(about.group) ?? new Map<string, string[]>();
    groups.set(about.group, group.set(about.field, [...(group.get(about.field) ?? []), `${about.part}: ${value}`]));
  }
  return [...groups].map(([group, all]) => `${group}={${[...all].map(([field, parts]) => `${field}: {${parts.join(', ')}}`).join(', ')}}`);
}

function sets_of(run: Run, change: Change, own_tree: number): string[] {
  const { tree, node, type, vote, params: given = {} } = completed(run, change);
  const { name, nodes, kind } = run.trees[tree]!;
  const { type: was, params } = nodes[node]!;
  const fields = run.platforms[kind].action;
  const path = `${tree === own_tree ? '' : `${name}:`}${nodes[node]!.path}`;
  const replaced = type !== undefined && type !== was;
  const own = replaced ? {} : params;
  const plain = Object.entries(given).filter(([key, value]) => !is_grouped(key) && (value !== kAll || typeof params[key] === 'number'));
  return [
    ...(replaced ? [`${path}=${type}`] : []),
    ...plain.map(([key, value]) => `${path}.${key}=${value === kAll ? 'null' : with_unit(value, unit_of(key, fields).symbol)}`),
    ...groups(own, given, fields).map((set) => `${path}.${set}`),
    ...(vote !== undefined ? [`${path}.vote=${vote}`] : []),
  ];
}

/** The same question for the terminal; RUN stands for the folder of the run. */
export function command_of(run: Run, player: number, changes: readonly Change[]): string {
  const own_tree = first_tree(run, player);
  const sets = changes.flatMap((change) => sets_of(run, change, own_tree));
  return ['eyrie whatif RUN', `--player ${run.players[player]!.name}`, ...sets.map((set) => `--set ${quoted(set)}`)].join(' ');
}
