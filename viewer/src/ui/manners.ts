// SPDX-License-Identifier: MIT
/** What the page does about menus and focus beyond what browsers do. */
import { listen } from '../events.ts';

/** Menus close when something else is pressed, or with escape. */
function close_menus(besides: EventTarget | null): boolean {
  let any = false;
  for (const menu of document.querySelectorAll<HTMLDetailsElement>('details.menu[open]')) {
    if (besides instanceof Node && menu.contains(besides)) continue;
    menu.open = false;
    any = true;
  }
  return any;
}

/** Returns how to stop it. */
export function mind_manners(): () => void {
  let by_pointer = false;
  const down = (event: PointerEvent): void => {
    by_pointer = true;
    close_menus(event.target);
  };
  const press = (event: KeyboardEvent): void => {
    by_pointer = false;
    if (event.key === 'Escape' && close_menus(null)) event.preventDefault();
  };
  // space and arrows are the page's again once the pointer has pressed a button; a loser stays where it was put
  const done = (event: Event): void => {
    const { target } = event;
    // a list is still open when it is clicked
    if (event.type === 'click' && target instanceof HTMLSelectElement) return;
    if (!by_pointer || !(target instanceof Element)) return;
    target.closest<HTMLElement>('button:not(.rival), summary, select, [type=checkbox]')?.blur();
  };
  // before the keys of the page, which heed what is dealt with already
  const stops = [listen(window, { keydown: press }, { capture: true }), listen(window, { pointerdown: down, click: done, change: done })];
  return () => stops.forEach((stop) => stop());
}
