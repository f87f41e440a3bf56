// SPDX-License-Identifier: MIT
/** The debrief page: opens the runs that stand in it, or flies a replicate of the campaign in it, and shows them. */
import { engine_module, is_part, painted, parts } from './parts.ts';
import { unpacked } from './packed.ts';
import { decode } from './run/decode.ts';
import { open_live } from './live/open.tsx';
import { flown_again, put_theme, say_failure, show_as_flown, type Opening } from './show.tsx';
import { open_replicate } from './replicate.tsx';
import { first_view } from './store.ts';
import { remembered } from './ui/link.ts';

const kMostRuns = 2;

async function open(host: HTMLElement): Promise<void> {
  put_theme({ ...first_view(0), ...remembered() }.theme);
  const [campaign] = parts('campaign');
  const told = (percent: number): void => {
    const words = host.querySelector('#opening');
    if (words) words.textContent = `Flying the run again: ${percent} %`;
  };
  if (campaign) return open_replicate(campaign, host, told);
  if (parts('live').length) return open_live(host);
  const scripts = parts('run', 'run-file');
  if (!scripts.length) throw new Error('there is no run in this page; ./eyrie debrief RUN writes one with a run');
  if (scripts.length > kMostRuns) throw new Error(`there are ${scripts.length} runs in this page, and it shows ${kMostRuns} at most`);
  await painted();
  const module = scripts.some((script) => is_part(script, 'run-file')) ? engine_module() : null;
  const flights = scripts.map((script): Opening => async (told, begun) =>
    is_part(script, 'run-file') ? flown_again(await module!, await unpacked(script), told, begun) : decode(await unpacked(script)));
  await show_as_flown(flights, host, told);
}

const host = document.getElementById('app')!;
open(host).catch((error: unknown) => say_failure(host, 'This run cannot be opened', error,
  <><code>./eyrie debrief RUN</code>, of the Eyrie that recorded it, writes the page again.</>));
