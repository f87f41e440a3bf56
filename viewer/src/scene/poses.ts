// SPDX-License-Identifier: MIT
/** Where everybody is at one time, in the scene's units: km, x east, y up, z south. */
import { is_shown, type Mover, new_pose, pose_at } from './motion.ts';

/** s */
const kMourned = 10;

export class Poses {
  readonly shown: Uint8Array;
  /** Shown, or lost so lately that one still wants to see where. */
  readonly noted: Uint8Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly heading: Float64Array;
  readonly pitch: Float64Array;
  readonly roll: Float64Array;
  private time = NaN;
  private readonly pose = new_pose();

  constructor(private readonly movers: readonly Mover[]) {
    const array = (): Float64Array => new Float64Array(movers.length);
    this.shown = new Uint8Array(movers.length);
    this.noted = new Uint8Array(movers.length);
    this.x = array();
    this.y = array();
    this.z = array();
    this.heading = array();
    this.pitch = array();
    this.roll = array();
  }

  get count(): number {
    return this.movers.length;
  }

  /** Of those who are not there (yet, or any more) the first or the last place remains. */
  update(t: number): void {
    if (t === this.time) return;
    this.time = t;
    const { pose } = this;
    for (let i = 0; i < this.movers.length; ++i) {
      const mover = this.movers[i]!;
      const known = pose_at(mover.motion, Math.min(t, mover.gone), pose);
      this.shown[i] = known && is_shown(mover, t) ? 1 : 0;
      this.noted[i] = known && t >= mover.born && (this.shown[i] || (mover.end === 'lost' && t < mover.gone + kMourned)) ? 1 : 0;
      if (!known) continue;
      this.x[i] = pose.east / 1000;
      this.y[i] = pose.up / 1000;
      this.z[i] = -pose.north / 1000;
      this.heading[i] = pose.heading;
      this.pitch[i] = pose.pitch;
      this.roll[i] = pose.roll;
    }
  }
}
