// SPDX-License-Identifier: MIT
/** Everything from the keyboard, the dialog that says so, and what the page does about menus and focus beyond what browsers do. */
import { useEffect, useRef } from 'preact/hooks';
import { listen } from '../events.ts';
import type { Cell } from '../store.ts';
import {
  change_rate, jump, next_camera, select, step_decision, step_leader, step_mark, toggle_play, toggle_theme,
  toggle_zoom,
} from './actions.ts';
import type { Page } from './page.ts';
import { use_cell } from './use.ts';

interface Key {
  keys: string[];  // As in KeyboardEvent.key, "Shift+" before it where it matters.
  shown: string;
  help: string;
  does(page: Page): void;
}

const kKeys: Key[] = [
  { keys: [' '], shown: 'space', help: 'play or pause', does: toggle_play },
  { keys: ['ArrowLeft'], shown: '←', help: 'previous decision of the selected player', does: (p) => step_decision(p, -1) },
  { keys: ['ArrowRight'], shown: '→', help: 'next decision', does: (p) => step_decision(p, 1) },
  { keys: ['Shift+ArrowLeft'], shown: 'shift ←', help: '10 s back', does: (p) => jump(p, p.store.get().time - 10) },
  { keys: ['Shift+ArrowRight'], shown: 'shift →', help: '10 s on', does: (p) => jump(p, p.store.get().time + 10) },
  { keys: ['['], shown: '[', help: 'previous event on the timeline', does: (p) => step_mark(p, -1) },
  { keys: [']'], shown: ']', help: 'next event', does: (p) => step_mark(p, 1) },
  { keys: ['{', 'Shift+{'], shown: '{', help: 'back to where another behavior began to lead', does: (p) => step_leader(p, -1) },
  { keys: ['}', 'Shift+}'], shown: '}', help: 'on to where another behavior begins to lead', does: (p) => step_leader(p, 1) },
  { keys: ['-'], shown: '−', help: 'slower', does: (p) => change_rate(p, -1) },
  { keys: ['+', 'Shift++', '='], shown: '+', help: 'faster', does: (p) => change_rate(p, 1) },
  { keys: ['Home'], shown: 'home', help: 'to the beginning', does: (p) => jump(p, 0) },
  { keys: ['End'], shown: 'end', help: 'to the end', does: (p) => jump(p, p.store.get().end) },
  ...Array.from({ length: 9 }, (_, i): Key => ({
    keys: [String(i + 1)], shown: i ? '' : '1 … 9', help: 'select a player of the list', does: (p) => select(p, i),
  })),
  { keys: ['z'], shown: 'z', help: 'strips: half a minute around now, or the whole run', does: toggle_zoom },
  { keys: ['c'], shown: 'c', help: 'next camera: whole, follow, top, free', does: next_camera },
  { keys: ['f'], shown: 'f', help: 'follow the selected player', does: (p) => p.store.set({ camera: 'follow' }) },
  { keys: ['t'], shown: 't', help: 'dark or light', does: toggle_theme },
  { keys: ['Escape'], shown: 'esc', help: 'take away ruler and ghost', does: (p) => p.store.set({ ruler: null, ghost: null }) },
];

const kByKey = new Map(kKeys.flatMap((key) => key.keys.map((name) => [name, key] as const)));

/** Fields keep their keys; a button keeps the space bar, a slider and a list their arrows. */
function is_taken(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  const target = event.target;
  if (!(target instanceof Element)) return false;
  if (target.matches('input:not([type=checkbox]), select, textarea, [role=separator]')) return event.key !== 'Escape';
  return event.key === ' ' && target.matches('button, summary, input, a');
}

/** Listens as long as the page that `page` gives is there. */
export function use_keys(page: Page, help: Cell<boolean>): void {
  useEffect(() => listen(window, {
    keydown: (event) => {
      if (is_taken(event) || event.defaultPrevented || help.get()) return;
      if (event.key === '?') return help.set(true);
      // with caps lock letters are capitals
      const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      // some keyboards have digits and brackets behind Shift
      const key = kByKey.get(event.shiftKey ? `Shift+${name}` : name) ?? (/^[^a-z]$/.test(name) ? kByKey.get(name) : undefined);
      if (!key) return;
      event.preventDefault();
      key.does(page);
    },
  }), [page, help]);
}

export function Help({ open }: { open: Cell<boolean> }) {
  const is_open = use_cell(open);
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (is_open) dialog.current?.showModal();
    else dialog.current?.close();
  }, [is_open]);
  return (
    <dialog ref={dialog} class="help" aria-label="Keyboard" onClose={() => open.set(false)}
      onClick={(event) => event.target === dialog.current && open.set(false)}>
      <header><h2>Keyboard</h2><button type="button" class="quiet" aria-label="Close" onClick={() => open.set(false)}>✕</button></header>
      <dl>
        {kKeys.filter((key) => key.shown).map((key) => <div key={key.shown}><dt><kbd>{key.shown}</kbd></dt><dd>{key.help}</dd></div>)}
        <div><dt><kbd>?</kbd></dt><dd>this help</dd></div>
      </dl>
      <h2>Pointer</h2>
      <dl>
        <div><dt>air picture</dt><dd>drag turns, the wheel zooms; with the focus on it arrows turn, shift and arrows push, + and − zoom</dd></div>
        <div><dt>timeline</dt><dd>drag moves the time; a glyph jumps to its event</dd></div>
        <div><dt>strips</dt><dd>click jumps; wheel or drag zooms, shift and wheel moves, a double click shows the whole run</dd></div>
        <div><dt>players</dt><dd>click selects; with shift, the right button or a long touch, range and bearing to the selected one</dd></div>
        <div><dt>losers</dt><dd>in the table of the action: point at one to see in the air picture where it would have led</dd></div>
      </dl>
    </dialog>
  );
}

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
  const first = listen(window, { keydown: press }, { capture: true });
  const rest = listen(window, { pointerdown: down, click: done, change: done });
  return () => {
    first();
    rest();
  };
}
