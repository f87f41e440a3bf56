// SPDX-License-Identifier: MIT
/** The engine as the page asks it: every question is answered by a worker, one after the other. */
import worker_code from 'worker:./worker.ts';
import { Cell } from '../store.ts';
import { EngineError } from './module.ts';
import type { Engine } from './questions.ts';
import type { Question, Said } from './worker.ts';

/** `end` stops it at once: what was asked and is not answered is rejected. `stop` does so with one kind of question, and makes the
 * engine anew for the others. `reached` is s of simulated time, in a long answer. */
export type RunningEngine = Engine & { end(): void; stop(question: keyof Engine): void; reached: Cell<number> };

interface Asked extends Question {
  done(answer: unknown): void;
  failed(error: EngineError): void;
}
/** What makes an engine what it is; the run that it has begins with one of the second ones. */
const kMakes = ['take_zones', 'open', 'load', 'fly', 'end_flight', 'page'];
const kBegins = ['open', 'load'];

/** An engine of its own; `progress` is told s of simulated time during long answers. */
export function start(module: WebAssembly.Module, progress: (time: number) => void): RunningEngine {
  const waiting = new Map<number, Asked>();
  const reached = new Cell(0);
  let made: Asked[] = [];
  let sought: Asked[] = [];  // The last step that it went to.
  let last = 0;
  let over = '';  // Why nothing is answered any more.
  const fail = (words: string): void => {
    over = words;
    for (const { failed } of waiting.values()) failed(new EngineError(words));
    waiting.clear();
  };
  const answered = ({ data }: MessageEvent<Said>): void => {
    if ('progress' in data) {
      reached.set(data.progress);
      return progress(data.progress);
    }
    reached.set(0);
    const asked = waiting.get(data.id);
    if (!asked) return;  // it was answered by the engine before this one
    waiting.delete(data.id);
    if (asked.question === 'seek') sought = [asked];
    if ('error' in data) asked.failed(new EngineError(data.error, data.problems));
    else asked.done(data.bytes.length ? { ...(data.answer as object), bytes: data.bytes } : data.answer);
  };
  const begin = (): Worker => {
    const worker = new Worker(URL.createObjectURL(new Blob([worker_code], { type: 'text/javascript' })));
    worker.onmessage = answered;
    worker.onerror = (event) => fail(event.message || 'the engine could not be started');
    worker.postMessage({ module });
    return worker;
  };
  let worker = begin();
  const put = ({ id, question, request, bytes }: Asked): void => worker.postMessage({ id, question, request, bytes });
  const end = (): void => {
    worker.terminate();
    fail('the engine was stopped');
  };
  const stop = (question: string): void => {
    const stopped = [...waiting.values()].filter((asked) => asked.question === question);
    if (!stopped.length) return;
    worker.terminate();
    worker = begin();
    reached.set(0);
    for (const { id, failed } of stopped) {
      waiting.delete(id);
      failed(new EngineError('it was stopped'));
    }
    for (const asked of new Set([...made, ...sought, ...waiting.values()])) put(asked);
  };
  const ask = (question: string) => (first?: object | Uint8Array) =>
    new Promise((done, failed) => {
      if (over) return failed(new EngineError(over));
      const with_bytes = first instanceof Uint8Array && { bytes: first };
      const asked: Asked = { id: ++last, question, request: with_bytes ? {} : (first ?? {}), ...with_bytes, done, failed };
      waiting.set(asked.id, asked);
      if (kBegins.includes(question)) made = made.filter((one) => one.question === 'take_zones');
      if (kMakes.includes(question)) made.push(asked);
      put(asked);
    });
  const known: Record<string, unknown> = { then: undefined, end, stop, reached };
  return new Proxy({} as RunningEngine, { get: (_, question: string) => (question in known ? known[question] : ask(question)) });
}
