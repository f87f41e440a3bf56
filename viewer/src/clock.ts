// SPDX-License-Identifier: MIT
/** Time as it passes: moves the store's time while it plays, and tells panels of it at a pace they can follow. */
import type { Store, View } from './store.ts';

/** ms between two redraws of a panel while the run plays; air picture and cursors follow every frame. */
const kPace = 100;
/** ms; a page that was in the background goes on from where it was. */
const kLongestFrame = 250;

/** Plays until `end` (s). Returns how to stop it for good. */
export function run_clock(store: Store, end: number): () => void {
  let handle = 0;
  let last = 0;
  const frame = (now: number): void => {
    const { playing, time, rate } = store.get();
    handle = 0;
    if (!playing) return;
    const passed = Math.min(now - last, kLongestFrame) / 1000;
    last = now;
    const next = Math.min(end, time + passed * rate);
    store.set(next >= end ? { time: next, playing: false } : { time: next });
    if (store.get().playing) handle = requestAnimationFrame(frame);
  };
  const start = (): void => {
    if (handle) return;
    last = performance.now();
    handle = requestAnimationFrame(frame);
  };
  const stop = store.subscribe((now, before) => {
    if (now.playing && !before.playing) start();
  });
  if (store.get().playing) start();
  return () => {
    stop();
    cancelAnimationFrame(handle);
  };
}

/** Whether time is all that changed. */
function only_time(now: View, before: View): boolean {
  for (const key of Object.keys(now) as (keyof View)[]) if (key !== 'time' && now[key] !== before[key]) return false;
  return true;
}

/** One for all panels of a store, so that they redraw in one go. */
class Pacer {
  readonly listeners = new Set<() => void>();
  private timer: ReturnType<typeof setTimeout> | null = null;
  private told = 0;

  constructor(store: Store) {
    store.subscribe((now, before) => {
      const wait = now.playing && only_time(now, before) ? this.told + kPace - performance.now() : 0;
      if (wait <= 0) this.tell();
      else this.timer ??= setTimeout(() => this.tell(), wait);
    });
  }
  private tell(): void {
    if (this.timer) clearTimeout(this.timer);
    this.timer = null;
    this.told = performance.now();
    for (const listener of this.listeners) listener();
  }
}

const kPacers = new WeakMap<Store, Pacer>();

/** Like Store.subscribe, but while the run plays at most about 15 times a second. */
export function subscribe_paced(store: Store, listener: () => void): () => void {
  let pacer = kPacers.get(store);
  if (!pacer) kPacers.set(store, (pacer = new Pacer(store)));
  pacer.listeners.add(listener);
  return () => pacer.listeners.delete(listener);
}
