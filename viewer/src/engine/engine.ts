// SPDX-License-Identifier: MIT
/** The engine as the page asks it: every question is answered by a worker, one after the other. */
import worker_code from 'worker:./worker.ts';
import { EngineError } from './module.ts';
import type { Engine } from './questions.ts';
import type { Said } from './worker.ts';

/** `end` stops it at once: what was asked and is not answered is rejected. */
export type RunningEngine = Engine & { end(): void };

/** An engine of its own; `progress` is told s of simulated time during long answers. */
export function start(module: WebAssembly.Module, progress: (time: number) => void): RunningEngine {
  const worker = new Worker(URL.createObjectURL(new Blob([worker_code], { type: 'text/javascript' })));
  const waiting = new Map<number, { done(answer: unknown): void; failed(error: EngineError): void }>();
  let last = 0;
  let over = '';  // Why nothing is answered any more.
  worker.onmessage = ({ data }: MessageEvent<Said>) => {
    if ('progress' in data) return progress(data.progress);
    const { done, failed } = waiting.get(data.id)!;
    waiting.delete(data.id);
    if ('error' in data) failed(new EngineError(data.error, data.problems));
    else done(data.bytes.length ? { ...(data.answer as object), bytes: data.bytes } : data.answer);
  };
  const fail = (words: string): void => {
    over = words;
    for (const { failed } of waiting.values()) failed(new EngineError(words));
    waiting.clear();
  };
  worker.onerror = (event) => fail(event.message || 'the engine could not be started');
  const end = (): void => {
    worker.terminate();
    fail('the engine was stopped');
  };
  worker.postMessage({ module });
  const ask = (question: string) => (first?: object | Uint8Array) =>
    new Promise((done, failed) => {
      if (over) return failed(new EngineError(over));
      const id = ++last;
      waiting.set(id, { done, failed });
      const with_bytes = first instanceof Uint8Array;
      worker.postMessage({ id, question, request: with_bytes ? {} : (first ?? {}), bytes: with_bytes ? first : undefined });
    });
  const known: Record<string, unknown> = { then: undefined, end };
  return new Proxy({} as RunningEngine, { get: (_, question: string) => (question in known ? known[question] : ask(question)) });
}
