// SPDX-License-Identifier: MIT
/** Time as it passes: moves the store's time while it plays, and tells panels of it at a pace they can follow. */
import { made } from './made.ts';
import type { Store, View } from './store.ts';

/** ms between two redraws of a panel while the run plays; air picture and cursors follow every frame. */
const kPace = 100;
/** ms; a page that was in the background goes on from where it was. */
const kLongestFrame = 250;

/** Pictures that follow each other: calls `draw` for each with the s that have passed, as long as it says that there is more. */
export class Frames {
  private handle = 0;
  private last = 0;

  constructor(private readonly draw: (passed: number) => boolean) {}

  start(): void {
    if (this.handle) return;
    this.last = performance.now();
    this.next();
  }
  /** For good. */
  stop(): void {
    cancelAnimationFrame(this.handle);
    this.handle = -1;
  }
  private next(): void {
    this.handle = requestAnimationFrame((now) => {
      // a frame may have begun before the clock was started
      const passed = Math.max(0, Math.min(now - this.last, kLongestFrame)) / 1000;
      this.handle = 0;
      this.last = now;
      if (this.draw(passed) && !this.handle) this.next();
    });
  }
}

/** Plays to the end of the timeline. Returns how to stop it for good. */
export function run_clock(store: Store): () => void {
  const frames = new Frames((passed) => {
    const { playing, time, rate, end } = store.get();
    const next = Math.min(end, time + passed * rate);
    if (playing) store.set(next >= end ? { time: next, playing: false } : { time: next });
    return store.get().playing;
  });
  const stop = store.subscribe((now, before) => {
    if (now.playing && !before.playing) frames.start();
  });
  if (store.get().playing) frames.start();
  return () => {
    stop();
    frames.stop();
  };
}

/** Whether time is all that changed. */
function only_time(now: View, before: View): boolean {
  return (Object.keys(now) as (keyof View)[]).every((key) => key === 'time' || now[key] === before[key]);
}

/** One for all panels of a store, so that they redraw in one go. */
class Pacer {
  readonly listeners = new Set<() => void>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private told = -Infinity;

  constructor(store: Store) {
    store.subscribe((now, before) => {
      const wait = now.playing && only_time(now, before) ? this.told + kPace - performance.now() : 0;
      if (wait <= 0) this.tell();
      else this.timer ??= setTimeout(() => this.tell(), wait);
    });
  }
  private tell(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.told = performance.now();
    for (const listener of this.listeners) listener();
  }
}

const kPacers = new WeakMap<Store, Pacer>();

/** Like Store.subscribe, but while the run plays at most ten times a second. */
export function subscribe_paced(store: Store, listener: () => void): () => void {
  const pacer = made(kPacers, store, () => new Pacer(store));
  pacer.listeners.add(listener);
  return () => pacer.listeners.delete(listener);
}
