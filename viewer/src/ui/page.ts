// SPDX-License-Identifier: MIT
/** One run on the page with what its panels share. */
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Player, Run } from '../run/run.ts';
import type { Live } from '../live/live.ts';
import type { Other } from '../scene/other.ts';
import { Cell, type Store, type View } from '../store.ts';
import { marks_of, type Mark } from './marks.ts';
import { kNarrow } from './use.ts';
import type { QuantityKey } from './series.ts';
import type { Change, FlownOn } from './what_if_answer.ts';

/** What the strips show. */
export interface StripChoice {
  quantities: QuantityKey[];
  players: number[];  // Indices of players besides the selected one.
}

export interface Hover {
  t: number;  // s
  row: string;  // As in data-row.
  y: number;  // CSS pixels from the upper edge of the rows.
  part: number;  // Of the height of the row, from above.
}

export class Page {
  twin: Page | null = null;  // The other one of two runs.
  live: Live | null = null;  // It is being flown.
  other = new Cell<Other | null>(null);  // The run flown on otherwise from a moment on, beside the one that was flown.
  marks: Mark[];  // In order of time.
  changes = new Cell<Change[]>([]);  // What is asked of the trees instead of what was flown.
  future = new Cell<FlownOn | null>(null);  // What was flown on with the changes.
  node = new Cell(-1);  // The node of the tree that is looked into; -1: none.
  pointed = new Cell(-1);  // The node of the tree that something else on the page speaks of now; -1: none.
  hover = new Cell<Hover | null>(null);  // What of the strips is under the pointer.
  tips = new Map<string, (t: number) => string>();  // By row, what to say of a time in it.
  strips = new Cell<StripChoice>({ quantities: globalThis.matchMedia?.(kNarrow).matches ? [] : ['altitude', 'range'], players: [] });

  /** `letter` is "" for the only run, otherwise "A" or "B". */
  constructor(public run: Run, public store: Store, public letter: string) {
    this.marks = marks_of(run);
  }
}

/** The player of the same name in another run; -1: there is none. */
export function namesake({ run }: Pick<Page, 'run'>, player: Player | undefined): number {
  return run.players.findIndex((p) => p.name === player?.name);
}

/** A view of one run for another one, in which players have other numbers; what is of somebody who is not there is left out. */
export function view_in(to: Run, from: Run, view: View): Partial<View> {
  const { selected, ruler, ghost, zoom, ...rest } = view;
  const named = (index: number): number => namesake({ run: to }, from.players[index]);
  const [one, two] = (ruler ?? []).map(named);
  const is_same = to.players.length === from.players.length && to.players.every(({ name }, i) => name === from.players[i]!.name);
  return {
    ...rest,
    selected: Math.max(0, named(selected)),
    ruler: one !== undefined && two !== undefined && one >= 0 && two >= 0 ? [one, two] : null,
    ghost: ghost && named(ghost.player) >= 0 ? { ...ghost, player: named(ghost.player) } : null,
    zoom: is_same ? zoom : null,  // else it is another mission
  };
}

/** The same page when there is more of its run. */
export function grown(page: Page): Page {
  return { ...page, run: { ...page.run }, marks: marks_of(page.run) };
}

export const PageContext = createContext<Page | null>(null);

export function use_page(): Page {
  const page = useContext(PageContext);
  if (!page) throw new Error('a panel stands outside of a page');
  return page;
}

/** s: what the strips show of a view. */
export function range_of({ zoom, end }: View): [number, number] {
  return zoom ?? [0, end];
}
