// SPDX-License-Identifier: MIT
/** The debrief page: opens the runs that stand in it and shows them. */
import { render } from 'preact';
import { engine_module, is_part, painted, parts, unpack } from './parts.ts';
import { decode } from './run/decode.ts';
import type { Run } from './run/run.ts';
import { flown_again, put_theme, show_as_flown, unless_damaged } from './show.tsx';
import { first_view } from './store.ts';

const kMostRuns = 2;

const share = new Map<Element, number>();
function tell(script: Element, done: number, host: HTMLElement): void {
  share.set(script, done);
  const all = [...share.values()];
  const percent = Math.floor((100 * all.reduce((a, b) => a + b, 0)) / all.length);
  const words = host.querySelector('#opening');
  if (words) words.textContent = `Flying the run again: ${percent} %`;
}

async function flown(script: Element, module: Promise<WebAssembly.Module>, host: HTMLElement, begun: (run: Run) => void): Promise<Run> {
  share.set(script, 0);
  return unless_damaged(async () => flown_again(await module, await unpack(script), (done) => tell(script, done, host), begun));
}

async function open(host: HTMLElement): Promise<void> {
  put_theme(first_view(0).theme);
  const scripts = parts('run', 'run-file');
  if (!scripts.length) throw new Error('there is no run in this page; ./eyrie debrief RUN writes one with a run');
  if (scripts.length > kMostRuns) throw new Error(`there are ${scripts.length} runs in this page, and it shows ${kMostRuns} at most`);
  await painted();
  const module = scripts.some((script) => is_part(script, 'run-file')) ? engine_module() : null;
  await show_as_flown(scripts.map((script) => (begun) =>
    module && is_part(script, 'run-file') ? flown(script, module, host, begun) : unless_damaged(async () => decode(await unpack(script)))), host);
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
