// SPDX-License-Identifier: MIT
/** What is asked of a tree instead of what was flown, in the words of `eyrie whatif --set`; and what it would have decided, as the
 * engine says, asked once for all panels that show it. */
import { useEffect, useState } from 'preact/hooks';
import { words_of } from '../engine/module.ts';
import type { NodeType, NodeTypes, WhatIf } from '../engine/questions.ts';
import { made } from '../made.ts';
import { decode } from '../run/decode.ts';
import type { Player, Run } from '../run/run.ts';
import { Cell } from '../store.ts';
import { use_page, type Page } from './page.ts';
import { use_cell, use_view } from './use.ts';

export interface Change {
  tree: number;  // Index into Run.trees.
  node: number;
  type?: string;  // Another one for the node.
  /** Values of parameters as a file has them: "30", "12 nmi", "{heading: {min: 0 deg}}". */
  params: Record<string, string>;
}

/** The tree that a player begins with; a path without the name of a tree is about it. */
function first_tree(run: Run, player: number): number {
  const first = run.players[player]!.decisions.shape[0];
  return first === undefined ? -1 : run.shapes[first]!.tree;
}

export function sets_of(run: Run, player: number, changes: readonly Change[]): string[] {
  const own = first_tree(run, player);
  return changes.flatMap(({ tree, node, type, params }) => {
    const { name, nodes } = run.trees[tree]!;
    const path = `${tree === own ? '' : `${name}:`}${nodes[node]!.path}`;
    return [...(type === undefined ? [] : [`${path}=${type}`]), ...Object.entries(params).map(([key, value]) => `${path}.${key}=${value}`)];
  });
}

/** A word of a shell's command line, in quotes. */
function quoted(text: string): string {
  return `'${text.replaceAll("'", "'\\''")}'`;
}
/** The same, in quotes where it needs them. */
function word_of(text: string): string {
  return /^[\w./-]+$/.test(text) ? text : quoted(text);
}

/** A path as an address has it, for a shell. Bytes that are no UTF-8 are told in octal digits. */
export function shell_path(path: string): string {
  try {
    return word_of(decodeURIComponent(path));
  } catch {
    const octal = (_: string, byte: string): string => `\\${parseInt(byte, 16).toString(8).padStart(3, '0')}`;
    return `$'${path.replaceAll("'", "\\'").replace(/%(..)/g, octal)}'`;
  }
}

/** The folder beside whose run the page lies; RUN where that is unknown. */
function folder_of_run(): string {
  const path = globalThis.location?.protocol === 'file:' && /^(.*)\/debrief\.html$/.exec(location.pathname)?.[1];
  return path ? shell_path(path) : 'RUN';
}

/** The same question for the terminal. */
export function command_of(run: Run, player: number, changes: readonly Change[]): string {
  const sets = sets_of(run, player, changes).map((set) => `--set ${quoted(set)}`);
  return [`eyrie whatif ${folder_of_run()}`, `--player ${word_of(run.players[player]!.name)}`, ...sets].join(' ');
}

/** An answer, or why there is none; neither of them yet. */
export interface Asked<T, Key = string> {
  key: Key | '';  // Of the question that it answers; "" for none so far.
  value?: T;
  problem?: string;
}

/** ms that a slider rests before its question is asked. */
const kRest = 150;
/** As the engine says that nobody led. */
const kNobody = 65535;

/** Asks again when `key` changes and rests for so many ms; null: nothing. The last answer stays until there is another one. */
export function use_asked<T, Key>(key: Key | null, ask: () => Promise<T>, rest = 0): Asked<T, Key> | null {
  const [asked, put] = useState<Asked<T, Key> | null>(null);
  useEffect(() => {
    if (key === null) return put(null);
    let is_wanted = true;
    put((last) => last ?? { key: '' });
    const timer = setTimeout(() => ask().then(
      (value) => is_wanted && put({ key, value }),
      (error: unknown) => is_wanted && put({ key, problem: words_of(error) }),
    ), rest);
    return () => {
      is_wanted = false;
      clearTimeout(timer);
    };
  }, [key]);
  return key === null ? null : asked;
}

