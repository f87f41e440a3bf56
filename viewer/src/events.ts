// SPDX-License-Identifier: MIT
/** Events of a page or of an element, heard until they are not wanted any more. */

type Events = HTMLElementEventMap & Pick<WindowEventMap, 'hashchange' | 'popstate' | 'beforeunload' | 'beforeprint' | 'afterprint'>;
type Heard = { [K in keyof Events]?: (event: Events[K]) => void };

/** Returns how to stop listening. */
export function listen(target: Window | HTMLElement | MediaQueryList, heard: Heard, options: AddEventListenerOptions = {}): () => void {
  const done = new AbortController();
  for (const [name, call] of Object.entries(heard))
    target.addEventListener(name, call as EventListener, { ...options, signal: done.signal });
  return () => done.abort();
}
