// SPDX-License-Identifier: MIT
/** How smoothly pictures follow each other. */

/** ms: who asks for a picture later than this after the last one was not waiting for it. */
const kPatience = 25;

export class Meter {
  private count = 0;
  private worst = 0;
  private sum = 0;
  private began = -Infinity;
  private ended = -Infinity;
  private waiting = false;

  /** A picture is wanted. */
  ask(now: number): void {
    this.waiting = now - this.ended < kPatience;
  }

  /**
   * A picture that was begun and ended then. Its time is that since the one before if it was wanted at once, else its own.
   * Returns the first, or null.
   */
  drawn(began: number, ended: number): number | null {
    const interval = this.waiting ? began - this.began : null;
    const ms = interval ?? ended - began;
    this.began = began;
    this.ended = ended;
    this.waiting = false;
    ++this.count;
    this.sum += ms;
    this.worst = Math.max(this.worst, ms);
    return interval;
  }

  read(): { count: number; worst_ms: number; mean_ms: number } {
    const out = { count: this.count, worst_ms: this.worst, mean_ms: this.count ? this.sum / this.count : 0 };
    this.count = this.worst = this.sum = 0;
    return out;
  }
}
