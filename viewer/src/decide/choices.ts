// SPDX-License-Identifier: MIT
/** Which arbiters the page can put in a composite's place, and with which parameters. */
import type { ActionField, Run, Tree, TreeNode } from '../run/run.ts';
import { kArbiters } from './arbitrate.ts';
import { axes_named } from './grid.ts';
import { kAll, type Change } from './retrace.ts';
import { about_field, is_grouped, to_shown, unit_of } from './units.ts';

type Given = Record<string, number | string>;

/** Values are in the units that people give. */
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
const kReplaceable: ReadonlySet<string> = new Set(['weighted_random']);
/** StrongestFew keeps no more. */
const kMostTop = 8;

/** What can be asked of a field, by its SI unit: a range, limits and candidates to begin with, in the units that people give. */
interface Range {
  min: number;
  max: number;
  from: number;
  to: number;
  steps: number;
  reach: number;
  limits: [number, number];
}
const kRanges: Record<string, Range> = {
  rad: { min: 0, max: 720, from: 0, to: 360, steps: 36, reach: 60, limits: [0, 180] },
  m: { min: 0, max: 60000, from: 0, to: 50000, steps: 51, reach: 10000, limits: [0, 50000] },
  'm/s': { min: 0, max: 1500, from: 100, to: 900, steps: 41, reach: 200, limits: [100, 900] },
};
const kOtherRange: Range = { min: -20, max: 20, from: 1, to: 9, steps: 17, reach: 3, limits: [1, 9] };

function range_of({ unit }: ActionField): Range {
  return kRanges[unit] ?? kOtherRange;
}

/** The fields that arbiters with limits or a grid can be about. */
function real_fields(fields: readonly ActionField[]): ActionField[] {
  return fields.filter(({ kind, blend }) => kind === 'number' && (blend === 'angle' || blend === 'mean'));
}

/** What is asked of one node. */
class Asker {
  constructor(private readonly node: TreeNode, readonly fields: readonly ActionField[], readonly type: string, readonly given: Given) {}

  /** It flew as this type, and has the parameters of the file. */
  get is_flown(): boolean {
    return this.type === this.node.type;
  }
  get flown(): TreeNode['params'] {
    return this.is_flown ? this.node.params : {};
  }
  get children(): number {
    return this.node.children.length;
  }
  param(name: string, values: ParamChoice['values'], otherwise: string | number): ParamChoice {
    const unit = unit_of(name, this.fields);
    const flown = this.flown[name];
    const value = typeof flown === 'number' ? to_shown(flown, unit) : typeof flown === 'string' ? flown : otherwise;
    return { name, unit: unit.symbol, values, value };
  }
  /** The choice of the field that a new arbiter is about, first, and that field. */
  about(group: string): { choice: ParamChoice; field: ActionField } | null {
    const real = real_fields(this.fields);
    if (!real.length) return null;
    const choice = this.param(`${group}.field`, real.map((f) => f.name), real[0]!.name);
    const wanted = this.given[choice.name] ?? choice.value;
    return { choice, field: real.find((f) => f.name === wanted) ?? real[0]! };
  }
  field(name: string): ActionField {
    return this.fields.find((f) => f.name === name)!;
  }
}

function verify_params(asker: Asker): ParamChoice[] | null {
  const fallback = asker.children > 1 ? [asker.param('fallback', ['false', 'true'], 'false')] : [];
  const limit = (field: ActionField, part: 'min' | 'max'): ParamChoice => {
    const { min, max, limits } = range_of(field);
    return asker.param(`bounds.${field.name}.${part}`, { min, max }, limits[part === 'min' ? 0 : 1]);
  };
  if (!asker.is_flown) {
    const about = asker.about('bounds');
    return about && [about.choice, limit(about.field, 'min'), limit(about.field, 'max'), ...fallback];
  }
  const limits = Object.keys(asker.flown).flatMap((name) => {
    const about = about_field(name);
    return about?.group === 'bounds' ? [limit(asker.field(about.field), about.part === 'min' ? 'min' : 'max')] : [];
  });
  return [...limits, ...fallback];
}

