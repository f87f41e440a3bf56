// SPDX-License-Identifier: MIT
/** What a page carries in itself: the engine, runs, launch zones, texts, a campaign and which replicate of it is meant. */
import { start, type RunningEngine } from './engine/engine.ts';

export type PartType = 'engine' | 'run' | 'run-file' | 'live' | 'zones' | 'texts' | 'campaign' | 'replicate';

export function parts(...types: PartType[]): Element[] {
  return [...document.querySelectorAll(types.map((type) => `script[type="application/x-eyrie-${type}"]`).join())];
}
export function is_part(script: Element, type: PartType): boolean {
  return script.getAttribute('type') === `application/x-eyrie-${type}`;
}

/** From base64 of a zlib stream. */
export async function unpack(part: Element): Promise<Uint8Array<ArrayBuffer>> {
  const packed = Uint8Array.from(atob((part.textContent ?? '').trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The words that stand in the page already are on the screen before anything is unpacked. */
export function painted(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
}

export async function engine_module(): Promise<WebAssembly.Module> {
  const [script] = parts('engine');
  if (!script) throw new Error('there is no engine in this page that could fly its run');
  return WebAssembly.compile(await unpack(script));
}

let zones: Promise<Uint8Array> | null = null;

/** An engine of its own that knows the launch zones of the page; `progress` is told s of simulated time in long answers. */
export async function started(module: WebAssembly.Module, progress: (time: number) => void = () => {}): Promise<RunningEngine> {
  const engine = start(module, progress);
  const [script] = parts('zones');
  if (script) await engine.take_zones(await (zones ??= unpack(script)));
  return engine;
}
