// SPDX-License-Identifier: MIT
/** Who led in a player's tree over time, as spans; and a colour for each of them. */
import type { Player, Run } from '../run/run.ts';

export interface Span {
  /** Decisions [first, end). */
  first: number;
  end: number;
  /** s */
  from: number;
  to: number;
  tree: number;  // Index of the tree; -1: unknown.
  node: number;  // The node that led; -1: nobody, -2: unknown.
  label: string;  // Of the node: "pursue", "nobody", "unknown".
}

export function label_of(run: Run, tree: number, node: number): string {
  return node === -2 ? 'unknown' : (run.trees[tree]?.nodes[node]?.label ?? 'nobody');
}
export function path_of(run: Run, tree: number, node: number): string {
  return run.trees[tree]?.nodes[node]?.path ?? '';
}

/** Spans of decisions for which `leader_at` gives the same node of the same tree. */
export function spans_of(run: Run, player: Player, leader_at: (index: number) => number): Span[] {
  const { t, shape } = player.decisions;
  const spans: Span[] = [];
  let last: Span | null = null;
  for (let i = 0; i < t.length; ++i) {
    const tree = run.shapes[shape[i]!]!.tree;
    const node = leader_at(i);
    if (last && last.tree === tree && last.node === node) continue;
    if (last) [last.end, last.to] = [i, t[i]!];
    spans.push((last = { first: i, end: t.length, from: t[i]!, to: player.gone, tree, node, label: label_of(run, tree, node) }));
  }
  return spans;
}

const kFlown = new WeakMap<Player, Span[]>();

/** As it was flown; made once. */
export function leader_spans(run: Run, player: Player): Span[] {
  let spans = kFlown.get(player);
  if (!spans) kFlown.set(player, (spans = spans_of(run, player, (i) => run.shapes[player.decisions.shape[i]!]!.leader)));
  return spans;
}

// Paul Tol, "Colour schemes" (2021), light: fills that stay apart for colour-blind people and carry black words. What looks
// like a side's colour comes late.
const kFills = ['#44bb99', '#ffaabb', '#99ddff', '#bbcc33', '#eedd88', '#77aadd', '#ee8866', '#aaaa00'];
const kNobodysFill = '#a8b0b8';

/** Whoever did not lead in any run, and would have, gets the next colour. */
export function fill_of(colors: Map<string, string>, label: string): string {
  if (label === 'nobody' || label === 'unknown') return kNobodysFill;
  let fill = colors.get(label);
  if (!fill) colors.set(label, (fill = kFills[colors.size % kFills.length]!));
  return fill;
}

/** Whoever led longest in any of the runs gets the first colour. */
export function leader_colors(runs: Run[]): Map<string, string> {
  const time = new Map<string, number>();
  for (const run of runs)
    for (const player of run.players)
      for (const span of leader_spans(run, player)) time.set(span.label, (time.get(span.label) ?? 0) + span.end - span.first);
  const labels = [...time.keys()].filter((label) => label !== 'nobody').sort((a, b) => time.get(b)! - time.get(a)!);
  return new Map(labels.map((label, i) => [label, kFills[i % kFills.length]!]));
}
