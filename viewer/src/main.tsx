// SPDX-License-Identifier: MIT
/** The debrief page: opens the runs that stand in it, or flies a replicate of the campaign in it, and shows them. */
import { engine_module, is_part, painted, parts, started } from './parts.ts';
import { unpacked } from './packed.ts';
import { decode } from './run/decode.ts';
import { open_live } from './live/open.tsx';
import { type Opening, flown_again, put_theme, say_failure, seen, show_as_flown } from './show.tsx';
import { View } from './store.ts';
import { remembered, said_in } from './ui/link.ts';
import { listen } from './events.ts';
import type { Run } from './run/run.ts';

/** As apps/eyrie/campaigns.cpp writes it. */
interface Campaign {
  files: Record<string, string>;
  scenario: string;
  sets: string[][];  // By cell.
}

/** As the report writes it. */
interface Replicate {
  name: string;
  cell: number;
  seed: string;
  hash: string;  // Of its last world, in the results.
  command: string;  // That flies it elsewhere.
}

/** Which replicate an address means. */
function meant(): string {
  const said = said_in(location.hash);
  return `${said.get('cell')} ${said.get('replicate')}`;
}

/** A replicate of a campaign, flown here and compared with its result: what the report of a campaign opens. */
async function open_replicate(part: Element, host: HTMLElement, told: (percent: number) => void): Promise<void> {
  const [said] = parts('replicate');
  if (!said) throw new Error('nobody says which replicate is meant: the report of a campaign does');
  const { name, cell, seed, hash, command } = JSON.parse(said.textContent!) as Replicate;
  // the report is what stands in the file: it comes back, or opens another one
  const opened = meant();
  listen(window, { hashchange: () => meant() !== opened && location.reload() });
  const back = (): void => {
    const { measure, cell } = Object.fromEntries(said_in(location.hash));
    history.pushState(null, '', `#measure=${measure ?? 0}&cell=${cell}`);
    location.reload();
  };
  await painted();
  const flown_here: Opening = async (progress, begun) => {
    const [module, bytes] = await Promise.all([engine_module(), unpacked(part)]);
    const { files, scenario, sets } = JSON.parse(new TextDecoder().decode(bytes)) as Campaign;
    let until = Infinity;
    const engine = await started(module, (time) => progress(time / until));
    const about = await engine.load({ texts: { files, scenario, sets: sets[cell]! }, seed });
    until = about.until ?? Infinity;
    const flown = await engine.fly({});
    if (flown.hash !== hash)
      throw new Error(`It ends otherwise here than in the results, with the world ${flown.hash} and not ${hash}: another version of Eyrie flew the campaign.`);
    const named = (run: Run): Run => ({ ...run, about: { ...run.about, scenario: name }, verified: `its last world has the hash of the results, ${hash}` });
    return named(await seen(engine, about, (first) => begun(named(first))));
  };
  await show_as_flown([flown_here], host, told, {}, { label: 'report', go: back }).catch((error: unknown) => say_failure(host, name, error, <>
    Elsewhere it is flown by <code>{command}</code> <button type="button" onClick={back}>← report</button>
  </>));
}

const kMostRuns = 2;

async function open(host: HTMLElement): Promise<void> {
  put_theme({ ...new View(), ...remembered() }.theme);
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
