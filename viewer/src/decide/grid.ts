// SPDX-License-Identifier: MIT
/** The arbiters that choose among the candidates of a grid: src/ubf/arbiter/vote_grid.hpp and utility.hpp. */
import type { ActionField } from '../run/run.ts';
import { kTau, wrap_pi, wrap_tau } from './angle.ts';
import { asks_all, as_strongest, merge_fields, type Maker, type Params } from './decider.ts';
import { is_heard, type Proposal } from './proposal.ts';

const kMostAxes = 3;
const kMostCandidates = 1024;
const kMostSteps = 360;
/** Sums that differ by less of what weighs in them are equal. */
const kRounding = 1e-12;

interface Axis {
  field: number;
  quantum: number;
  /** The candidates. */
  at: Float64Array;
  steps: number;
  reach: number;
  is_direction: boolean;
  is_circle: boolean;
  /** The probability that the outcome lies k steps off the command. */
  spread: number[];
  /** How much rounding in the page can move what a proposal is worth, of its weight. */
  doubt: number;
}

function spread_of(step: number, steps: number, deviation: number): number[] {
  if (!(deviation > 0)) return [1];
  const in_steps = deviation / step;
  const farthest = Math.min(Math.ceil(3 * in_steps), Math.floor((steps - 1) / 2));
  const out = [1];
  let total = 1;
  for (let k = 1; k <= farthest; ++k) {
    out.push(Math.exp(-0.5 * (k / in_steps) ** 2));
    total += 2 * out[k]!;
  }
  return out.map((p) => p / total);
}

/** The names of the fields on the grid, in the order of its axes. */
export function axes_named(params: Params): string[] {
  return Object.keys(params).flatMap((key) => /^grid\.(.+)\.from$/.exec(key)?.[1] ?? []);
}

function axis_of(params: Params, fields: readonly ActionField[], name: string): Axis | null {
  const field = fields.findIndex((f) => f.name === name && f.kind === 'number');
  const [from, to, steps, reach, spread = 0] = ['from', 'to', 'steps', 'reach', 'spread'].map((part) => params[`grid.${name}.${part}`]);
  if (field < 0 || typeof from !== 'number' || typeof to !== 'number' || typeof steps !== 'number' || typeof reach !== 'number' ||
      typeof spread !== 'number') return null;
  const is_direction = fields[field]!.blend === 'angle';
  const width = to - from;
  const fits = width > 0 && Number.isInteger(steps) && steps >= 2 && steps <= kMostSteps && reach > 0 && spread >= 0;
  if (!fits || (is_direction && width > kTau * (1 + 1e-9))) return null;
  const is_circle = is_direction && width > kTau * (1 - 1e-9);
  const step = width / (is_circle ? steps : steps - 1);
  const at = Float64Array.from({ length: steps }, (_, i) => (is_direction ? wrap_tau(from + i * step) : from + i * step));
  return {
    field, quantum: fields[field]!.quantum, at, steps, reach, is_direction, is_circle, spread: spread_of(step, steps, spread),
    doubt: (2 * fields[field]!.quantum) / reach,
  };
}

function axes_of(params: Params, fields: readonly ActionField[]): Axis[] | null {
  const axes = axes_named(params).map((name) => axis_of(params, fields, name));
  if (axes.length === 0 || axes.length > kMostAxes || !axes.every((axis) => axis !== null)) return null;
  return axes.reduce((n, { steps }) => n * steps, 1) > kMostCandidates ? null : axes;
}

/** A choice that was flown is in the page only so: one that is made anew must be the same. */
function as_recorded(value: number, quantum: number): number {
  return quantum > 0 ? Math.round(value / quantum) * quantum : value;
}

/** 1 at what is asked for, falling to -1 at `reach` and beyond. */
function worth(axis: Axis, at: number, asked: number): number {
  const away = Math.abs(axis.is_direction ? wrap_pi(at - asked) : at - asked);
  return 1 - 2 * Math.min(1, away / axis.reach);
}

