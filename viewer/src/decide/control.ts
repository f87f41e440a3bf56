// SPDX-License-Identifier: MIT
/** Control nodes and decorators whose answer depends on their children's alone: src/ubf/control. */
import { kDone, merge_fields, type Decider, type Maker } from './decider.ts';
import { clear, copy, is_empty, type Proposal } from './proposal.ts';

/** The first child that does not fail; those behind it are not asked. */
const selector: Maker = () => (children, out) => {
  for (let i = 0; i < children.length; ++i) {
    const child = children[i]!;
    if (child.status === null) return i;
    if (child.status === 'failure') continue;
    copy(child, out);
    return kDone;
  }
  out.status = 'failure';
  return kDone;
};

/** As long as they succeed; the last proposal goes up, whole. */
const sequence: Maker = () => (children, out) => {
  out.status = 'success';
  for (let i = 0; i < children.length; ++i) {
    const child = children[i]!;
    if (child.status === null) return i;
    if (child.status !== 'failure' && !is_empty(child)) copy(child, out);
    out.status = child.status;
    if (child.status !== 'success') break;
  }
  return kDone;
};

function is_active(child: Proposal): boolean {
  return child.status !== 'failure';
}

/** All children at once, merged field by field, those without a vote included. */
const parallel: Maker = ({ success_count, failure_count }) => (children, out) => {
  const enough = typeof success_count === 'number' ? success_count : children.length;
  const too_many = typeof failure_count === 'number' ? failure_count : 1;
  let successes = 0;
  let failures = 0;
  for (let i = 0; i < children.length; ++i) {
    const child = children[i]!;
    if (child.status === null) return i;
    if (child.status === 'success') ++successes;
    if (child.status === 'failure') {
      ++failures;
      continue;
    }
    if (child.vote > out.vote || (out.leader === -1 && !is_empty(child))) out.leader = child.leader;
    out.vote = Math.max(out.vote, child.vote);
  }
  merge_fields(children, out, is_active);
  out.status = successes >= enough ? 'success' : failures >= too_many || failures + enough > children.length ? 'failure' : 'running';
  return kDone;
};

function hand_on(children: readonly Proposal[], child: number, out: Proposal): number {
  if (children[child]!.status === null) return child;
  copy(children[child]!, out);
  return kDone;
}

/** [when, child] */
const guard: Maker = () => (children, out) => {
  if (children[0]!.status === null) return 0;
  if (children[0]!.status === 'success') return hand_on(children, 1, out);
  out.status = 'failure';
  return kDone;
};

/** [when, do, else] */
const while_do: Maker = () => (children, out) => {
  if (children[0]!.status === null) return 0;
  return hand_on(children, children[0]!.status === 'success' ? 1 : 2, out);
};

function decorator(change: (out: Proposal) => void): Decider {
  return (children, out) => {
    const missing = hand_on(children, 0, out);
    if (missing === kDone) change(out);
    return missing;
  };
}

/** A failing child proposed nothing, and so does the success made of it. */
function succeed(out: Proposal): void {
  clear(out);
  out.status = 'success';
}

const inverter: Maker = () =>
  decorator((out) => {
    if (out.status === 'success') out.status = 'failure';
    else if (out.status === 'failure') succeed(out);
  });

const force_success: Maker = () =>
  decorator((out) => {
    if (out.status === 'failure') succeed(out);
  });

const force_failure: Maker = () =>
  decorator((out) => {
    if (out.status === 'success') out.status = 'failure';
  });

export const kControl: Record<string, Maker> = {
  selector, sequence, parallel, guard, while: while_do, inverter, force_success, force_failure,
};
