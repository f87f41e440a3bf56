// SPDX-License-Identifier: MIT
/** A small run with one player, whose tree and answers a test writes down. */
import type { ActionField, Player, Run, Shape, Status, Tree, TreeNode } from '../src/run/run.ts';

export const kFields: ActionField[] = [
  { name: 'heading', unit: 'rad', form: 'direction', kind: 'number' },
  { name: 'altitude', unit: 'm', form: 'height', kind: 'number' },
  { name: 'speed', unit: 'm/s', form: 'quantity', kind: 'number' },
  { name: 'mode', unit: '', form: 'quantity', kind: 'text' },
  { name: 'target', unit: '', form: 'quantity', kind: 'id' },
  { name: 'trigger', unit: '', form: 'quantity', kind: 'flag' },
];
export type FieldName = 'heading' | 'altitude' | 'speed' | 'mode' | 'target' | 'trigger';
/** What a leaf says; by default it is running. */
export type Said = { status?: Status; vote?: number } & { [K in FieldName]?: number };

/** What a node answered. */
export interface Proposal {
  /** Null: it was not asked. */
  status: Status | null;
  vote: number;
  /** By field; NaN: not set. */
  action: Float64Array;
  /** By field the node that supplied it; -1: not set. */
  supplier: Int16Array;
  held?: boolean[];
  leader: number;
}

function make_proposal(fields: number): Proposal {
  return { status: null, vote: 0, action: new Float64Array(fields).fill(NaN), supplier: new Int16Array(fields).fill(-1), leader: -1 };
}

export interface NodeSpec {
  label: string;
  type: string;
  params: TreeNode['params'];
  remembers: boolean;
  children: NodeSpec[];
}
type Options = { params?: TreeNode['params']; remembers?: boolean };

/** A composite, labelled "bvr" of the type "per_field". */
export function node(label: string, type: string, children: NodeSpec[], { params = {}, remembers = false }: Options = {}): NodeSpec {
  return { label, type, params, remembers, children };
}
export function leaf(label: string, { params = {}, remembers = false }: Options = {}): NodeSpec {
  return { label, type: label, params, remembers, children: [] };
}

export function tree_of(root: NodeSpec): Tree {
  const nodes: TreeNode[] = [];
  const add = ({ label, type, params, remembers, children }: NodeSpec, parent: number, depth: number, path: string): number => {
    const kind = children.length ? 'arbiter' : 'behavior';
    const index = nodes.push({ label, type, params, remembers, kind, parent, depth, path, children: [] }) - 1;
    nodes[index]!.children = children.map((child) => add(child, index, depth + 1, `${path}/${child.label}`));
    return index;
  };
  add(root, -1, 0, 'root');
  return { name: 'test', kind: 'aircraft', nodes };
}

export function proposal(said: Said, node_index: number): Proposal {
  const out = make_proposal(kFields.length);
  out.status = said.status ?? 'running';
  if (out.status === 'failure') return out;
  out.vote = Math.fround(said.vote ?? 0);
  kFields.forEach(({ name }, f) => {
    const value = said[name as FieldName];
    if (value === undefined) return;
    out.action[f] = value;
    out.supplier[f] = node_index;
  });
  if (out.vote > 0 || out.supplier.some((s) => s >= 0)) out.leader = node_index;
  return out;
}

/** What the highest vote says, of the whole action or field by field, or a mean that is the node's own: enough for trees
 * that are written down. */
function decided(type: string, kids: Proposal[], node_index: number): Proposal {
  const asked = kids.filter(({ status }) => status !== null && status !== 'failure').sort((a, b) => b.vote - a.vote);
  const out = make_proposal(kFields.length);
  const first = asked[0];
  if (!first) return { ...out, status: 'failure' };
  for (const from of type === 'winner_takes_all' ? [first] : asked)
    from.supplier.forEach((supplier, f) => {
      if (supplier < 0 || out.supplier[f]! >= 0) return;
      const all = asked.filter((one) => one.supplier[f]! >= 0);
      const blends = type === 'fusion' && all.length > 1;
      const votes = all.reduce((sum, one) => sum + one.vote, 0);
      out.supplier[f] = blends ? node_index : supplier;
      out.action[f] = blends ? all.reduce((sum, one) => sum + one.action[f]! * one.vote, 0) / votes : from.action[f]!;
    });
  return { ...out, status: first.status, vote: first.vote, leader: first.leader };
}

/** All answers of a tree: those that are said, by label, and of other composites what follows. Who is not named was not
 * asked. */
export function answers(tree: Tree, said: Record<string, Said>): Proposal[] {
  const all: Proposal[] = [];
  for (let i = tree.nodes.length - 1; i >= 0; --i) {
    const { label, type, children } = tree.nodes[i]!;
    const own = said[label];
    const kids = children.map((child) => all[child]!);
    const follows = !own && kids.length > 0 && kids[0]!.status !== null;
    all[i] = own ? proposal(own, i) : follows ? decided(type, kids, i) : make_proposal(kFields.length);
  }
  return all;
}

function shape_of(all: Proposal[]): Shape {
  return {
    tree: 0,
    leader: all[0]!.leader,
    status: all.map((p) => p.status),
    vote: all.map((p) => p.vote),
    why: all.map(() => ''),
    supplier: all.map((p) => (p.supplier.some((s) => s >= 0) ? Int16Array.from(p.supplier) : null)),
    held: all.map((p) => (p.supplier.some((s) => s >= 0) ? (p.held ?? Array.from(p.supplier, () => false)) : null)),
    won: [],
  };
}

/** A run with a decision every 0.1 s. `more` is what a test knows better of each shape. What is said by the same
 * object has one shape. */
export function run_of(root: NodeSpec, decisions: Record<string, Said>[], more: (all: Proposal[], tree: Tree) => void = () => {}): Run {
  const tree = tree_of(root);
  const kinds = [...new Set(decisions)];
  const all = kinds.map((said) => answers(tree, said));
  all.forEach((one) => more(one, tree));
  const shape = Int32Array.from(decisions, (said) => kinds.indexOf(said));
  const columns = new Map<string, Float64Array>();
  const sets = (s: number, n: number, f: number) => (all[s]![n]!.held?.[f] ? n === 0 : all[s]![n]!.supplier[f] === n);
  const column = (n: number, f: number) => Float64Array.from(shape, (s) => (sets(s, n, f) ? all[s]![n]!.action[f]! : NaN));
  const value = (n: number, f: number): Float64Array => {
    const key = `${n}/${f}`;
    if (!columns.has(key)) columns.set(key, column(n, f));
    return columns.get(key)!;
  };
  const t = Float64Array.from(decisions, (_, i) => i / 10);
  const decided = { t, step: t.map((time) => Math.round(time * 50)), shape, why_not: shape.map(() => -1), value };
  const player = { index: 0, name: 'eagle2', kind: 'aircraft', decisions: decided };
  const platform = { action: kFields, state: [] };
  return {
    players: [player as unknown as Player], trees: [tree], shapes: all.map(shape_of), platforms: { aircraft: platform, vehicle: platform },
    texts: ['hold', 'follow', 'lead'], about: { thinned: false },
  } as unknown as Run;
}

/** The index of the node with that label. */
export function find(run: Run, label: string): number {
  return run.trees[0]!.nodes.findIndex((n) => n.label === label);
}
