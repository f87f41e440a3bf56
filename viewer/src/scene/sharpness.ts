// SPDX-License-Identifier: MIT
/** How many of the screen's pixels are drawn: fewer while pictures come too slowly, all of them when it is at rest. */

/** ms between pictures that are too many, and how many such in a row. */
const kSlow = 45;
const kPatience = 4;
const kStep = 0.72;
const kLeast = 0.4;
/** Device pixels that are always drawn. */
const kEnough = 1280 * 720;
/** ms after which it is at rest. */
export const kRest = 350;

export class Sharpness {
  /** In motion. */
  private moving = 1;
  private late = 0;
  /** Of one: device pixels that are drawn, along each side. */
  scale = 1;

  /** A picture of so many pixels in full followed the one before after so many ms; null: it stands alone. True: the scale is another. */
  judge(interval: number | null, pixels: number): boolean {
    const before = this.scale;
    if (interval === null) return false;
    this.late = interval > kSlow ? this.late + 1 : 0;
    if (this.late >= kPatience) {
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