const kAnswers = new WeakMap<Page['changes'], { key: string; answer: Promise<WhatIf> }>();

function answer_to(page: Page, key: string, player: string, sets: string[]): Promise<WhatIf> {
  let last = kAnswers.get(page.changes);
  if (last?.key !== key) kAnswers.set(page.changes, (last = { key, answer: page.run.engine!.what_if({ player, sets }) }));
  return last.answer;
}

/** Asks no longer; the same question can be asked again. */
export function stop_asking({ run, changes }: Page): void {
  kAnswers.delete(changes);
  run.engine!.stop('what_if');
}

/** What is asked for the selected player; null while nothing is, or nobody can be asked. */
export function use_question(): { key: string; name: string; sets: string[] } | null {
  const page = use_page();
  const changes = use_cell(page.changes);
  const index = use_view(page.store, (v) => v.selected);
  const { name } = page.run.players[index]!;
  const sets = sets_of(page.run, index, changes);
  // what is flown meanwhile is asked about once it is over, here too: the program is ahead of the engine of the page
  const stage = !page.live || page.run.about.outcome !== 'running';
  return page.run.engine && sets.length ? { key: JSON.stringify([name, sets, stage]), name, sets } : null;
}

/** The answer, and whether it is an old one: of the question before, until this one is answered. */
export function use_answer(): Asked<WhatIf> & { is_old: boolean } | null {
  const page = use_page();
  const { key = null, name = '', sets = [] } = use_question() ?? {};
  const asked = use_asked(key, () => answer_to(page, key!, name, sets), kRest);
  if (!asked) return key === null ? null : { key: '', is_old: true };
  // of another player it says nothing here
  const is_his = !asked.key || (JSON.parse(asked.key) as [string, string[]])[0] === name;
  return { ...(is_his ? asked : { key: '' as const }), is_old: asked.key !== key };
}

/** The node that would have led decision `i` of the page; -1: nobody, -2: unknown. */
export function would_lead(player: Player, { steps, leaders }: WhatIf): (i: number) => number {
  const at = new Map(steps.map((step, i) => [step, leaders[i]!]));
  return (i) => {
    const node = at.get(player.decisions.step[i]!) ?? -2;
    return node === kNobody ? -1 : node;
  };
}

const kTypes = new WeakMap<object, Promise<NodeTypes>>();

/** What a tree of the run may be made of; nothing while that is unknown. */
export function use_node_types(kind: 'aircraft' | 'vehicle'): NodeType[] {
  const { run } = use_page();
  const types = use_asked(run.engine ? kind : null, async () => {
    const engine = run.engine!;
    return (await made(kTypes, engine, () => engine.node_types()))[kind];
  });
  return types?.value ?? [];
}

/** The other future that is shown, or was asked for. */
export interface FlownOn extends Omit<Asked<Awaited<ReturnType<typeof branch>>>, 'key'> {
  from: number;  // s
}

/** Flies on from a step with the changes: how the run ended, and how it would have; `run` is that other flight. */
export async function branch(run: Run, player: number, changes: readonly Change[], step: number) {
  const engine = run.engine!;
  // asked in one go, so that nobody else goes to another step in between
  const [, { bytes, ...other }, flown] = await Promise.all([
    engine.seek({ step }), engine.branch({ sets: sets_of(run, player, changes), player: run.players[player]!.name }), engine.outcome(),
  ]);
  return { flown, other, run: decode(bytes) };
}

export function change_of(changes: readonly Change[], tree: number, node: number): Change | undefined {
  return changes.find((change) => change.tree === tree && change.node === node);
}

/** Asks of a node something else than until now; a change that is none is as flown again. */
export function ask(changes: Cell<Change[]>, change: Change): void {
  const others = changes.get().filter((one) => one.tree !== change.tree || one.node !== change.node);
  const is_one = change.type !== undefined || Object.keys(change.params).length > 0;
  changes.set(is_one ? [...others, change] : others);
}
