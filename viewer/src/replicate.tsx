// SPDX-License-Identifier: MIT
/** A replicate of a campaign, flown here and compared with its result: what the report of a campaign opens. */
import { listen } from './events.ts';
import { engine_module, painted, parts, started } from './parts.ts';
import { unpacked } from './packed.ts';
import type { Run } from './run/run.ts';
import { say_failure, seen, show_as_flown, type Opening } from './show.tsx';
import { said_in } from './ui/link.ts';

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

export async function open_replicate(part: Element, host: HTMLElement, told: (percent: number) => void): Promise<void> {
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
