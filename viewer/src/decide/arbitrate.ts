// SPDX-License-Identifier: MIT
/** The page's own arbitration: what a node makes of its children's answers, as src/ubf does. */
import type { ActionField } from '../run/run.ts';
import { averages, sum_of, Vectors, type Sum } from './blend.ts';
import { kControl } from './control.ts';
import { asks_all, as_strongest, kDone, merge_fields, strongest_of, take, type Decider, type Maker, type Params } from './decider.ts';
import { utility, vote_grid } from './grid.ts';
import { clear, is_empty, is_heard, record, type Proposal } from './proposal.ts';
import { commitment, kLayers, priority } from './remembering.ts';
import { verify } from './verify.ts';

export { kDone, type Decider, type Moment, type Params } from './decider.ts';
export type { Proposal } from './proposal.ts';

const winner_takes_all: Maker = () => asks_all((children, out) => take(strongest_of(children), out));

const per_field: Maker = () =>
  asks_all((children, out) => {
    out.leader = as_strongest(children, out)?.leader ?? -1;
    merge_fields(children, out, is_heard);
  });

interface Blending {
  sums: Sum[];
  /** 0: the opinion does not count. */
  weigh(field: ActionField, vote: number): number;
  fields: readonly ActionField[];
}

/** Blends field by field. What one child alone set, and what is no mean, is still that child's. */
function blend(children: readonly Proposal[], out: Proposal, { sums, weigh, fields }: Blending): void {
  for (let f = 0; f < fields.length; ++f) {
    const field = fields[f]!;
    const sum = sums[f]!;
    sum.clear();
    let setters = 0;
    let strongest: Proposal | null = null;
    for (const child of children) {
      if (Number.isNaN(child.action[f]!)) continue;
      ++setters;
      if (!(strongest && child.vote <= strongest.vote)) strongest = child;
      const weight = weigh(field, child.vote);
      if (weight > 0) sum.add(child.action[f]!, weight);
    }
    out.action[f] = sum.get();
    if (setters === 1 || (setters > 1 && !averages(field.blend))) out.supplier[f] = strongest!.supplier[f]!;
  }
}

/** The `few` strongest in their order; of equals the earlier. */
function strongest_few(heard: Proposal[], few: number): Proposal[] {
  while (heard.length > few) {
    let weakest = heard.length - 1;
    for (let i = weakest; i >= 0; --i) if (heard[i]!.vote < heard[weakest]!.vote) weakest = i;
    heard.splice(weakest, 1);
  }
  return heard;
}

const fusion: Maker = ({ top, conflicts }, fields) => {
  const few = typeof top === 'number' ? top : Infinity;
  const drop = conflicts === 'drop';
  const how: Blending = { sums: fields.map((f) => sum_of(drop ? 'agreed' : f.blend)), weigh: (_, vote) => vote, fields };
  return asks_all((children, out) => {
    as_strongest(children, out);
    blend(strongest_few(children.filter(is_heard), few), out, how);
  });
};

const paper_fusion: Maker = ({ high_vote }, fields) => {
  if (typeof high_vote !== 'number') return null;
  const high = Math.fround(high_vote);
  const weigh = ({ blend: how }: ActionField, vote: number): number =>
    averages(how) ? 1 : how === 'strongest' && vote < high ? 0 : vote;
  const how: Blending = { sums: fields.map((f) => sum_of(averages(f.blend) ? 'mean' : f.blend)), weigh, fields };
  return asks_all((children, out) => {
    as_strongest(children, out);
    blend(children.filter(is_heard), out, how);
  });
};

const motor_schema: Maker = ({ direction, magnitude, unit_vote }, fields) => {
  const angle = fields.findIndex((f) => f.name === direction && f.blend === 'angle');
  const length = fields.findIndex((f) => f.name === magnitude && f.blend === 'mean');
  if (angle < 0 || length < 0 || typeof unit_vote !== 'number') return null;
  const sum = new Vectors();
  return asks_all((children, out) => {
    const strongest = as_strongest(children, out);
    merge_fields(children, out, is_heard);
    sum.clear();
    for (const child of children)
      if (is_heard(child) && !Number.isNaN(child.action[angle]!) && !Number.isNaN(child.action[length]!))
        sum.add(child.action[angle]!, child.action[length]!, child.vote / unit_vote);
    out.action[angle] = sum.direction();
    out.action[length] = sum.magnitude();
    out.supplier[angle] = out.supplier[length] = -1;
    out.leader = sum.is_empty && strongest ? strongest.leader : -1;
  });
};

export const kArbiters: Record<string, Maker> = {
  winner_takes_all, per_field, fusion, paper_fusion, motor_schema, priority, commitment, verify, vote_grid, utility,
};
/** These choose among candidates of their own, and ask some behaviors what each is worth. */
export const kOverGrid: ReadonlySet<string> = new Set(['vote_grid', 'utility']);
/** What these decide hangs on what was asked for, not on votes and statuses alone. */
export const kByValue: ReadonlySet<string> = new Set(['fusion', 'paper_fusion', 'motor_schema', 'verify', ...kOverGrid]);
const kUnscaled: ReadonlySet<string> = new Set(['guard', 'inverter', 'force_success', 'force_failure']);

/** What goes up votes as `vote` or `vote_scale` say; an empty proposal stays one. */
export function rescale(out: Proposal, { vote, vote_scale }: Params): void {
  if (typeof vote !== 'number') out.vote = Math.fround(out.vote * Math.fround(typeof vote_scale === 'number' ? vote_scale : 1));
  else if (!is_empty(out)) out.vote = Math.fround(vote);
}

/** How node number `node` of this type decides; null: the page cannot say. */
export function decider_of(type: string, params: Params, fields: readonly ActionField[], node: number,
  kids: readonly number[]): Decider | null {
  const decide = (kArbiters[type] ?? kControl[type] ?? kLayers[type])?.(params, fields, kids);
  if (!decide) return null;
  const scales = !kUnscaled.has(type);
  const whole: Decider = (children, out, moment) => {
    clear(out);
    const missing = decide(children, out, moment);
    if (missing !== kDone) return missing;
    if (scales) rescale(out, params);
    record(out, node);
    return kDone;
  };
  if (decide.forget) whole.forget = decide.forget;
  return whole;
}
