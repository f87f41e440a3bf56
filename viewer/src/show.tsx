// SPDX-License-Identifier: MIT
/** Runs on the screen: their stores, the clock, the address, and the page that shows them. */
import { render } from 'preact';
import { run_clock } from './clock.ts';
import { EngineError } from './engine/module.ts';
import { started } from './parts.ts';
import { decode } from './run/decode.ts';
import type { Run } from './run/run.ts';
import type { SceneHandle } from './scene/scene.ts';
import { first_view, Store, type View } from './store.ts';
import { keep_in_sight } from './ui/actions.ts';
import { follow_address } from './ui/address.ts';
import { App } from './ui/app.tsx';
import { link_pages } from './ui/compare.tsx';
import type { Back } from './ui/header.tsx';
import { read_link } from './ui/link.ts';
import { make_page, type Page } from './ui/page.ts';
import { leader_colors } from './ui/spans.ts';

const kDamaged = 'the data of the run is damaged or incomplete';

/** What goes wrong while unpacking is of no use to anybody, except that it did. */
export async function unless_damaged<T>(unpacked: () => Promise<T>): Promise<T> {
  try {
    return await unpacked();
  } catch (error) {
    if (error instanceof EngineError || (error instanceof Error && error.constructor === Error)) throw error;
    throw new Error(kDamaged, { cause: error });
  }
}

/** Flies a run file again, which compares every hash with the recorded one; `told` which part is done. */
export async function flown_again(module: WebAssembly.Module, file: Uint8Array, told: (part: number) => void): Promise<Run> {
  let until = Infinity;
  const engine = await started(module, (time) => told(time / until));
  until = (await engine.open(file)).until ?? Infinity;
  return { ...decode((await engine.page({})).bytes), engine };
}

export function put_theme(theme: View['theme']): void {
  document.documentElement.dataset['theme'] = theme;
}

function pages_of(runs: Run[], view: Partial<View>): Page[] {
  const end = Math.max(...runs.map((run) => run.about.duration));
  const colors = leader_colors(runs);
  return runs.map((run, i) => {
    const store = new Store({ ...first_view(0), ...view, end, ...read_link(run, location.hash, end) });
    return make_page(run, store, runs.length > 1 ? 'AB'[i]! : '', colors);
  });
}

function ready(pages: Page[], scene: SceneHandle): void {
  window.eyrie = { run: pages[0]!.run, store: pages[0]!.store, scene, runs: pages.map((page) => page.run) };
  document.body.dataset['ready'] = 'true';
  // from the beginning of the navigation
  performance.measure('eyrie-open');
}

/** Shows one run, or two to compare, first as `view` says; `back` is where the page came from. Returns how to take it away. */
export function show(runs: Run[], host: HTMLElement, view: Partial<View> = {}, back?: Back): () => void {
  if (runs.some((run) => !run.players.length)) throw new Error('nobody took part in this run');
  const pages = pages_of(runs, view);
  const [first, second] = pages as [Page, Page | undefined];
  if (second) link_pages(first, second);
  const stops = [
    first.store.subscribe((now, before) => now.theme !== before.theme && put_theme(now.theme)),
    run_clock(first.store), keep_in_sight(first), follow_address(first),
  ];
  document.title = `${runs.map((run) => run.about.scenario).join(' and ')} – Eyrie debrief`;
  const scenes = new Map<Page, SceneHandle>();
  const mounted = (page: Page, scene: SceneHandle): void => {
    scenes.set(page, scene);
    if (scenes.size === pages.length) ready(pages, scenes.get(first)!);
  };
  host.replaceChildren();
  render(<App pages={pages} back={back} onScene={mounted} />, host);
  return () => {
    for (const stop of stops) stop();
    render(null, host);
    delete window.eyrie;
    delete document.body.dataset['ready'];
  };
}
