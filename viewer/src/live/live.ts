// SPDX-License-Identifier: MIT
/** A mission that is being flown, as its page knows it: what the program says of it, what the engine here makes of that, and what is asked
 * of the program; and the time that the page shows of it, smooth and hardly behind what was flown. Who looks back is left alone until he
 * comes to the present again. */
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
  readonly said = new Cell('');  // What was refused, and why, for some seconds.
  readonly pointing = new Cell(false);  // A click in the air picture is the point to fly to.
  readonly following = new Cell(true);  // The page shows the present.
  page: Page | null = null;
  scene: AirPicture | null = null;
  readonly hands: Hands;
  flown = 0;  // s: up to which it is drawn.
  private moving = false;  // It is this that sets the time of the page.
  private forget: ReturnType<typeof setTimeout> | undefined;

  /** `home`: the mission was chosen on the home page. */
  constructor(private readonly line: () => Line | null, private readonly until: () => number, readonly home: boolean) {
    this.hands = new Hands(this);
  }

  /** It is on the screen; returns how to leave it. */
  show(page: Page): () => void {
    this.page = page;
    const { store } = page;
    const stops = [
      store.subscribe((now, before) => {
        if (this.moving || now.time === before.time) return;
        // nobody sees what was not flown yet
        if (now.time >= this.flown) this.to_present();
        else if (this.following.get()) {
          this.following.set(false);
          store.set({ playing: false });
        }
      }), run_clock(store, (passed) => this.move(store, passed)), () => this.hands.drop(),
    ];
    this.grow_axis(store);
    this.tell();
    return () => stops.forEach((stop) => stop());
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
    this.hands.refused(words);
    this.say(words);
  }
  say(words: string): void {
    this.said.set(words);
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
    const { store } = this.page!;
    if (!this.following.get()) return store.set({ playing: !store.get().playing });
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

  /** To the present, and on with it. */
  to_present(): void {
    const { store } = this.page!;
    this.following.set(true);
    this.put(store, this.flown);
    store.set({ playing: this.goes_on() });
  }

  private goes_on(): boolean {
    const { paused, broken } = this.status.get();
    return !paused && broken === '' && !this.is_over();
  }
  private put(store: Store, time: number): void {
    this.moving = true;
    store.set({ time });
    this.moving = false;
  }
  private move(store: Store, passed: number): void {
    const { time, rate } = store.get();
    if (this.following.get()) this.put(store, next_shown(time, this.flown, this.status.get().rate, passed));
    else if (time + passed * rate >= this.flown) this.to_present();
    else this.put(store, time + passed * rate);
  }
  /** How far it is, and whether it goes on. */
  private tell(): void {
    if (!this.page || !this.following.get()) return;
    const { store } = this.page;
    const playing = this.goes_on();
    if (!playing) this.put(store, this.flown);
    if (store.get().playing !== playing) store.set({ playing });
  }
  /** The timeline grows in leaps, so that it need not be drawn anew all the time. */
  private grow_axis(store: Store): void {
    const { end } = store.get();
    if (this.is_over()) store.set({ end: this.flown });
    else if (this.flown > end - 1 || end > 4 * Math.max(this.flown, 30))
      store.set({ end: Math.max(this.flown, Math.min(this.until(), Math.max(60, Math.ceil((1.35 * this.flown) / 60) * 60))) });
  }
}
