// SPDX-License-Identifier: MIT
/** The events of the story that stand on the timeline, each kind with its own glyph. */
import type { Run, Side } from '../run/run.ts';

export type MarkKind = 'contact' | 'launch' | 'defend' | 'kill' | 'phase' | 'lead' | 'home';

export interface Mark {
  line: number;  // Index into Run.story.
  t: number;
  kind: MarkKind;
  side: Side;
}

const kKinds: Record<string, MarkKind> = {
  contact: 'contact', launch: 'launch', gun_burst: 'launch', defend: 'defend', scatter: 'defend', kill: 'kill', crash: 'kill',
  loss: 'kill', phase: 'phase', lead_change: 'lead', home: 'home',
};

/** Of each kind, what matters most first: its word, and its glyph in a box from -5 to 5; an `open` one is stroked. */
export const kMarks: Record<MarkKind, { word: string; path: string; open: boolean }> = {
  kill: { word: 'loss', path: 'M-4.2 -4.2L4.2 4.2M4.2 -4.2L-4.2 4.2', open: true },
  launch: { word: 'launch', path: 'M0 -4.8L4.2 4.2L0 2.2L-4.2 4.2Z', open: false },
  phase: { word: 'phase of a flight', path: 'M-2.5 5V-5H4.5L2.2 -2.4L4.5 0.2H-2.5', open: false },
  lead: { word: 'new lead of a flight', path: 'M-4.8 3.6L-4.8 -2.8L-2 0L0 -4L2 0L4.8 -2.8L4.8 3.6Z', open: false },
  defend: { word: 'defense', path: 'M-4.6 3.6V-0.6A3.6 3.6 0 0 1 2.6 -0.6V3.6M0.2 1.4L2.6 4.2L5 1.4', open: true },
  home: { word: 'home', path: 'M-4.4 0.4L0 -4.2L4.4 0.4M-3 -0.8V4.2H3V-0.8', open: true },
  contact: { word: 'contact', path: 'M3.4 0A3.4 3.4 0 1 1 -3.4 0A3.4 3.4 0 1 1 3.4 0Z', open: true },
};
export const kMarkKinds = Object.keys(kMarks) as MarkKind[];

export function mark_of(run: Run, line: number): Mark | null {
  const told = run.story[line]!;
  const kind = kKinds[told.kind];
  const side = run.players[told.who]?.side ?? (told.tone === 'blue' || told.tone === 'red' ? told.tone : 'none');
  return kind ? { line, t: told.t, kind, side } : null;
}

export function marks_of(run: Run): Mark[] {
  return run.story.flatMap((_, line) => mark_of(run, line) ?? []);
}

/** Marks of one lane that would lie over each other: one glyph, at the first of them, with their number. */
export interface Cluster {
  marks: Mark[];  // In order of time.
  kind: MarkKind;  // Of those the one that matters most.
  side: Side;
  lane: number;
  /** CSS pixels: the middle of the glyph, and where it ends with its number. */
  x: number;
  end: number;
}

/** rem: half of a glyph, a digit of a number, what is between the two, and between one glyph and the next. */
export const kHalfGlyph = 0.5;
const kDigit = 0.57;
export const kBeside = 0.08;
const kGap = 0.2;

/** Of the height of the row: where its lanes begin, below the times. */
export const kLanesFrom = 0.34;
/** The sides that have a lane each, from above. */
export function lanes_of(marks: Mark[]): Side[] {
  return marks.some(({ side }) => side === 'none') ? ['blue', 'none', 'red'] : ['blue', 'red'];
}

/** What is seen of the marks on an axis from `from` to `to` (s) that is `width` CSS pixels wide: no two of a lane touch. */
export function clusters_of(marks: Mark[], [from, to]: [number, number], width: number, rem: number): Cluster[] {
  const exact = ({ t }: Mark): number => ((t - from) / (to - from)) * width;
  const seen = marks.filter((mark) => Math.abs(exact(mark) - width / 2) <= width / 2 + kHalfGlyph * rem);
  const made = (all: Mark[], lane: number): Cluster => {
    const number = all.length > 1 ? kBeside + kDigit * String(all.length).length : 0;
    const half = kHalfGlyph * rem;
    // whole also at the ends of the run
    const x = Math.min(Math.max(exact(all[0]!), half), width - half - number * rem);
    const kind = kMarkKinds.find((one) => all.some((mark) => mark.kind === one))!;
    return { marks: all, kind, side: all[0]!.side, lane, x, end: x + half + number * rem };
  };
  return lanes_of(marks).flatMap((side, lane) => {
    const row: Cluster[] = [];
    for (const mark of seen) {
      if (mark.side !== side) continue;
      let last = made([mark], lane);
      for (let before = row.at(-1); before && before.end > last.x - (kHalfGlyph + kGap) * rem; before = row.at(-1))
        last = made([...row.pop()!.marks, ...last.marks], lane);
      row.push(last);
    }
    return row;
  });
}

/** What a place in the row means, at `x` (CSS pixels) and `part` of its height from above: what is near in its lane, else in the next. */
export function pick_cluster(clusters: Cluster[], lanes: number, x: number, part: number, rem: number): Cluster | null {
  const lane = ((part - kLanesFrom) / (1 - kLanesFrom)) * lanes - 0.5;
  const reach = 0.25 * rem;
  const near = clusters.filter((one) => x >= one.x - kHalfGlyph * rem - reach && x <= one.end + reach);
  return near.sort((a, b) => Math.abs(a.lane - lane) - Math.abs(b.lane - lane))[0] ?? null;
}

/** The time of the next (direction 1) or previous (-1) of `times`, which need no order; null: there is none. */
export function neighbor(times: Iterable<number>, t: number, direction: 1 | -1): number | null {
  let best: number | null = null;
  for (const time of times) {
    const ahead = (time - t) * direction;
    if (ahead > 0.01 && (best === null || ahead < (best - t) * direction)) best = time;
  }
  return best;
}
