// SPDX-License-Identifier: MIT
/** Where two runs part: the first decision of a player that is another one, the first story line that only one has. */
import { value_text } from '../words/text.ts';
import type { Player, Run } from '../run/run.ts';
import { label_of, path_of } from './spans.ts';

/** A player of a run. */
export interface Of {
  run: Run;
  player: Player;
}

export interface Divergence {
  t: number;
  step: number;
  /** "pursue led with 40, in B release_weapon with 60" */
  words: string;
}

/** Numbers closer than this are what rounding left. */
const kSame = 1e-6;

function keys_of(run: Run): string[] {
  return run.shapes.map((shape) => {
    const tree = run.trees[shape.tree]!;
    const winners = shape.supplier[0] ? Array.from(shape.supplier[0], (node) => path_of(run, shape.tree, node)) : [];
    return [tree.name, path_of(run, shape.tree, shape.leader), shape.status.join(), shape.vote.join(), winners.join()].join('|');
  });
}

/** What went up for `field` at a decision, as words can be compared between runs. */
function root_value({ run, player }: Of, index: number, field: number): number | string | null {
  const shape = run.shapes[player.decisions.shape[index]!]!;
  const node = shape.supplier[0]?.[field] ?? -1;
  const value = node < 0 ? NaN : (player.decisions.value(node, field)?.[index] ?? NaN);
  if (Number.isNaN(value)) return null;
  return run.platforms[player.kind].action[field]!.kind === 'text' ? run.texts[value]! : value;
}

function other_field(a: Of, b: Of, index: number): number {
  return a.run.platforms[a.player.kind].action.findIndex((_, field) => {
    const [one, two] = [root_value(a, index, field), root_value(b, index, field)];
    return typeof one === 'number' && typeof two === 'number' ? Math.abs(one - two) > kSame : one !== two;
  });
}

function leader_words({ run, player }: Of, index: number): string {
  const shape = run.shapes[player.decisions.shape[index]!]!;
  return `${label_of(run, shape.tree, shape.leader)} with ${Number(shape.vote[0]!.toFixed(2))}`;
}

function words_of(a: Of, b: Of, index: number, field: number): string {
  const [one, two] = [leader_words(a, index), leader_words(b, index)];
  if (one !== two) return `${one} leads, in B ${two}`;
  if (field < 0) return 'another answer in the tree, the same action';
  const said = (of: Of): string => {
    const value = root_value(of, index, field);
    const about = of.run.platforms[of.player.kind].action[field]!;
    return value === null ? 'nothing' : typeof value === 'string' ? value : value_text(of.run, about, value);
  };
  const { name } = a.run.platforms[a.player.kind].action[field]!;
  const [mine, its] = [said(a), said(b)];
  return mine === its ? `${name} ${mine} in both, but not to the last digit` : `${name} ${mine}, in B ${its}`;
}

/** Null: as long as both decide, they decide alike. */
export function first_difference(a: Of, b: Of): Divergence | null {
  const [da, db] = [a.player.decisions, b.player.decisions];
  const [ka, kb] = [keys_of(a.run), keys_of(b.run)];
  const count = Math.min(da.t.length, db.t.length);
  for (let i = 0; i < count; ++i) {
    const at = { t: Math.min(da.t[i]!, db.t[i]!), step: Math.min(da.step[i]!, db.step[i]!) };
    if (da.step[i] !== db.step[i]) return { ...at, words: 'from here on they decide at other times' };
    const field = other_field(a, b, i);
    if (ka[da.shape[i]!] !== kb[db.shape[i]!] || field >= 0) return { ...at, words: words_of(a, b, i, field) };
  }
  if (da.t.length === db.t.length) return null;
  const longer = da.t.length > db.t.length ? da : db;
  return { t: longer.t[count]!, step: longer.step[count]!, words: `only in ${longer === da ? 'A' : 'B'} does it go on deciding` };
}

/** The first story line that only one of the runs has: of the first (0) or of the second (1). */
export function first_other_line(a: Run, b: Run): { of: 0 | 1; line: number } | null {
  const key = (run: Run, line: number): string => {
    const { t, name, text } = run.story[line]!;
    return `${t.toFixed(1)}|${name}|${text}`;
  };
  // lines of one moment may stand in another order
  const lines = (run: Run): Set<string> => new Set(run.story.map((_, line) => key(run, line)));
  const [all_a, all_b] = [lines(a), lines(b)];
  const only_a = a.story.findIndex((_, line) => !all_b.has(key(a, line)));
  const only_b = b.story.findIndex((_, line) => !all_a.has(key(b, line)));
  if (only_a < 0 && only_b < 0) return null;
  if (only_b < 0 || (only_a >= 0 && a.story[only_a]!.t <= b.story[only_b]!.t)) return { of: 0, line: only_a };
  return { of: 1, line: only_b };
}
