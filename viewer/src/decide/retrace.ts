// SPDX-License-Identifier: MIT
/** The way from changed nodes to the root, decided twice: as it was flown and as it is changed. */
import type { ActionField, Decisions, Shape, Tree } from '../run/run.ts';
import { decider_of, kArbiters, kByValue, kDone, kOverGrid, rescale, type Decider, type Moment, type Params } from './arbitrate.ts';
import { copy, is_empty, make_proposal, record, same, same_suppliers, type Proposal } from './proposal.ts';
import { Loader, read_answer } from './recorded.ts';

/** Another type, vote or parameters of a node. */
export interface Change {
  /** Index into Run.trees. */
  tree: number;
  node: number;
  type?: string;
  vote?: number;
  /** In the units that people give; Retrace takes them in SI. */
  params?: Record<string, number | string>;
}

/** The parameter of fusion when all are blended. */
export const kAll = 'all';

/** These hand on what the one child said that has its turn, but remember how it ended. */
const kPassing: ReadonlySet<string> = new Set([
  'sequencer', 'if_then_else', 'selector_with_memory', 'sequence_with_memory', 'random_selector', 'timeout', 'cooldown', 'run_once',
  'rate_limit', 'delay', 'repeat', 'retry',
]);
/** These ask every child every time, and stand. */
const kAskAll: ReadonlySet<string> = new Set([
  ...Object.keys(kArbiters), 'suppress', 'inhibit', 'weighted_random',
]);
/** What these ask and halt does not depend on how their children answer. */
const kIndifferent: ReadonlySet<string> = new Set([...kAskAll, 'sequencer', 'inverter', 'force_success', 'force_failure']);
/** These stand if one of their children does. */
const kOpen: ReadonlySet<string> = new Set([
  'selector', 'sequence', 'while', 'switch', 'guard', 'inverter', 'force_success', 'force_failure', 'timeout',
]);

/** These only note which child they have to halt. */
const kNotes: ReadonlySet<string> = new Set(['selector', 'sequence', 'while', 'switch', 'guard']);

interface Step {
  node: number;
  type: string;
  params: Params;
  /** It has another type or other parameters itself, not only somebody below it. */
  is_changed: boolean;
  flown_by: Decider | null;
  would_by: Decider | null;
  /** Since it last forgot: something below it, or itself, would have answered otherwise. */
  diverged: boolean;
  /** Since it last forgot: what it remembers is not what it did, or would, remember. */
  lost: boolean;
  flown_children: Proposal[];
  would_children: Proposal[];
  recorded: Proposal;
  flown: Proposal;
  would: Proposal;
}

export class Retrace {
  readonly flown: Proposal;
  readonly would: Proposal;
  /** Whether values decide about more than values: then every decision has to be looked at. */
  readonly blends: boolean;
  /** Whether earlier decisions decide: then every one has to be looked at, in their order. */
  readonly remembers: boolean;
  /** Of the last decision: a node below which memories may be other ones from now on; -1: none. */
  doubtful = -1;

  private readonly steps: Step[] = [];
  private readonly fixed: { node: number; answer: Proposal }[] = [];
  private loader: Loader | null = null;
  private decisions: Decisions | null = null;
  private decision = 0;
  private readonly moment: Moment = { t: 0, state: (field) => this.state(field) };

  /** `unclear` are leaves of which it is not known which of their votes a parameter would change. */
  constructor(private readonly tree: Tree, private readonly fields: readonly ActionField[], changes: readonly Change[],
    private readonly unclear: ReadonlySet<number> = new Set()) {
    const changed = new Set(changes.map((c) => c.node));
    const way = new Set<number>([0]);
    for (let node of changed) for (; node > 0; node = tree.nodes[node]!.parent) way.add(node);
    // children stand behind their parents
    for (const node of [...way].sort((a, b) => b - a)) this.steps.push(this.step_of(node, changes.filter((c) => c.node === node)));
    this.flown = this.steps.at(-1)!.flown;
    this.would = this.steps.at(-1)!.would;
    this.remembers = this.steps.some(is_remembering);
    this.blends = this.remembers || this.steps.some((s) => kByValue.has(s.type) || kByValue.has(tree.nodes[s.node]!.type));
  }

  /** Decisions of this shape follow. */
  begin(shape: Shape, decisions: Decisions): void {
    this.loader = new Loader(decisions);
    this.decisions = decisions;
    for (const { node, answer } of this.fixed) this.read(shape, node, answer);
    for (const step of this.steps) this.read(shape, step.node, step.recorded);
  }

