// SPDX-License-Identifier: MIT
/** The engine as a WebAssembly module: one instance, asked in this thread. */
import type { Problem } from './questions.ts';

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  request(size: number): number;
  bytes(size: number): number;
  ask(): number;
  answer(): number;
  bytes_at(): number;
  bytes_size(): number;
}

/** Why a question was not answered; `problems` are mistakes in texts. */
export class EngineError extends Error {
  constructor(message: string, readonly problems: Problem[] = []) {
    super(message);
  }
}

/** What went wrong, for people. */
export function words_of(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** What a C++ library asks of its system, which has no files: nothing of that is open. */
const kBadFile = 8;  // wasi's EBADF
const kSystem = { fd_close: () => kBadFile, fd_seek: () => kBadFile, fd_write: () => kBadFile };

export class Instance {
  private constructor(private readonly engine: Exports) {}

  static async of(module: WebAssembly.Module, progress: (time: number) => void): Promise<Instance> {
    const imports = { wasi_snapshot_preview1: kSystem, eyrie: { progress } };
    const engine = (await WebAssembly.instantiate(module, imports)).exports as unknown as Exports;
    if (!engine.ask || !engine.bytes_at) throw new EngineError('the engine in this page is of another Eyrie than the page');
    engine._initialize();
    return new Instance(engine);
  }

  /** Asks one question; `bytes` go with it, and those of the answer are copied out. Throws EngineError. */
  ask(question: string, request: object = {}, bytes?: Uint8Array): { answer: unknown; bytes: Uint8Array } {
    const { engine } = this;
    const put = (data: Uint8Array, at: number) => new Uint8Array(engine.memory.buffer, at, data.length).set(data);
    const text = new TextEncoder().encode(JSON.stringify({ ...request, ask: question }));
    put(text, engine.request(text.length));
    if (bytes) put(bytes, engine.bytes(bytes.length));
    const size = engine.ask();
    const out = (at: number, length: number) => new Uint8Array(engine.memory.buffer, at, length);
    const answer = JSON.parse(new TextDecoder().decode(out(engine.answer(), size))) as { error?: string; problems?: Problem[] };
    if (answer.error !== undefined) throw new EngineError(answer.error, answer.problems);
    return { answer, bytes: out(engine.bytes_at(), engine.bytes_size()).slice() };
  }
}
