// SPDX-License-Identifier: MIT
/** A mission that is being flown, as its page knows it: what the program says of it, what the engine here makes of that, and what is asked
 * of the program. */
import type { AirPicture } from '../scene/scene.ts';
import { Cell, type Store } from '../store.ts';
import type { Page } from '../ui/page.ts';
import { Hands } from './hands.ts';
import type { Do, Line, News, Pacing } from './line.ts';
import type { Reached } from './lockstep.ts';
import { run_clock } from '../clock.ts';

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

/** The time that the page shows: smooth, and hardly behind what was flown. Who looks back is left alone until he comes to the present again. */
export class Present {
  readonly following = new Cell(true);  // The page shows the present.
  private flown = 0;
  private rate = 1;  // Of the mission; Infinity: as fast as it goes.
  private paused = true;
  private moving = false;  // It is this that sets the time.
  readonly stop: () => void;

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
    this.stop = run_clock(store, (passed) => this.move(passed));
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
  }
  /** To the present, and on with it. */
  now(): void {
    this.following.set(true);
    this.show(this.flown);
    this.store.set({ playing: !this.paused });
  }
  /** Plays what is past, or stops there. */
  toggle_past(): void {
    const { playing } = this.store.get();
    this.store.set({ playing: !playing });
  }

  private show(time: number): void {
    this.moving = true;
    this.store.set({ time });
    this.moving = false;
  }
  private move(passed: number): void {
    const { time, rate } = this.store.get();
    if (this.following.get()) this.show(next_shown(time, this.flown, this.rate, passed));
    else if (time + passed * rate >= this.flown) this.now();
    else this.show(time + passed * rate);
  }
}

export interface Status {
  rate: number;  // Infinity: as fast as it goes.
  paused: boolean;
  viewers: number;
  shared: boolean;  // Other programs take part: it goes by the clock.
  outcome: string;  // running, or why it is over.
  broken: string;  // Why there is no line to the program now; "" if there is.
}

export const kRates = [0.1, 0.25, 0.5, 1, 2, 4, 8, 20, 50, 100, Infinity];
/** ms: how long words stay that answer something. */
const kSaid = 6000;

export class Live {
  readonly status = new Cell<Status>({ rate: 1, paused: true, viewers: 0, shared: false, outcome: 'running', broken: '' });
  readonly pacing = new Cell<Pacing | null>(null);
  /** Where the world here is not the one of the program, and the hashes of both. */
  readonly disagreement = new Cell<{ step: number; here: string; there: string } | null>(null);
  readonly checked = new Cell(-1);  // The last step whose hash was compared.
  readonly said = new Cell('');  // What the program refused, for some seconds.
  readonly pointing = new Cell(false);  // A click in the air picture is the point to fly to.
  present: Present | null = null;
  page: Page | null = null;
  scene: AirPicture | null = null;
  readonly hands: Hands;
  flown = 0;  // s: up to which it is drawn.
  private forget: ReturnType<typeof setTimeout> | undefined;

  /** `home`: the mission was chosen on the home page. */
  constructor(private readonly line: () => Line | null, private readonly until: () => number, readonly home: boolean) {
    this.hands = new Hands(this);
  }

  /** It is on the screen; returns how to leave it. */
  show(page: Page): () => void {
    this.page = page;
    const looks_back = this.present?.following.get() === false;
    const present = (this.present = new Present(page.store));
    present.following.set(!looks_back);
    this.grow_axis(page.store);
    this.tell();
    return () => {
      present.stop();
      this.hands.drop();
    };
  }

  news({ rate, paused, viewers, outcome, shared = false }: News): void {
    const now = { rate: rate === 'max' ? Infinity : rate, paused, viewers, shared, outcome, broken: '' };
    const before = this.status.get();
    if ((Object.keys(now) as (keyof Status)[]).some((key) => now[key] !== before[key])) this.status.set(now);
    this.tell();
  }
  reached({ step, time, drawn, checked, agrees, here, there }: Reached): void {
    if (drawn) this.flown = time;
    if (checked && agrees) this.checked.set(step);
    if (!agrees && !this.disagreement.get()) this.disagreement.set({ step, here, there });
    if (this.page) this.grow_axis(this.page.store);
    this.tell();
  }
  broken(words: string): void {
    this.status.set({ ...this.status.get(), broken: words });
    this.hands.drop();
    this.tell();
  }
  refused(words: string): void {
    this.said.set(words);
    this.hands.refused(words);
    clearTimeout(this.forget);
    this.forget = setTimeout(() => this.said.set(''), kSaid);
  }

  is_over(): boolean {
    return this.status.get().outcome !== 'running';
  }
  ask(what: Do): void {
    if (!this.line()?.say(what)) this.refused('there is no line to the program now');
  }
  /** Orders for the chosen player, or for his flight. */
  order(order: string, rest: Record<string, unknown>): void {
    this.ask({ do: 'order', order, ...rest });
  }
  /** The mission, at the present; else what is past. */
  toggle(): void {
    const { present } = this;
    if (!present) return;
    if (!present.following.get()) return present.toggle_past();
    this.ask({ do: this.status.get().paused ? 'play' : 'pause' });
  }
  change_rate(direction: 1 | -1): void {
    const { rate } = this.status.get();
    const next = direction > 0 ? kRates.find((one) => one > rate) : kRates.findLast((one) => one < rate);
    if (next !== undefined) this.set_rate(next);
  }
  set_rate(rate: number): void {
    this.ask({ do: 'rate', rate: rate === Infinity ? 'max' : rate });
  }

  private tell(): void {
    const { rate, paused, broken } = this.status.get();
    this.present?.told(this.flown, rate, paused || broken !== '' || this.is_over());
  }
  /** The timeline grows in leaps, so that it need not be drawn anew all the time. */
  private grow_axis(store: Store): void {
    const { end } = store.get();
    if (this.is_over()) store.set({ end: this.flown });
    else if (this.flown > end - 1 || end > 4 * Math.max(this.flown, 30))
      store.set({ end: Math.max(this.flown, Math.min(this.until(), Math.max(60, Math.ceil((1.35 * this.flown) / 60) * 60))) });
  }
}
