// SPDX-License-Identifier: MIT
/** Arbiters that remember from one decision to the next: src/ubf/arbiter/{commitment,priority,suppress,inhibit}.hpp. */
import type { ActionField } from '../run/run.ts';
import { asks_all, take, type Maker } from './decider.ts';
import { copy, is_heard, make_proposal, type Proposal } from './proposal.ts';

/** s: a decision that comes this little too early is on time. */
const kSlack = 1e-6;
function passed(now: number, since: number, duration: number): boolean {
  return now - since >= duration - kSlack;
}
function number_of(value: unknown): number {
  return typeof value === 'number' ? value : 0;
}

/** A proposal kept to stand in for a child that fell silent. */
class Held {
  private readonly kept: Proposal;
  constructor(fields: readonly ActionField[]) {
    this.kept = make_proposal(fields.length);
  }
  get vote(): number {
    return this.kept.vote;
  }
  keep(proposal: Proposal): void {
    copy(proposal, this.kept);
  }
  /** In the name of node `child`. */
  get(out: Proposal, child: number): void {
    copy(this.kept, out);
    out.status = 'running';
    for (let f = 0; f < out.action.length; ++f) out.supplier[f] = Number.isNaN(out.action[f]!) ? -1 : child;
  }
}

export const commitment: Maker = (params, fields, kids) => {
  const margin = Math.fround(number_of(params['margin']));
  const [min_time, hold] = [number_of(params['min_time']), number_of(params['hold'])];
  if (margin === 0 && min_time === 0 && hold === 0) return null;
  const held = new Held(fields);
  let committed = -1;
  let since = 0;
  let last_proposed = 0;
  const forget = (): void => {
    committed = -1;
  };
  const decide = asks_all((children, out, { t: now }) => {
    const own = committed >= 0 && is_heard(children[committed]!) ? children[committed]! : null;
    let rival = -1;
    for (let i = 0; i < children.length; ++i)
      if (i !== committed && is_heard(children[i]!) && !(rival >= 0 && children[i]!.vote <= children[rival]!.vote)) rival = i;
    const bridged = !own && committed >= 0 && hold > 0 && !passed(now, last_proposed, hold);
    const vote = own ? own.vote : bridged ? held.vote : 0;
    const beaten = rival >= 0 && passed(now, since, min_time) && children[rival]!.vote > Math.fround(vote + margin);
    const change = (!own && !bridged) || beaten;
    if (change && rival < 0) {
      forget();
      take(null, out);
      return;
    }
    if (change) {
      committed = rival;
      since = now;
    }
    const stands_in = bridged && !change;
    if (stands_in) held.get(out, kids[committed]!);
    else copy(children[committed]!, out);
    if (out.status === 'success') forget();
    else if (!stands_in) {
      last_proposed = now;
      held.keep(out);
    }
  });
  decide.forget = forget;
  return decide;
};

/** The first that is heard, unless an earlier choice may not be interrupted. */
export const priority: Maker = ({ interruptible }) => {
  const fixed: readonly unknown[] = Array.isArray(interruptible) ? interruptible : [];
  let held = -1;
  const decide = asks_all((children, out) => {
    const chosen = held >= 0 && is_heard(children[held]!) ? held : children.findIndex(is_heard);
    held = -1;
    take(children[chosen], out);
    if (out.status === 'running' && fixed[chosen] === 0) held = chosen;
  });
  if (!fixed.includes(0)) return decide;
  decide.forget = () => {
    held = -1;
  };
  return decide;
};

/** [by, child] */
const suppress: Maker = (params, fields, kids) => {
  const hold = number_of(params['hold']);
  const held = new Held(fields);
  let holding = false;
  let last = 0;
  const forget = (): void => {
    holding = false;
  };
  const decide = asks_all((children, out, { t: now }) => {
    const [above, below] = children as [Proposal, Proposal];
    if (is_heard(above)) {
      copy(above, out);
      if (hold > 0) {
        held.keep(above);
        last = now;
        holding = true;
      }
    } else if (holding && !passed(now, last, hold)) held.get(out, kids[0]!);
    else {
      forget();
      take(is_heard(below) ? below : null, out);
    }
  });
  decide.forget = forget;
  return decide;
};

/** [by, child] */
const inhibit: Maker = (params) => {
  const hold = number_of(params['hold']);
  let blocked = false;
  let last = 0;
  const forget = (): void => {
    blocked = false;
  };
  const decide = asks_all((children, out, { t: now }) => {
    const [above, below] = children as [Proposal, Proposal];
    if (above.status !== 'failure') {
      blocked = true;
      last = now;
    } else if (blocked && passed(now, last, hold)) forget();
    take(!blocked && is_heard(below) ? below : null, out);
  });
  decide.forget = forget;
  return decide;
};

/** Of two children with roles: they cannot take another arbiter's place. */
export const kLayers: Record<string, Maker> = { suppress, inhibit };