class Sums {
  private readonly sums: Float64Array;
  private readonly scratch: Float64Array;
  private rounding = 0;
  /** By axis: how far rounding in the page can move sums apart that differ along it. */
  private readonly doubt: Float64Array;
  any = false;

  constructor(private readonly axes: readonly Axis[]) {
    const size = axes.reduce((n, { steps }) => n * steps, 1);
    this.sums = new Float64Array(size);
    this.scratch = new Float64Array(size);
    this.doubt = new Float64Array(axes.length);
  }

  clear(): void {
    this.sums.fill(0);
    this.rounding = 0;
    this.doubt.fill(0);
    this.any = false;
  }

  /** A proposal votes for what is near it, in the mean over the fields that it sets. */
  add({ action, vote }: Proposal): void {
    const asked = this.axes.filter(({ field }) => !Number.isNaN(action[field]!)).length;
    this.rounding += kRounding * vote;
    if (asked === 0) return;
    this.any = true;
    let stride = 1;
    for (const [a, axis] of this.axes.entries()) {
      const wanted = action[axis.field]!;
      if (!Number.isNaN(wanted)) {
        const worths = axis.at.map((at) => (vote * worth(axis, at, wanted)) / asked);
        for (let i = 0; i < this.sums.length; ++i) this.sums[i]! += worths[Math.floor(i / stride) % axis.steps]!;
        this.doubt[a]! += (axis.doubt * vote) / asked;
      }
      stride *= axis.steps;
    }
  }

  /** Turns utilities of outcomes into expectations of commands. */
  expect(): void {
    let stride = 1;
    for (const { spread, steps, is_circle } of this.axes) {
      const reach = spread.length - 1;
      for (let i = 0; reach > 0 && i < this.sums.length; ++i) {
        const at = Math.floor(i / stride) % steps;
        let sum = 0;
        for (let k = -reach; k <= reach; ++k) {
          const to = is_circle ? (at + k + steps) % steps : Math.min(Math.max(at + k, 0), steps - 1);
          sum += spread[Math.abs(k)]! * this.sums[i + (to - at) * stride]!;
        }
        this.scratch[i] = sum;
      }
      if (reach > 0) this.sums.set(this.scratch);
      stride *= steps;
    }
  }

  /** Along the axes on which two candidates differ. */
  private doubt_between(a: number, b: number): number {
    let sum = 0;
    let stride = 1;
    for (const [i, { steps }] of this.axes.entries()) {
      if (Math.floor(a / stride) % steps !== Math.floor(b / stride) % steps) sum += this.doubt[i]!;
      stride *= steps;
    }
    return sum;
  }

  /** Puts the first candidate of those with the greatest sum in `action`. */
  put_best(action: Float64Array): void {
    let greatest = 0;
    this.sums.forEach((sum, i) => {
      if (sum > this.sums[greatest]!) greatest = i;
    });
    const enough = this.sums[greatest]! - this.rounding;
    let best = this.sums.findIndex((sum, i) => sum >= enough - this.doubt_between(i, greatest));
    for (const axis of this.axes) {
      action[axis.field] = as_recorded(axis.at[best % axis.steps]!, axis.quantum);
      best = Math.floor(best / axis.steps);
    }
  }
}

/** Who judges candidates instead of proposing one cannot be heard here: see Retrace. */
function over_grid(params: Params, fields: readonly ActionField[], spreads: boolean): ReturnType<Maker> {
  const axes = axes_of(params, fields);
  if (!axes || (!spreads && axes.some(({ spread }) => spread.length > 1))) return null;
  const sums = new Sums(axes);
  return asks_all((children, out) => {
    const strongest = as_strongest(children, out);
    merge_fields(children, out, is_heard);
    sums.clear();
    for (const child of children) if (is_heard(child)) sums.add(child);
    out.leader = sums.any ? -1 : (strongest?.leader ?? -1);
    if (!sums.any) return;
    if (spreads) sums.expect();
    sums.put_best(out.action);
    for (const { field } of axes) out.supplier[field] = -1;
  });
}

export const vote_grid: Maker = (params, fields) => over_grid(params, fields, false);
export const utility: Maker = (params, fields) => over_grid(params, fields, true);
