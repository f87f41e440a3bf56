// SPDX-License-Identifier: MIT
/** Hooks of panels: they follow the store, redraw only if what they show has changed, and go by the arrow keys. */
import { useEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import type { RefObject } from 'preact';
import { subscribe_paced } from '../clock.ts';
import { listen } from '../events.ts';
import { last_at, type Player } from '../run/run.ts';
import type { Cell, Store, View } from '../store.ts';
import { use_page } from './page.ts';

/** Redraws if another thing is picked out of the value when `follow` tells. */
function use_picked<V, T>(cell: Cell<V>, pick: (value: V) => T, follow = (listener: () => void) => cell.subscribe(listener)): T {
  const picked = pick(cell.get());
  const latest = useRef({ pick, picked });
  latest.current = { pick, picked };
  const [, redraw] = useReducer((n: number) => n + 1, 0);
  useEffect(() => {
    const check = (): void => {
      if (!Object.is(latest.current.pick(cell.get()), latest.current.picked)) redraw(undefined);
    };
    check();
    return follow(check);
  }, [cell]);
  return picked;
}

/** What `pick` takes out of the view; it must give the same object for the same state of affairs. */
export function use_view<T>(store: Store, pick: (view: View) => T): T {
  return use_picked(store, pick);
}
/** The same at the pace of panels, for what changes with time. */
export function use_paced<T>(store: Store, pick: (view: View) => T): T {
  return use_picked(store, pick, (listener) => subscribe_paced(store, listener));
}

/** s: what the strips show now; the same array as long as that is the same. */
export function use_range(): [number, number] {
  const { store } = use_page();
  const zoom = use_view(store, (v) => v.zoom);
  const end = use_view(store, (v) => v.end);
  return useMemo(() => zoom ?? [0, end], [zoom, end]);
}

export function use_cell<T>(cell: Cell<T>): T {
  return use_picked(cell, (value) => value);
}

/** The selected player and his last decision at or before the time; -1: none yet. */
export function use_decision(): { player: Player; index: number } {
  const { run, store } = use_page();
  const player = run.players[use_view(store, (v) => v.selected)]!;
  const index = use_paced(store, (v) => last_at(run.players[v.selected]!.decisions.t, v.time));
  return { player, index };
}

/** Where panels become sheets; as in layout.css. */
export const kNarrow = 'screen and (max-width: 56.24em)';

/** CSS pixels; [0, 0] until it is laid out. */
export function use_size(ref: RefObject<HTMLElement | null>): [number, number] {
  const [size, set] = useState<[number, number]>([0, 0]);
  useEffect(() => {
    const watcher = new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect;
      set((old) => (old[0] === width && old[1] === height ? old : [width, height]));
    });
    watcher.observe(ref.current!);
    return () => watcher.disconnect();
  }, []);
  return size;
}

/** One tab stop for all buttons of a list, or nodes of a tree: two arrow keys, home and end go from one to the next. */
export function use_rove(list: RefObject<HTMLElement | null>, back = 'ArrowUp', on = 'ArrowDown', of = 'button'): void {
  const buttons = (): HTMLElement[] => [...(list.current?.querySelectorAll<HTMLElement>(of) ?? [])];
  const stop_at = (stop: HTMLElement | undefined): void => {
    for (const one of buttons()) if (one.tabIndex !== (one === stop ? 0 : -1)) one.tabIndex = one === stop ? 0 : -1;
  };
  // after every drawing, which may have brought others
  useEffect(() => {
    const all = buttons();
    stop_at(all.find((one) => one === document.activeElement) ?? all.find((one) => one.matches('[aria-current=true], [aria-pressed=true], [aria-selected=true]')) ?? all[0]);
  });
  useEffect(() => list.current ? listen(list.current, {
    focusin: (event) => stop_at(event.target as HTMLElement),
    keydown: (event) => {
      const all = buttons();
      const at = all.indexOf(document.activeElement as HTMLElement);
      const next = { [back]: at - 1, [on]: at + 1, Home: 0, End: all.length - 1 }[event.key];
      if (at < 0 || next === undefined) return;
      all[Math.min(Math.max(next, 0), all.length - 1)]!.focus();
      event.preventDefault();
    },
  }) : undefined, [list.current]);
}
