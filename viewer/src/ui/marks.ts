// SPDX-License-Identifier: MIT
/** The events of the story that stand on the timeline, each kind with its own glyph. */
import type { Run, Side, StoryLine } from '../run/run.ts';

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
  defend: { word: 'defense', path: 'M-4.4 3.4V-0.4A4.4 4.4 0 0 1 4.4 -0.4V3.4M1.8 1.4L4.4 4.2L7 1.4', open: true },
  home: { word: 'home', path: 'M-4.4 0.4L0 -4.2L4.4 0.4M-3 -0.8V4.2H3V-0.8', open: true },
  contact: { word: 'contact', path: 'M3.4 0A3.4 3.4 0 1 1 -3.4 0A3.4 3.4 0 1 1 3.4 0Z', open: true },
};
export const kMarkKinds = Object.keys(kMarks) as MarkKind[];

export function mark_of(run: Run, line: number): Mark | null {
  const told = run.story[line]!;
  const kind = kKinds[told.kind];
  return kind ? { line, t: told.t, kind, side: side_of(run, told) } : null;
}

function side_of(run: Run, told: StoryLine): Side {
  return run.players[told.who]?.side ?? (told.tone === 'blue' || told.tone === 'red' ? told.tone : 'none');
}

export function marks_of(run: Run): Mark[] {
  return run.story.flatMap((_, line) => mark_of(run, line) ?? []);
}

/** Of several marks within `near` seconds the one that matters most, then the nearest; null: none is near. */
export function pick_mark(marks: Mark[], t: number, near: number): Mark | null {
  let best: Mark | null = null;
  const cost = (m: Mark): number => Math.abs(m.t - t) / near + 0.1 * kMarkKinds.indexOf(m.kind);
  for (const mark of marks) if (Math.abs(mark.t - t) <= near && (!best || cost(mark) < cost(best))) best = mark;
  return best;
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
