// SPDX-License-Identifier: MIT
/** Opens the runs that stand in the page and shows them. */
import { render } from 'preact';
import { run_clock } from './clock.ts';
import { start } from './engine/engine.ts';
import { EngineError } from './engine/module.ts';
import { decode, unpack } from './run/decode.ts';
import type { Run } from './run/run.ts';
import type { SceneHandle } from './scene/scene.ts';
import { first_view, Store, type View } from './store.ts';
import { keep_in_sight } from './ui/actions.ts';
import { App } from './ui/app.tsx';
import { link_pages } from './ui/compare.tsx';
import { read_link } from './ui/link.ts';
import { follow_address } from './ui/address.ts';
import { make_page, type Page } from './ui/page.ts';
import { leader_colors } from './ui/spans.ts';

const kMostRuns = 2;

/** The words that stand in the page already are on the screen before anything is unpacked. */
function painted(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
}

function pages_of(runs: Run[]): Page[] {
  const duration = Math.max(...runs.map((run) => run.about.duration));
  const colors = leader_colors(runs);
  return runs.map((run, i) => {
    const store = new Store({ ...first_view(0), ...read_link(run, location.hash, duration) });
    return make_page(run, store, runs.length > 1 ? 'AB'[i]! : '', duration, colors);
  });
}

function put_theme({ theme }: Pick<View, 'theme'>): void {
  document.documentElement.dataset.theme = theme;
}

const kDamaged = 'the data of the run is damaged or incomplete';

/** What went wrong while unpacking is of no use to anybody, except that it did. */
async function unpacked(script: Element): Promise<Run> {
  try {
    return decode(await unpack(script.textContent ?? ''));
  } catch (error) {
    if (error instanceof Error && error.constructor === Error) throw error;
    throw new Error(kDamaged, { cause: error });
  }
}

const share = new Map<Element, number>();
function tell(script: Element, done: number, host: HTMLElement): void {
  share.set(script, done);
  const all = [...share.values()];
  const percent = Math.floor((100 * all.reduce((a, b) => a + b, 0)) / all.length);
  const words = host.querySelector('#opening');
  if (words) words.textContent = `Flying the run again: ${percent} %`;
}

/** Flies a run file again, which compares every hash with the recorded one. */
async function flown(script: Element, module: Promise<WebAssembly.Module>, host: HTMLElement): Promise<Run> {
  share.set(script, 0);
  let until = Infinity;
  const engine = start(await module, (time) => tell(script, time / until, host));
  try {
    const file = await unpack(script.textContent ?? '');
    until = (await engine.open(file)).until ?? Infinity;
    return { ...decode(await engine.page()), engine };
  } catch (error) {
    if (error instanceof EngineError) throw error;
    throw new Error(kDamaged, { cause: error });
  }
}

async function engine_module(): Promise<WebAssembly.Module> {
  const script = document.querySelector('script[type="application/x-eyrie-engine"]');
  if (!script) throw new Error('there is no engine in this page that could fly its run');
  return WebAssembly.compile(await unpack(script.textContent ?? ''));
}

function ready(pages: Page[], scene: SceneHandle): void {
  window.eyrie = { run: pages[0]!.run, store: pages[0]!.store, scene, runs: pages.map((page) => page.run) };
  document.body.dataset.ready = 'true';
  // from the beginning of the navigation
  performance.measure('eyrie-open');
}

async function open(host: HTMLElement): Promise<void> {
  put_theme(first_view(0));
  const scripts = [...document.querySelectorAll('script[type="application/x-eyrie-run"], script[type="application/x-eyrie-run-file"]')];
  const is_file = (script: Element) => script.getAttribute('type') === 'application/x-eyrie-run-file';
  if (!scripts.length) throw new Error('there is no run in this page; ./eyrie debrief RUN writes one with a run');
  if (scripts.length > kMostRuns) throw new Error(`there are ${scripts.length} runs in this page, and it shows ${kMostRuns} at most`);
  await painted();
  const module = scripts.some(is_file) ? engine_module() : null;
  const runs = await Promise.all(scripts.map((script) => (module && is_file(script) ? flown(script, module, host) : unpacked(script))));
  if (runs.some((run) => !run.players.length)) throw new Error('nobody took part in this run');
  const pages = pages_of(runs);
  const [first, second] = pages as [Page, Page | undefined];
  if (second) link_pages(first, second);
  first.store.subscribe((now, before) => now.theme !== before.theme && put_theme(now));
  run_clock(first.store, first.duration);
  keep_in_sight(first);
  follow_address(first);
  document.title = `${runs.map((run) => run.about.scenario).join(' and ')} – Eyrie debrief`;

  host.replaceChildren();
  const scenes = new Map<Page, SceneHandle>();
  const mounted = (page: Page, scene: SceneHandle): void => {
    scenes.set(page, scene);
    if (scenes.size === pages.length) ready(pages, scenes.get(first)!);
  };
  render(<App pages={pages} onScene={mounted} />, host);
}

function fail(host: HTMLElement, error: unknown): void {
  host.replaceChildren();
  const words = error instanceof Error ? error.message : String(error);
  render(
    <div class="failure" role="alert">
      <h1>This run cannot be opened</h1>
      <p>{words}</p>
      <p>Try to write the page again with <code>./eyrie debrief RUN</code>.</p>
    </div>,
    host,
  );
}

const host = document.getElementById('app')!;
open(host).catch((error: unknown) => fail(host, error));
