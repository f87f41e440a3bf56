// SPDX-License-Identifier: MIT
/** How several opinions about one field of an action become one: src/ubf/blend.hpp. NaN: none. */
import type { Blend } from '../run/run.ts';
import { wrap_tau } from './angle.ts';

/** A sum that is used again and again. */
export interface Sum {
  clear(): void;
  add(value: number, vote: number): void;
  get(): number;
}

/** The weighted mean, never outside what was asked. */
class Mean implements Sum {
  private sum = 0;
  private weight = 0;
  private low = 0;
  private high = 0;

  clear(): void {
    this.sum = this.weight = this.low = this.high = 0;
  }
  add(value: number, vote: number): void {
    this.low = this.weight > 0 ? Math.min(this.low, value) : value;
    this.high = this.weight > 0 ? Math.max(this.high, value) : value;
    this.sum += vote * value;
    this.weight += vote;
  }
  get(): number {
    return this.weight > 0 ? Math.min(Math.max(this.sum / this.weight, this.low), this.high) : NaN;
  }
}

/** The direction of the weighted sum of unit vectors; of opinions that cancel, the strongest. */
class Angle implements Sum {
  private alone = true;
  private first = 0;
  private strongest = 0;
  private strongest_vote = 0;
  private east = 0;
  private north = 0;
  private weight = 0;

  clear(): void {
    this.alone = true;
    this.first = this.strongest = this.strongest_vote = this.east = this.north = this.weight = 0;
  }
  add(value: number, vote: number): void {
    if (this.weight === 0) this.first = value;
    if (this.alone && value !== this.first) {
      this.alone = false;
      this.add_vector(this.first, this.weight);
    }
    if (!this.alone) this.add_vector(value, vote);
    if (vote > this.strongest_vote) {
      this.strongest = value;
      this.strongest_vote = vote;
    }
    this.weight += vote;
  }
  get(): number {
    if (!(this.weight > 0)) return NaN;
    if (this.alone) return this.first;
    const cancels = this.east * this.east + this.north * this.north <= 1e-18 * this.weight * this.weight;
    return wrap_tau(cancels ? this.strongest : Math.atan2(this.east, this.north));
  }
  private add_vector(x: number, vote: number): void {
    this.east += vote * Math.sin(x);
    this.north += vote * Math.cos(x);
  }
}

/** An order: that of the strongest vote, the earlier of equals. */
class Strongest implements Sum {
  private value = NaN;
  private vote = 0;

  clear(): void {
    this.value = NaN;
    this.vote = 0;
  }
  add(value: number, vote: number): void {
    if (vote <= this.vote) return;
    this.value = value;
    this.vote = vote;
  }
  get(): number {
    return this.value;
  }
}

/** Kept if all who set it set it alike. */
class Agreed implements Sum {
  private value = NaN;
  private disputed = false;

  clear(): void {
    this.value = NaN;
    this.disputed = false;
  }
  add(value: number, _vote: number): void {
    if (Number.isNaN(this.value)) this.value = value;
    else if (this.value !== value) this.disputed = true;
  }
  get(): number {
    return this.disputed ? NaN : this.value;
  }
}

/** A sum of vectors of which the longest one asked for is the limit: src/ubf/arbiter/motor_schema.hpp. */
export class Vectors {
  private east = 0;
  private north = 0;
  private total = 0;
  private longest = 0;
  is_empty = true;

  clear(): void {
    this.east = this.north = this.total = this.longest = 0;
    this.is_empty = true;
  }
  add(angle: number, length: number, gain: number): void {
    this.east += gain * length * Math.sin(angle);
    this.north += gain * length * Math.cos(angle);
    this.total += gain * Math.abs(length);
    this.longest = Math.max(this.longest, Math.abs(length));
    this.is_empty = false;
  }
  direction(): number {
    return this.is_empty || this.cancels() ? NaN : wrap_tau(Math.atan2(this.east, this.north));
  }
  magnitude(): number {
    if (this.is_empty) return NaN;
    return this.cancels() ? 0 : Math.min(this.longest, Math.sqrt(this.squared()));
  }
  private squared(): number {
    return this.east * this.east + this.north * this.north;
  }
  private cancels(): boolean {
    return this.squared() <= 1e-18 * this.total * this.total;
  }
}

const kSums: Record<Blend, new () => Sum> = { mean: Mean, angle: Angle, strongest: Strongest, agreed: Agreed };

export function sum_of(blend: Blend): Sum {
  return new kSums[blend]();
}

/** Whether a mean is taken of such a field; otherwise it is an order or a choice. */
export function averages(blend: Blend): boolean {
  return blend === 'mean' || blend === 'angle';
}
