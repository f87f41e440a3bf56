// SPDX-License-Identifier: MIT
/** The engine of the page flies along with the program that serves it: as far as it may, with the same orders, and to the same hashes. */
import type { Engine } from '../engine/questions.ts';

/** What the server grants; more of it is in line.ts. */
export interface Grant {
  step: number;
  orders?: string[];  // base64 of 48 bytes each.
  hash?: string;  // Of the world after `step` steps.
  outcome: string;
}

/** What the engine says of a step. */
export interface Reached {
  step: number;
  time: number;  // s
  drawn: Uint8Array | null;  // Not each time: what the page has not had yet.
  checked: boolean;  // There was a hash to compare with.
  agrees: boolean;
  here: string;  // The hash of the world here,
  there: string;  // and of the other one.
}

/** ms: an answer is to take no longer, so that others can be asked in between. */
const kAnswer = 120;
/** Of the time at most so much goes into drawing. */
const kDrawing = 0.2;

/** Grants up to the first that has a hash are one. */
export function merged(grants: Grant[]): { grant: Grant; left: Grant[] } {
  const hashed = grants.findIndex(({ hash }) => hash !== undefined);
  const count = hashed < 0 ? grants.length : hashed + 1;
  return {
    grant: { ...grants[count - 1]!, orders: grants.slice(0, count).flatMap(({ orders }) => orders ?? []) },
    left: grants.slice(count),
  };
}

export class Lockstep {
  private grants: Grant[] = [];
  private busy = false;
  private here = 0;
  private slice = 100;  // Steps that an answer may have.
  private draw_after = 0;  // ms

  /** `reached` is told each answer, `failed` why there are no more. */
  constructor(
    private readonly engine: Pick<Engine, 'advance'>, private readonly reached: (news: Reached) => void,
    private readonly failed: (error: unknown) => void, private readonly now = () => performance.now(),
  ) {}

  grant(grant: Grant): void {
    this.grants.push(grant);
    if (!this.busy) void this.fly();
  }

  /** What has failed stays busy for good. */
  private async fly(): Promise<void> {
    this.busy = true;
    try {
      while (this.grants.length) {
        const { grant, left } = merged(this.grants);
        this.grants = left;
        await this.reach(grant);
      }
      this.busy = false;
    } catch (error) {
      this.failed(error);
    }
  }

  private async reach({ step, orders = [], hash = '', outcome }: Grant): Promise<void> {
    let given = orders;
    do {
      const to = Math.max(this.here, Math.min(step, this.here + this.slice));
      const last = to >= step;
      const begun = this.now();
      const draw = last && (begun >= this.draw_after || (!this.grants.length && hash !== ''));
      const answer = await this.engine.advance({ step: to, orders: given, hash: last ? hash : '', outcome, draw });
      given = [];
      const { moment, agrees } = answer;
      const took = Math.max(1, this.now() - begun);
      const made = moment.step - this.here;
      if (made > 10) this.slice = Math.max(20, Math.min(100_000, Math.round((this.slice + (made * kAnswer) / took) / 2)));
      this.here = moment.step;
      this.reached({
        step: moment.step, time: moment.time ?? 0, drawn: draw ? (answer.bytes ?? null) : null,
        checked: last && hash !== '', agrees, here: moment.hash, there: hash,
      });
      // what drawing takes is known when it is done
      if (draw) this.draw_after = begun + (this.now() - begun) / kDrawing;
    } while (this.here < step);
  }
}
