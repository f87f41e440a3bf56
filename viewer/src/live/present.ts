// SPDX-License-Identifier: MIT
/** The time that the page shows of a mission that goes on: smooth, and hardly behind what was flown. Who looks back is left alone until he
 * comes to the present again. */
import { Frames } from '../clock.ts';
import { Cell, type Store } from '../store.ts';

/** s of the clock behind what is flown: what comes in leaps is smooth then. */
const kBehind = 0.05;
/** s: who is this far off is put there at once. */
const kLeap = 0.4;

/** The next time to show, `passed` s of the clock after `shown`. */
export function next_shown(shown: number, flown: number, rate: number, passed: number): number {
  if (!Number.isFinite(rate)) return flown;
  const off = flown - kBehind * rate - shown;
  if (Math.abs(off) > kLeap * rate) return flown;
  return Math.max(shown, Math.min(flown, shown + passed * rate + off * Math.min(1, 4 * passed)));
}

export class Present {
  readonly following = new Cell(true);  // The page shows the present.
  private flown = 0;
  private rate = 1;  // Of the mission; Infinity: as fast as it goes.
  private paused = true;
  private moving = false;  // It is this that sets the time.
  private readonly frames = new Frames((passed) => this.frame(passed));

  constructor(private readonly store: Store) {
    store.subscribe((now, before) => {
      if (this.moving || now.time === before.time) return;
      // nobody sees what was not flown yet
      if (now.time >= this.flown) this.now();
      else if (this.following.get()) {
        this.following.set(false);
        store.set({ playing: false });
      }
    });
  }

  /** How far it is, and how it goes on. */
  told(flown: number, rate: number, paused: boolean): void {
    this.flown = flown;
    this.rate = rate;
    this.paused = paused;
    if (this.following.get()) {
      if (paused) this.show(flown);
      if (this.store.get().playing === paused) this.store.set({ playing: !paused });
    }
    this.run();
  }
  /** To the present, and on with it. */
  now(): void {
    this.following.set(true);
    this.show(this.flown);
    this.store.set({ playing: !this.paused });
    this.run();
  }
  /** Plays what is past, or stops there. */
  toggle_past(): void {
    const { playing } = this.store.get();
    this.store.set({ playing: !playing });
    this.run();
  }
  stop(): void {
    this.frames.stop();
  }

  private show(time: number): void {
    this.moving = true;
    this.store.set({ time });
    this.moving = false;
  }
  private run(): void {
    if (this.store.get().playing) this.frames.start();
  }
  private frame(passed: number): boolean {
    const { time, playing, rate } = this.store.get();
    if (!playing) return false;
    if (this.following.get()) this.show(next_shown(time, this.flown, this.rate, passed));
    else if (time + passed * rate >= this.flown) this.now();
    else this.show(time + passed * rate);
    return true;
  }
}
