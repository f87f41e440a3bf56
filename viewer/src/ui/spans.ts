// SPDX-License-Identifier: MIT
/** Who led in a player's tree over time, as spans; and a colour for each of them. */
import { made } from '../made.ts';
import type { Player, Run } from '../run/run.ts';

export interface Span {
  first: number;  // Decisions [first, end).
  end: number;
  from: number;  // s
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
  return made(kFlown, player, () => spans_of(run, player, (i) => run.shapes[player.decisions.shape[i]!]!.leader));
}

// Paul Tol, "Colour schemes" (2021), light: hues that stay apart for colour-blind people; each in four tones that carry black words.
const kHues = [0x44bb99, 0xffaabb, 0x99ddff, 0xbbcc33, 0xeedd88, 0x77aadd, 0xee8866, 0xaaaa00];
const kTones = [[0, 0], [0xffffff, 0.5], [0, 0.18], [0xb0b0b0, 0.5]] as const;
const kNobodysFill = '#a8b0b8';
/** With this seed the behaviors that come with Eyrie have each its own fill, the most frequent ones a hue of their own. */
const kSeed = 1438171;

const kFills = new Map([['nobody', kNobodysFill], ['unknown', kNobodysFill]]);

/** Of a behavior: the same in every run, by its name alone. */
export function fill_of(label: string): string {
  return made(kFills, label, () => {
    let hash = kSeed;
    for (let i = 0; i < label.length; ++i) hash = Math.imul(hash ^ label.charCodeAt(i), 16777619) >>> 0;
    const slot = Math.imul(hash ^ (hash >>> 15), 0x2c1b3c6d) >>> 27;
    const [other, share] = kTones[slot >> 3]!;
    const mixed = [16, 8, 0].map((shift) => {
      const [a, b] = [kHues[slot & 7]!, other].map((color) => (color >> shift) & 255) as [number, number];
      return Math.round(a + (b - a) * share).toString(16).padStart(2, '0');
    });
    return `#${mixed.join('')}`;
  });
}
