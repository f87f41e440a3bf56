// SPDX-License-Identifier: MIT
/** Time as it passes: moves the store's time while it plays, and tells panels of it at a pace they can follow. */
import { made } from './made.ts';
import type { Store, View } from './store.ts';

/** ms between two redraws of a panel while the run plays; air picture and cursors follow every frame. */
const kPace = 100;
/** ms; a page that was in the background goes on from where it was. */
const kLongestFrame = 250;

/** To the end of the timeline. */
function play_on(store: Store, passed: number): void {
  const { time, rate, end } = store.get();
  const next = Math.min(end, time + passed * rate);
  store.set(next >= end ? { time: next, playing: false } : { time: next });
}

/** While a store plays, moves its time with every picture by the s that have passed. Returns how to stop it for good. */
export function run_clock(store: Store, move = (passed: number): void => play_on(store, passed)): () => void {
  let handle = 0;
  let last = 0;
  const next = (): void => {
    handle = requestAnimationFrame((now) => {
      // a frame may have begun before the clock was started
      const passed = Math.max(0, Math.min(now - last, kLongestFrame)) / 1000;
      handle = 0;
      last = now;
      if (store.get().playing) move(passed);
      if (store.get().playing && !handle) next();
    });
  };
  const start = (): void => {
    if (handle) return;
    last = performance.now();
    next();
  };
  const unsubscribe = store.subscribe((now, before) => {
    if (now.playing && !before.playing) start();
  });
  if (store.get().playing) start();
  return () => {
    unsubscribe();
    cancelAnimationFrame(handle);
    handle = -1;
  };
}

/** Whether time is all that changed. */
function only_time(now: View, before: View): boolean {
  return (Object.keys(now) as (keyof View)[]).every((key) => key === 'time' || now[key] === before[key]);
}

/** Those whom a store tells at a pace: all its panels, so that they redraw in one go. */
function paced(store: Store): Set<() => void> {
  const listeners = new Set<() => void>();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let told = -Infinity;
  const tell = (): void => {
    clearTimeout(timer);
    timer = undefined;
    told = performance.now();
    for (const listener of listeners) listener();
  };
  store.subscribe((now, before) => {
    const wait = now.playing && only_time(now, before) ? told + kPace - performance.now() : 0;
    if (wait <= 0) tell();
    else timer ??= setTimeout(tell, wait);
  });
  return listeners;
}

const kPaced = new WeakMap<Store, Set<() => void>>();

/** Like Store.subscribe, but while the run plays at most ten times a second. */
export function subscribe_paced(store: Store, listener: () => void): () => void {
  const listeners = made(kPaced, store, () => paced(store));
  listeners.add(listener);
  return () => listeners.delete(listener);
}
