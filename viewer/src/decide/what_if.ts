// SPDX-License-Identifier: MIT
/** What a player would have decided with other votes, arbiters or parameters: src/debrief/what_if.cpp. */
import type { ActionField, Decisions, Player, Run, Tree } from '../run/run.ts';
import { angle_between } from './angle.ts';
import { in_si } from './choices.ts';
import { same_action, same_value } from './proposal.ts';
import { Retrace, type Change } from './retrace.ts';
import { value_text } from './text.ts';

export { arbiters_for, with_param, type ArbiterChoice, type ParamChoice } from './choices.ts';
export { command_of } from './command.ts';
export type { Change } from './retrace.ts';

export interface ChangedField {
  name: string;
  /** As the terminal writes them; "-" for nothing. */
  flown: string;
  other: string;
  /** Other minus flown, in SI, directions the short way round; null if there is no such thing. */
  difference: number | null;
}

export interface WhatIfResult {
  decisions: number;
  /** Whose action would have been another one. */
  different: number;
  /** Of which the page cannot say, and why. */
  unknown: number;
  why_unknown: string;
  first: { index: number; t: number; flown: string; other: string; fields: ChangedField[] } | null;
  /** s, from the first to the last of different decisions in a row. */
  spans: [from: number, to: number][];
  /** Who would have led each decision: a node, -1: nobody, kUnknown. */
  leader: Int16Array;
  /** In words, if results may not be those of the terminal; else "". */
  caution: string;
}

export const kUnknown = -2;

/** What becomes of the decisions of one shape. */
interface Verdict {
  problem: string;
  doubtful: number;
  leader: number;
  /** Fields that two nodes supply; their values decide. Null: look at every decision. */
  fields: { flown: Float64Array | null; other: Float64Array | null }[] | null;
}

const kSame: Verdict = { problem: '', doubtful: -1, leader: kUnknown, fields: [] };

const kThinned = 'Of this run the page has one decision a second, and those that were others than before: an arbiter that remembers ' +
  'may change its mind up to a second earlier than it says here.';

/** Decides the decisions of one player anew. */
class Anew {
  private readonly retrace: Retrace;
  private readonly verdicts = new Map<number, Verdict>();
  private begun = -1;
  private decided = -1;

  constructor(private readonly run: Run, private readonly decisions: Decisions, private readonly tree: number,
    fields: readonly ActionField[], private readonly changes: readonly Change[]) {
    const unclear = changes.map((c) => c.node).filter((node) => has_unclear_vote(run, tree, node));
    this.retrace = new Retrace(run.trees[tree]!, fields, changes, new Set(unclear));
  }

  /** Whether decision `i` would have been another one; its problem, doubt and leader are in `verdict`. */
  differs(i: number, verdict: Verdict): boolean {
    if (verdict.problem) return false;
    if (verdict.fields) return verdict.fields.some(({ flown, other }) => !same_value(flown?.[i] ?? NaN, other?.[i] ?? NaN));
    return !same_action(this.retrace.flown.action, this.retrace.would.action);
  }

  verdict(i: number): Verdict {
    const shape = this.decisions.shape[i]!;
    const known = this.verdicts.get(shape);
    if (known) return known;
    const verdict = this.is_touched(shape) || this.retrace.remembers ? this.decide(i) : kSame;
    if (verdict === kSame || !this.retrace.blends) this.verdicts.set(shape, verdict);
    return verdict;
  }

  /** The two proposals of decision `i`, with values. */
  look(i: number): Retrace {
    if (this.decided !== i) this.decide(i);
    return this.retrace;
  }

  get remembers(): boolean {
    return this.retrace.remembers;
  }

  /** The tree was not the player's for a while. */
  forget(): void {
    this.retrace.forget();
  }

  /** Whether a changed node was asked. */
  private is_touched(shape: number): boolean {
    const { tree, status } = this.run.shapes[shape]!;
    return tree === this.tree && this.changes.some((c) => status[c.node] !== null);
  }

  private decide(i: number): Verdict {
    const index = this.decisions.shape[i]!;
    const shape = this.run.shapes[index]!;
    const { retrace } = this;
    if (this.begun !== index) retrace.begin(shape, this.decisions);
    this.begun = index;
    this.decided = i;
    const problem = retrace.decide(i);
    const { flown, would, doubtful } = retrace;
    const leader = would.leader === flown.leader ? shape.leader : would.leader;
    return { problem, doubtful, leader, fields: retrace.blends ? null : this.columns() };
  }

  private columns(): Verdict['fields'] {
    const { flown, would } = this.retrace;
    const column = (node: number, field: number) => (node < 0 ? null : this.decisions.value(node, field));
    return Array.from(flown.supplier, (node, f) => ({ f, a: node, b: would.supplier[f]! }))
      .filter(({ a, b }) => a !== b)
      .map(({ f, a, b }) => ({ flown: column(a, f), other: column(b, f) }));
  }
}