  /** Decides; returns why that cannot be said, or "". */
  decide(decision: number): string {
    this.loader!.load(decision);
    this.decision = decision;
    this.moment.t = this.decisions!.t[decision]!;
    this.doubtful = -1;
    for (const [i, step] of this.steps.entries()) {
      const problem = this.take(step);
      if (!problem) continue;
      this.doubtful = this.doubtful_from(step.node);
      for (const above of this.steps.slice(i)) above.lost = is_remembering(above);
      return problem;
    }
    return '';
  }

  /** The tree was not the player's for a while. */
  forget(): void {
    for (const step of this.steps) forget(step);
  }

  private read(shape: Shape, node: number, answer: Proposal): void {
    read_answer(this.tree, shape, node, answer);
    this.loader!.add(answer);
  }

  private state(field: number): number {
    const column = this.decisions!.state(field);
    if (!column) throw new Error(`field ${field} of the state was not recorded`);
    return column[this.decision]!;
  }

  private step_of(node: number, changes: readonly Change[]): Step {
    const { type, params, children } = this.tree.nodes[node]!;
    const fields = this.fields.length;
    const answers = children.map((child) => this.steps.find((s) => s.node === child) ?? this.fixed_answer(child));
    const other = changes.reduce(applied, { type, params });
    const by = (how: { type: string; params: Params }) =>
      children.length && !this.judge(how.type, node) ? decider_of(how.type, how.params, this.fields, node, children) : null;
    return {
      node, ...other, is_changed: changes.length > 0,
      flown_by: by({ type, params }), would_by: by(other), diverged: false, lost: false,
      flown_children: answers.map((a) => a.flown), would_children: answers.map((a) => a.would),
      recorded: make_proposal(fields), flown: make_proposal(fields), would: make_proposal(fields),
    };
  }

  /** A child whose judgement this type of node would ask for, which is not in the page; "": there is none. */
  private judge(type: string, node: number): string {
    const { nodes } = this.tree;
    const judge = kOverGrid.has(type) && nodes[node]!.children.find((child) => nodes[child]!.appraises);
    return typeof judge === 'number' ? nodes[judge]!.label : '';
  }

  private fixed_answer(node: number): { flown: Proposal; would: Proposal } {
    const answer = make_proposal(this.fields.length);
    this.fixed.push({ node, answer });
    return { flown: answer, would: answer };
  }

  private take(step: Step): string {
    const { recorded, flown, would } = step;
    copy(recorded, flown);
    copy(recorded, would);
    if (recorded.status === null) {
      forget(step);
      return '';
    }
    if (step.flown_children.length === 0) return this.vote_anew(step);
    const { label, type: was } = this.tree.nodes[step.node]!;
    if (was === 'for_each' && step.flown_children[0]!.status !== null)
      return `${label} asks once for each of several, and the page has one of the answers`;
    const repeats = this.repeat(step);
    const remembers = is_remembering(step);
    if (remembers && !repeats && step.flown_by?.forget) step.lost = true;
    const changes = step.is_changed || step.flown_children.some((child, i) => !same(child, step.would_children[i]!));
    step.diverged ||= changes;
    if (!changes && !(remembers && step.diverged)) {
      if (remembers) step.would_by?.(step.would_children, would, this.moment);
      copy(flown, would);
      return '';
    }
    if (step.lost) return `what ${label} remembers hangs on a decision before that is not known`;
    const problem = this.change(step, repeats);
    if (!problem && flown.status !== would.status) this.note_divergence(step);
    return problem;
  }

  /** A leaf with another vote. One that voted something else than its parameter said had its own reasons. */
  private vote_anew({ node, params: { vote }, is_changed, would }: Step): string {
    const { label, params } = this.tree.nodes[node]!;
    if (!is_changed || typeof vote !== 'number' || is_empty(would)) return '';
    if (this.unclear.has(node) && would.vote > 0) return `${label} has more than one vote, and which of them this was is not in the page`;
    const follows = typeof params['vote'] === 'number' ? would.vote === Math.fround(params['vote']) : would.vote > 0;
    if (!follows) return '';
    would.vote = Math.fround(vote);
    record(would, node);
    return '';
  }

  /** Makes again what was flown, so that both sides carry the same rounding; false if that is not what was recorded. */
  private repeat({ node, flown_by, flown_children, recorded, flown }: Step): boolean {
    if (!flown_by) return false;
    const done = flown_by(flown_children, flown, this.moment) === kDone;
    if (done && is_as_recorded(flown, recorded) && (node > 0 || flown.leader === recorded.leader)) return true;
    copy(recorded, flown);
    return false;
  }

