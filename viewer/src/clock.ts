// SPDX-License-Identifier: MIT
/** Time as it passes: moves the store's time while it plays, and tells panels of it at a pace they can follow. */
import { made } from './made.ts';
import type { Store, View } from './store.ts';

/** ms between two redraws of a panel while the run plays; air picture and cursors follow every frame. */
const kPace = 100;
/** ms; a page that was in the background goes on from where it was. */
const kLongestFrame = 250;

/** The time of the machine; a test has its own. */
export interface Watch {
  /** ms */
  now(): number;
  /** Calls once, in `wait` ms; returns how to take that back. */
  later(call: () => void, wait: number): () => void;
}
const kWatch: Watch = {
  now: () => performance.now(),
  later: (call, wait) => {
    const timer = setTimeout(call, wait);
    return () => clearTimeout(timer);
  },
};

/** Pictures that follow each other: calls `draw` for each with the s that have passed, as long as it says that there is more. */
export class Frames {
  private handle = 0;
  private last = 0;

  constructor(private readonly draw: (passed: number) => boolean, private readonly watch = kWatch) {}

  start(): void {
    if (this.handle) return;
    this.last = this.watch.now();
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
export function run_clock(store: Store, watch = kWatch): () => void {
  const frames = new Frames((passed) => {
    const { playing, time, rate, end } = store.get();
    const next = Math.min(end, time + passed * rate);
    if (playing) store.set(next >= end ? { time: next, playing: false } : { time: next });
    return store.get().playing;
  }, watch);
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
  private cancel: (() => void) | null = null;
  private told = -Infinity;

  constructor(store: Store, private readonly watch: Watch) {
    store.subscribe((now, before) => {
      const wait = now.playing && only_time(now, before) ? this.told + kPace - watch.now() : 0;
      if (wait <= 0) this.tell();
      else this.cancel ??= watch.later(() => this.tell(), wait);
    });
  }
  private tell(): void {
    this.cancel?.();
    this.cancel = null;
    this.told = this.watch.now();
    for (const listener of this.listeners) listener();
  }
}

const kPacers = new WeakMap<Store, Pacer>();

/** Like Store.subscribe, but while the run plays at most ten times a second. All of a store go by the watch of the first. */
export function subscribe_paced(store: Store, listener: () => void, watch = kWatch): () => void {
  const pacer = made(kPacers, store, () => new Pacer(store, watch));
  pacer.listeners.add(listener);
  return () => pacer.listeners.delete(listener);
}
