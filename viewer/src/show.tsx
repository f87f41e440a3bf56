// SPDX-License-Identifier: MIT
/** Runs on the screen: their stores, the clock, the address, and the page that shows them. */
import { render, type ComponentChildren } from 'preact';
import { run_clock } from './clock.ts';
import type { RunningEngine } from './engine/engine.ts';
import { EngineError, words_of } from './engine/module.ts';
import type { About } from './engine/questions.ts';
import { started } from './parts.ts';
import type { Live } from './live/live.ts';
import { decode } from './run/decode.ts';
import type { Run } from './run/run.ts';
import { coast_of } from './scene/coast.ts';
import type { AirPicture } from './scene/scene.ts';
import { View, Store } from './store.ts';
import { keep_in_sight, show_cause } from './ui/actions.ts';
import { App } from './ui/app.tsx';
import { link_pages } from './ui/compare.tsx';
import type { Back } from './ui/header.tsx';
import { follow_address, read_link, remembered } from './ui/link.ts';
import { first_moment } from './ui/story.tsx';
import { speak } from './words/text.ts';
import { grown, Page } from './ui/page.ts';

declare global {
  interface Window {
    /** What the page shows of itself to tests: all runs, and of the first its store and its air picture. */
    eyrie?: { run: Run; store: Store; scene: AirPicture; runs: Run[] };
  }
}

const kDamaged = 'the data of the run is damaged or incomplete';

/** What goes wrong while unpacking is of no use to anybody, except that it did. */
async function unless_damaged<T>(unpacked: () => Promise<T>): Promise<T> {
  try {
    return await unpacked();
  } catch (error) {
    if (error instanceof EngineError || (error instanceof Error && error.constructor === Error)) throw error;
    throw new Error(kDamaged, { cause: error });
  }
}

/** s: so much of a run is shown while the rest of it is being flown. */
const kFirst = 5;

/** Flies a run file again, which compares every hash with the recorded one; `told` which part is done, `begun` with its beginning.
 * `left` ends its engine. */
export async function flown_again(
  module: WebAssembly.Module, file: Uint8Array, told: (part: number) => void, begun: (run: Run) => void, left?: AbortSignal,
): Promise<Run> {
  let until = Infinity;
  const engine = await started(module, (time) => told(time / until));
  if (left?.aborted) engine.end();
  left?.addEventListener('abort', () => engine.end());
  const about = await engine.open(file);
  until = about.until ?? Infinity;
  return seen(engine, about, begun);
}

/** The run that the engine has, flown again. */
export async function seen(engine: RunningEngine, { latitude, longitude }: About, begun: (run: Run) => void): Promise<Run> {
  const beginning = engine.page({ until: kFirst });
  coast_of({ latitude: latitude!, longitude: longitude! });  // Made meanwhile, for the picture of it.
  const first = await beginning;
  const rest = engine.page({});  // Flown while the beginning is drawn.
  rest.catch(() => {});  // Told below, unless the beginning cannot be shown.
  begun({ ...decode(first.bytes), engine, is_part: true });
  return { ...decode((await rest).bytes), engine };
}

/** Says why a page cannot be opened, instead of it. */
export function say_failure(host: HTMLElement, title: string, error: unknown, hint?: ComponentChildren): void {
  host.replaceChildren();
  render(<div class="failure" role="alert"><h1>{title}</h1><p>{words_of(error)}</p>{hint && <p>{hint}</p>}</div>, host);
}

export function put_theme(theme: View['theme']): void {
  document.documentElement.dataset['theme'] = theme;
}

function pages_of(runs: Run[], view: Partial<View>): Page[] {
  const end = Math.max(...runs.map((run) => run.about.duration));
  return twinned(runs.map((run, i) => {
    const store = new Store({ ...new View(), ...remembered(), ...read_link(run, location.hash, end), ...view, end });
    return new Page(run, store, runs.length > 1 ? 'AB'[i]! : '');
  }));
}

/** Of two runs each knows the other. */
function twinned(pages: Page[]): Page[] {
  const [a, b] = pages;
  if (a && b) [a.twin, b.twin] = [b, a];
  return pages;
}