  private change(step: Step, repeats: boolean): string {
    const { node, type, would_by, would_children, would } = step;
    const { label, type: was } = this.tree.nodes[node]!;
    if (would_by && (repeats || type !== was)) {
      const missing = would_by(would_children, would, this.moment);
      if (missing === kDone) return '';
      const child = this.tree.nodes[this.tree.nodes[node]!.children[missing]!]!;
      return `${child.label} was not asked in flight, and ${label} would have asked it`;
    }
    if (!step.is_changed && hand_on(step)) return '';
    const judge = this.judge(type, node);
    if (judge) return `${judge} judges each candidate of ${label}, and its judgements are not in the page`;
    if (type in kArbiters && !would_by) return `${type} cannot be with these parameters`;
    return `what ${label === type ? type : `${label} (${type})`} makes of it depends on more than this page has`;
  }

  /** Another status of a child may mean that its parent asks or halts others than it did. */
  private note_divergence({ node, flown, would }: Step): void {
    const { parent } = this.tree.nodes[node]!;
    if (parent < 0 || kIndifferent.has(this.tree.nodes[parent]!.type)) return;
    if (turns(this.tree, parent, node, flown, would) && this.something_remembers(parent)) this.doubtful = parent;
  }

  /** If what `node` does is not known, neither is what those above it ask and halt. */
  private doubtful_from(node: number): number {
    for (let n = node; n >= 0; n = this.tree.nodes[n]!.parent)
      if ((n === node || !kIndifferent.has(this.tree.nodes[n]!.type)) && this.something_remembers(n)) return n;
    return -1;
  }

  private something_remembers(node: number): boolean {
    const { type, remembers, children } = this.tree.nodes[node]!;
    const anew = this.steps.find((step) => step.node === node)?.would_by?.forget !== undefined;
    return anew || (remembers && !kNotes.has(type)) || children.some((child) => this.something_remembers(child));
  }
}

function is_remembering({ flown_by, would_by }: Step): boolean {
  return flown_by?.forget !== undefined || would_by?.forget !== undefined;
}

function forget(step: Step): void {
  step.flown_by?.forget?.();
  step.would_by?.forget?.();
  step.diverged = step.lost = false;
}

/** But for leaders, which are recorded of the root alone, and values, which are rounded. */
function is_as_recorded(made: Proposal, recorded: Proposal): boolean {
  return made.status === recorded.status && made.vote === recorded.vote && same_suppliers(made.supplier, recorded.supplier);
}

function applied(before: { type: string; params: Params }, change: Change): { type: string; params: Params } {
  const { vote, vote_scale } = before.params;
  const replaced = change.type !== undefined && change.type !== before.type;
  const votes: Params = { ...(vote !== undefined && { vote }), ...(vote_scale !== undefined && { vote_scale }) };
  const kept = replaced ? votes : before.params;
  const params: Params = { ...kept, ...change.params, ...(change.vote !== undefined && { vote: change.vote }) };
  if (params['top'] === kAll) delete params['top'];
  return { type: change.type ?? before.type, params };
}

/** The one child that answers otherwise was the one whose answer went up, and what the node remembers does not
 * hang on it. */
function hand_on({ node, type, params, flown_children, would_children, recorded, would }: Step): boolean {
  const changed = the_one_changed(flown_children, would_children);
  if (changed < 0) return false;
  const was = flown_children[changed]!;
  const is = would_children[changed]!;
  const in_charge = flown_children.find((child) => child.status !== null); // a sequencer's conditions come behind
  const by_state = type === 'switch' || (type === 'sequencer' && was === in_charge);
  if (!by_state && !(kPassing.has(type) && was.status === is.status)) return false;
  const send = (child: Proposal): void => {
    copy(child, would);
    rescale(would, params);
    record(would, node);
  };
  send(was);
  if (!is_as_recorded(would, recorded)) return false;
  send(is);
  return true;
}

/** -1: there are several. */
function the_one_changed(flown: readonly Proposal[], would: readonly Proposal[]): number {
  let changed = -1;
  for (let i = 0; i < flown.length; ++i) {
    if (same(flown[i]!, would[i]!)) continue;
    if (changed >= 0) return -1;
    changed = i;
  }
  return changed;
}

/** Whether a control node goes on otherwise after another answer of one of its children. */
function turns(tree: Tree, parent: number, child: number, was: Proposal, is: Proposal): boolean {
  const { type, children } = tree.nodes[parent]!;
  const differs = (status: string) => (was.status === status) !== (is.status === status);
  if (!stands(tree, child)) return true;
  if (type === 'selector') return differs('failure');
  if (type === 'sequence') return differs('success');
  if (type === 'guard' || type === 'while') return child === children[0];
  return type !== 'switch';
}

/** As Behavior::stands: something in it may go on whatever it answers. */
function stands(tree: Tree, node: number): boolean {
  const { type, children } = tree.nodes[node]!;
  return kAskAll.has(type) || type === 'sequencer' || (kOpen.has(type) && children.some((child) => stands(tree, child)));
}