/** Behaviors with a parameter besides `vote` that is a vote too. */
const kSeveralVotes: ReadonlySet<string> = new Set(['break_turn']);

/** Whether it cannot be told which of a leaf's votes were those of its parameter. */
function has_unclear_vote({ trees, shapes }: Run, tree: number, node: number): boolean {
  const { type, params } = trees[tree]!.nodes[node]!;
  if (typeof params['vote'] === 'number') return false;
  const given = new Set(shapes.filter((s) => s.tree === tree).map((s) => s.vote[node]!));
  given.delete(0);
  return kSeveralVotes.has(type) || given.size > 1;
}

function label(tree: Tree, node: number): string {
  return node < 0 ? 'nobody' : tree.nodes[node]!.label;
}

/** A node without a label of its own is called by its type. */
function other_label(tree: Tree, node: number, changes: readonly Change[]): string {
  const own = label(tree, node);
  if (node < 0 || own !== tree.nodes[node]!.type) return own;
  return changes.findLast((c) => c.node === node && c.type !== undefined)?.type ?? own;
}

function changed_fields(run: Run, player: Player, { flown, would }: Retrace): ChangedField[] {
  return run.platforms[player.kind].action.flatMap((field, f): ChangedField[] => {
    const a = flown.action[f]!;
    const b = would.action[f]!;
    if (same_value(a, b)) return [];
    const difference = field.kind !== 'number' || Number.isNaN(a + b) ? null : field.blend === 'angle' ? angle_between(a, b) : b - a;
    const text = (value: number) => value_text(run, player.kind, field, value);
    return [{ name: field.name, flown: text(a), other: text(b), difference }];
  });
}

/** The words that were given most often. */
function most_frequent(counts: Map<string, number>): string {
  let best = '';
  for (const [words, count] of counts) if (count > (counts.get(best) ?? 0)) best = words;
  return best;
}

export function what_if(run: Run, player: number, asked: readonly Change[]): WhatIfResult {
  const changes = asked.map((change) => in_si(run, change));
  const who = run.players[player]!;
  const { decisions } = who;
  const { t, shape } = decisions;
  const fields = run.platforms[who.kind].action;
  const trees = new Map([...new Set(changes.map((c) => c.tree))].map((tree) =>
    [tree, new Anew(run, decisions, tree, fields, changes.filter((c) => c.tree === tree))]));
  const result: WhatIfResult = {
    decisions: t.length, different: 0, unknown: 0, why_unknown: '', first: null, spans: [], leader: new Int16Array(t.length), caution: '',
  };
  if (run.about.thinned && [...trees.values()].some((anew) => anew.remembers)) result.caution = kThinned;
  const problems = new Map<string, number>();
  let in_a_row = false;
  let before = -1;
  for (let i = 0; i < t.length; ++i) {
    const { tree, leader } = run.shapes[shape[i]!]!;
    if (tree !== before) trees.get(before)?.forget();
    before = tree;
    const anew = trees.get(tree);
    const verdict = anew?.verdict(i) ?? kSame;
    result.leader[i] = verdict === kSame ? leader : verdict.problem ? kUnknown : verdict.leader;
    if (verdict.problem) problems.set(verdict.problem, (problems.get(verdict.problem) ?? 0) + 1);
    if (verdict.doubtful >= 0) result.caution ||= caution(run.trees[tree]!, verdict.doubtful, t[i]!);
    const differs = anew !== undefined && anew.differs(i, verdict);
    if (differs) note(i, anew);
    in_a_row = differs;
  }
  result.unknown = [...problems.values()].reduce((a, b) => a + b, 0);
  result.why_unknown = most_frequent(problems);
  return result;

  function note(i: number, anew: Anew): void {
    ++result.different;
    if (in_a_row) result.spans.at(-1)![1] = t[i]!;
    else result.spans.push([t[i]!, t[i]!]);
    if (result.first) return;
    const retrace = anew.look(i);
    const { tree: at, leader } = run.shapes[shape[i]!]!;
    const tree = run.trees[at]!;
    const other = other_label(tree, result.leader[i]!, changes.filter((c) => c.tree === at));
    result.first = { index: i, t: t[i]!, flown: label(tree, leader), other, fields: changed_fields(run, who, retrace) };
  }
}

function caution(tree: Tree, node: number, t: number): string {
  const minutes = String(Math.floor(t / 60)).padStart(2, '0');
  const seconds = (t % 60).toFixed(1).padStart(4, '0');
  return `From ${minutes}:${seconds} on ${tree.nodes[node]!.label} would have asked or halted others than it did, and something below it ` +
    'remembers: what follows may differ from what the program finds.';
}
