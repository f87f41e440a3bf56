// SPDX-License-Identifier: MIT
/** The engine in a thread of its own: answers one question after the other. */
import { EngineError, Instance, words_of } from './module.ts';

export interface Question { id: number; question: string; request: object; bytes?: Uint8Array }
export type Said =
  | { progress: number }
  | { id: number; answer: unknown; bytes: Uint8Array }
  | { id: number; error: string; problems: EngineError['problems'] };

const say = (said: Said, transfer: Transferable[] = []): void => (self as unknown as Worker).postMessage(said, transfer);
let instance: Promise<Instance>;

self.onmessage = async ({ data }: MessageEvent<{ module: WebAssembly.Module } | Question>) => {
  if ('module' in data) {
    instance = Instance.of(data.module, (progress) => say({ progress }));
    return;
  }
  const { id, question, request, bytes } = data;
  try {
    const answered = (await instance).ask(question, request, bytes);
    say({ id, ...answered }, [answered.bytes.buffer]);
  } catch (error) {
    say({ id, error: words_of(error), problems: error instanceof EngineError ? error.problems : [] });
  }
};