function grid_params(asker: Asker): ParamChoice[] | null {
  const axis = (field: ActionField): ParamChoice[] => {
    const { min, max, from, to, steps, reach } = range_of(field);
    const of = (part: string, values: ParamChoice['values'], value: number) => asker.param(`grid.${field.name}.${part}`, values, value);
    const spread = asker.type === 'utility' ? [of('spread', { min: 0, max: to - from }, 0)] : [];
    return [of('from', { min, max }, from), of('to', { min, max }, to), of('steps', { min: 2, max: 360 }, steps),
      of('reach', { min: 1, max: to - from }, reach), ...spread];
  };
  if (asker.is_flown) return axes_named(asker.flown).flatMap((name) => axis(asker.field(name)));
  const about = asker.about('grid');
  return about && [about.choice, ...axis(about.field)];
}

function schema_params(asker: Asker): ParamChoice[] | null {
  const angles = asker.fields.filter((f) => f.blend === 'angle').map((f) => f.name);
  const lengths = asker.fields.filter((f) => f.blend === 'mean').map((f) => f.name);
  if (angles.length === 0 || lengths.length === 0) return null;
  const speed = lengths.includes('speed') ? 'speed' : lengths[0]!;
  return [asker.param('direction', angles, angles[0]!), asker.param('magnitude', lengths, speed),
    asker.param('unit_vote', { min: 1, max: 100 }, 40)];
}

/** The parameters of an arbiter at this node; null: it is none for these fields. */
function params_of(asker: Asker): ParamChoice[] | null {
  const tops = Array.from({ length: Math.min(asker.children, kMostTop) }, (_, i) => i + 1);
  switch (asker.type) {
    case 'fusion':
      return [asker.param('top', [kAll, ...tops], kAll), asker.param('conflicts', ['blend', 'drop'], 'blend')];
    case 'paper_fusion':
      return [asker.param('high_vote', { min: 0, max: 100 }, 50)];
    case 'motor_schema':
      return schema_params(asker);
    case 'commitment':
      return [asker.param('margin', { min: 0, max: 100 }, 5), asker.param('min_time', { min: 0, max: 60 }, 0),
        asker.param('hold', { min: 0, max: 60 }, 0)];
    case 'verify':
      return verify_params(asker);
    case 'vote_grid':
    case 'utility':
      return grid_params(asker);
    default:
      return [];
  }
}

/** Arbiters that are nothing without parameters. */
const kDemanding: ReadonlySet<string> = new Set(['paper_fusion', 'motor_schema', 'commitment', 'verify', 'vote_grid', 'utility']);

/** The node's own arbiter first; nothing for nodes that are no arbiter, or one of another build. `given` are the
 * parameters that are asked already. */
export function arbiters_for(run: Run, tree: Tree, node: number, given: Given = {}): ArbiterChoice[] {
  const at = tree.nodes[node]!;
  if (!(at.type in kArbiters) && !kReplaceable.has(at.type)) return [];
  const fields = run.platforms[tree.kind].action;
  const types = [at.type, ...Object.keys(kArbiters).filter((type) => type !== at.type)];
  return types.flatMap((type) => {
    const params = params_of(new Asker(at, fields, type, given));
    return params ? [{ type, params }] : [];
  });
}

/** `given` with another value. What a new arbiter has no use for any more is left out, and what it needs is added. */
export function with_param(run: Run, tree: Tree, node: number, type: string, given: Given, name: string, value: string | number): Given {
  const next: Given = { ...given, [name]: value };
  const at = tree.nodes[node]!;
  if (type === at.type) return next;
  return whole(new Asker(at, run.platforms[tree.kind].action, type, next));
}

/** All parameters of an arbiter: those that are given, and else what it begins with. */
function whole(asker: Asker): Given {
  return Object.fromEntries((params_of(asker) ?? []).map(({ name, value }) => [name, asker.given[name] ?? value]));
}

/** A change in the units that people give, with all parameters of a new arbiter that is nothing without them. */
export function completed(run: Run, change: Change): Change {
  const { nodes, kind } = run.trees[change.tree]!;
  const { type, node, params: given = {} } = change;
  if (type === undefined || !kDemanding.has(type) || type === nodes[node]!.type) return change;
  return { ...change, params: whole(new Asker(nodes[node]!, run.platforms[kind].action, type, given)) };
}

/** A complete change in SI, as it is arbitrated by. */
export function in_si(run: Run, change: Change): Change {
  const { action } = run.platforms[run.trees[change.tree]!.kind];
  const all = completed(run, change);
  if (!all.params) return all;
  const params = Object.entries(all.params)
    .filter(([name]) => !is_grouped(name) || about_field(name)) // which field it is about stands in the others' names
    .map(([name, value]) => [name, typeof value === 'number' ? value * unit_of(name, action).factor : value] as const);
  return { ...all, params: Object.fromEntries(params) };
}

