// SPDX-License-Identifier: MIT
/** What a page carries in itself: the engine, runs, launch zones, texts, a campaign and which replicate of it is meant. */
import { start, type RunningEngine } from './engine/engine.ts';
import { unpacked } from './packed.ts';

export type PartType = 'engine' | 'run' | 'run-file' | 'live' | 'zones' | 'texts' | 'campaign' | 'replicate';

export function parts(...types: PartType[]): Element[] {
  return [...document.querySelectorAll(types.map((type) => `script[type="application/x-eyrie-${type}"]`).join())];
}
export function is_part(script: Element, type: PartType): boolean {
  return script.getAttribute('type') === `application/x-eyrie-${type}`;
}

/** The words that stand in the page already are on the screen before anything is unpacked. */
export function painted(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
}

export async function engine_module(): Promise<WebAssembly.Module> {
  const [script] = parts('engine');
  if (!script) throw new Error('there is no engine in this page that could fly its run');
  return WebAssembly.compile(await unpacked(script));
}

let zones: Promise<Uint8Array> | null = null;

/** An engine of its own that knows the launch zones of the page; `progress` is told s of simulated time in long answers. */
export async function started(module: WebAssembly.Module, progress: (time: number) => void = () => {}): Promise<RunningEngine> {
  const engine = start(module, progress);
  const [script] = parts('zones');
  if (script) await engine.take_zones(await (zones ??= unpacked(script)));
  return engine;
}