/** To the first moment worth seeing, unless somebody has said where to be. */
function begin(page: Page, { time }: Partial<View>): void {
  const { run, store } = page;
  const line = run.is_part ? -1 : first_moment(run);
  const link = read_link(run, location.hash);
  if (line < 0 || time !== undefined || link.time !== undefined || store.get().time > 0 || store.get().playing) return;
  const { selected } = store.get();
  show_cause(page, line);
  if (link.selected !== undefined) store.set({ selected });
}

function ready(pages: Page[], scene: AirPicture): void {
  const { run, store, live } = pages[0]!;
  if (live) live.scene = scene;
  // from the beginning of the navigation
  performance.measure(run.is_part ? 'eyrie-picture' : 'eyrie-open');
  if (run.is_part) return;
  window.eyrie = { run, store, scene, runs: pages.map((page) => page.run) };
  document.body.dataset['ready'] = 'true';
}

export type Shown = ReturnType<typeof show>;

/** Shows one run, or two to compare, first as `view` says; `back` is where the page came from. */
export function show(runs: Run[], host: HTMLElement, view: Partial<View> = {}, back?: Back, live?: Live) {
  if (runs.some((run) => !run.players.length)) throw new Error('nobody took part in this run');
  let pages = pages_of(runs, view);
  const [first, second] = pages as [Page, Page | undefined];
  if (second) link_pages(first, second);
  if (live) first.live = live;
  const stops = [
    first.store.subscribe((now, before) => {
      if (now.theme !== before.theme) put_theme(now.theme);
      if (now.units === before.units) return;
      speak(now.units);
      // once everybody has heard of it
      queueMicrotask(redraw);
    }),
    live ? live.show(first) : run_clock(first.store), keep_in_sight(first), follow_address(first),
  ];
  document.title = `${runs.map((run) => run.about.scenario).join(' and ')} – Eyrie ${live ? 'live' : 'debrief'}`;
  let key = 'first';
  const draw = (): void => {
    const scenes = new Map<Page, AirPicture>();
    const mounted = (page: Page, scene: AirPicture): void => {
      scenes.set(page, scene);
      if (scenes.size === pages.length) ready(pages, scenes.get(pages[0]!)!);
    };
    render(<App key={key} pages={pages} back={back} onScene={mounted} />, host);
  };
  /** The same panels, with pages that are new to them. */
  const redraw = (): void => {
    pages = twinned(pages.map(grown));
    if (live) live.page = pages[0]!;
    draw();
  };
  host.replaceChildren();
  put_theme(first.store.get().theme);
  speak(first.store.get().units);
  if (!live) begin(first, view);
  draw();
  return {
    /** The same runs, whole. */
    update(whole: Run[]): void {
      pages = twinned(pages.map(({ store, letter }, i) => new Page(whole[i]!, store, letter)));
      begin(pages[0]!, view);
      key = 'whole';
      draw();
    },
    /** There is more of them, in the same objects. */
    grow: redraw,
    close(): void {
      for (const stop of stops) stop();
      render(null, host);
      delete window.eyrie;
      delete document.body.dataset['ready'];
    },
  };
}

/** Makes a run; `told` which part of it is done, `begun` with its beginning. */
export type Opening = (told: (part: number) => void, begun: (run: Run) => void) => Promise<Run>;

/** Shows runs as soon as there is a part of each of them, and whole when they are; `told` how much is done, in percent. */
export async function show_as_flown(
  flights: Opening[], host: HTMLElement, told: (percent: number) => void, view: Partial<View> = {}, back?: Back,
): Promise<Shown> {
  const parts = new Map<number, Run>();
  const done = flights.map(() => 0);
  let shown: Shown | null = null;
  const tell = (i: number) => (part: number): void => {
    done[i] = part;
    told(Math.floor((100 * done.reduce((a, b) => a + b, 0)) / done.length));
  };
  const begin = (i: number) => (part: Run): void => {
    parts.set(i, part);
    if (parts.size === flights.length) shown = show(flights.map((_, k) => parts.get(k)!), host, view, back);
  };
  try {
    const runs = await Promise.all(flights.map((flight, i) => unless_damaged(() => flight(tell(i), begin(i)))));
    const begun = shown as Shown | null;
    begun?.update(runs);
    return begun ?? show(runs, host, view, back);
  } catch (error) {
    (shown as Shown | null)?.close();
    throw error;
  }
}
