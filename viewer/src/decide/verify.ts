// SPDX-License-Identifier: MIT
/** The arbiter that checks proposals before one goes up: src/ubf/arbiter/verify.hpp. */
import type { ActionField, ConditionStep, Operand, Refusal } from '../run/run.ts';
import { kTau, wrap_tau } from './angle.ts';
import { asks_all, take, type Maker, type Moment, type Params } from './decider.ts';
import { is_heard, type Proposal } from './proposal.ts';

/** A value of an action passes; NaN is not set and is not asked. */
type Check = (action: Float64Array) => boolean;

/** Of one field; null: they can be no limits. Values are rounded in the page, limits are not. */
function limits_check(field: number, { blend, quantum }: ActionField, min: number | undefined, max: number | undefined): Check | null {
  const slack = quantum / 2;
  if (blend === 'angle') {
    if (min === undefined || max === undefined) return null;
    const arc = wrap_tau(max - min);
    // an angle just outside of the beginning is nearly a circle away
    return (action) => {
      const off = wrap_tau(action[field]! - min);
      return off <= arc + slack || off >= kTau - slack;
    };
  }
  const [least, most] = [min ?? -Infinity, max ?? Infinity];
  return least > most ? null : (action) => action[field]! >= least - slack && action[field]! <= most + slack;
}

/** Null: some are no limits. */
function bounds_of(params: Params, fields: readonly ActionField[]): Check[] | null {
  const checks: Check[] = [];
  for (const [f, field] of fields.entries()) {
    const [min, max] = [params[`bounds.${field.name}.min`], params[`bounds.${field.name}.max`]];
    if (min === undefined && max === undefined) continue;
    if (typeof (min ?? 0) !== 'number' || typeof (max ?? 0) !== 'number') return null;
    const check = limits_check(f, field, min as number | undefined, max as number | undefined);
    if (!check) return null;
    checks.push((action) => Number.isNaN(action[f]!) || check(action));
  }
  return checks;
}

/** What a condition reads of an action: numbers, whether a flag is true, and of everything else whether it is set. */
function value_of(kind: ActionField['kind'], value: number): number {
  if (kind === 'number') return value;
  return kind === 'flag' ? Number(value === 1) : Number(!Number.isNaN(value));
}

/** A comparison with what has no value is false, whichever it is. */
function compare({ op, within }: ConditionStep, a: number, b: number): boolean {
  if (Number.isNaN(a) || Number.isNaN(b)) return false;
  const equal = Math.abs(a - b) <= within;
  switch (op) {
    case '<':
      return a < b && !equal;
    case '<=':
      return a < b || equal;
    case '>':
      return a > b && !equal;
    case '>=':
      return a > b || equal;
    case '==':
      return equal;
    default:
      return !equal;
  }
}

function holds(steps: readonly ConditionStep[], read: (operand: Operand) => number): boolean {
  let truth = false;
  for (let at = 0; at < steps.length; ++at) {
    const step = steps[at]!;
    if (step.op === 'not') truth = !truth;
    else if (step.op === 'and') at = truth ? at : step.target - 1;
    else if (step.op === 'or') at = truth ? step.target - 1 : at;
    else if (step.op === 'flag') truth = read(step.left) > 0;
    else truth = compare(step, read(step.left), read(step.right));
  }
  return truth;
}

function refusals_of({ refuse }: Params): readonly Refusal[] {
  return Array.isArray(refuse) ? (refuse as Refusal[]) : [];
}

/** Bounds and conditions; the last child is not checked if it is the fallback. */
export const verify: Maker = (params, fields, kids) => {
  const bounds = bounds_of(params, fields);
  const refusals = refusals_of(params);
  const fallback = params['fallback'] === 'true';
  if (!bounds || (bounds.length === 0 && refusals.length === 0) || (fallback && kids.length < 2)) return null;
  const passes = ({ action }: Proposal, moment: Moment): boolean => {
    if (!bounds.every((check) => check(action))) return false;
    const read = (o: Operand): number =>
      typeof o === 'number' ? o : 'state' in o ? moment.state(o.state) : value_of(fields[o.action]!.kind, action[o.action]!);
    return !refusals.some(({ steps }) => holds(steps, read));
  };
  return asks_all((children, out, moment) => {
    let winner: Proposal | null = null;
    for (const [i, child] of children.entries()) {
      if (!is_heard(child)) continue;
      const is_fallback = fallback && i + 1 === children.length;
      if (is_fallback ? !winner : !(winner && child.vote <= winner.vote) && passes(child, moment)) winner = child;
    }
    take(winner, out);
  });
};
