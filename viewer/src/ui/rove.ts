// SPDX-License-Identifier: MIT
/** One tab stop for all buttons of a list, or nodes of a tree: two arrow keys, home and end go from one to the next. */
import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';
import { listen } from '../events.ts';

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
