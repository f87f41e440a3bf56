// SPDX-License-Identifier: MIT
/** How smoothly pictures follow each other, and how many of the screen's pixels are therefore drawn: fewer while they come too
 * slowly, all of them when nothing moves. */

/** ms between pictures that are too many, and how many such in a row. */
const kSlow = 45;
const kMostSlow = 4;
const kStep = 0.72;
const kLeast = 0.4;
/** Device pixels that are always drawn. */
const kEnough = 1280 * 720;
/** ms after which it is at rest. */
export const kRest = 350;

export class Sharpness {
  private moving = 1;  // In motion.
  private late = 0;
  scale = 1;  // Of one: device pixels that are drawn, along each side.

  /** A picture of so many pixels in full followed the one before after so many ms; null: it stands alone. True: the scale is another. */
  judge(interval: number | null, pixels: number): boolean {
    const before = this.scale;
    if (interval === null) return false;
    this.late = interval > kSlow ? this.late + 1 : 0;
    if (this.late >= kMostSlow) {
      this.moving = Math.min(1, Math.max(kLeast, Math.sqrt(kEnough / pixels), this.moving * kStep));
      this.late = 0;
    }
    this.scale = this.moving;
    return this.scale !== before;
  }

  /** Nothing moves: true if it should be drawn once more, with all pixels. */
  rest(): boolean {
    this.late = 0;
    if (this.scale === 1) return false;
    this.scale = 1;
    return true;
  }
}

/** ms: who asks for a picture later than this after the last one was not waiting for it. */
const kPatience = 25;

/** Tells pictures that follow each other from those that stand alone. */
export class Meter {
  private began = -Infinity;
  private ended = -Infinity;
  private waiting = false;

  /** A picture is wanted. */
  ask(now: number): void {
    this.waiting = now - this.ended < kPatience;
  }

  /** A picture was begun and ended then: ms since the one before was begun, if this one was wanted at once; else null. */
  drawn(began: number, ended: number): number | null {
    const interval = this.waiting ? began - this.began : null;
    this.began = began;
    this.ended = ended;
    this.waiting = false;
    return interval;
  }
}
