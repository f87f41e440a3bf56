// SPDX-License-Identifier: MIT
/** Keeps the address of the page a link to what it shows. */
import type { View } from '../store.ts';
import { link_text, read_link } from './link.ts';
import type { Page } from './page.ts';

/** ms: browsers refuse to have it changed much more often. */
const kPace = 500;

/** Returns how to stop it. */
export function follow_address({ run, store }: Page): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  const write = (): void => {
    timer = null;
    const text = link_text(run, store.get(), location.hash);
    if (text !== location.hash) history.replaceState(history.state, '', text);
  };
  const keys: (keyof View)[] = ['time', 'selected', 'camera', 'pose', 'zoom', 'ruler'];
  const stop = store.subscribe((now, before) => {
    if (keys.some((key) => now[key] !== before[key])) timer ??= setTimeout(write, kPace);
  });
  const read = (): void => store.set(read_link(run, location.hash, store.get().end));
  addEventListener('hashchange', read);
  return () => {
    stop();
    clearTimeout(timer ?? undefined);
    removeEventListener('hashchange', read);
  };
}
