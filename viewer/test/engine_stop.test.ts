// SPDX-License-Identifier: MIT
/** A long answer is stopped, and the engine is as it was for all others. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { start } from '../src/engine/engine.ts';
import type { Question, Said } from '../src/engine/worker.ts';

class FakeWorker {
  static all: FakeWorker[] = [];
  asked: Question[] = [];
  over = false;
  onmessage: (event: { data: Said }) => void = () => undefined;
  constructor() {
    FakeWorker.all.push(this);
  }
  postMessage(data: Question | { module: unknown }): void {
    if ('id' in data) this.asked.push(data);
  }
  terminate(): void {
    this.over = true;
  }
  questions(): string[] {
    return this.asked.map(({ question }) => question);
  }
  answer(question: string): void {
    const { id } = this.asked.find((one) => one.question === question)!;
    this.onmessage({ data: { id, answer: question, bytes: new Uint8Array(0) } });
  }
}

test('what is stopped is rejected, and a new worker is asked all else', async () => {
  Object.assign(globalThis, { Worker: FakeWorker });
  const engine = start({} as WebAssembly.Module, () => undefined);
  const [first] = FakeWorker.all as [FakeWorker];
  engine.stop('branch');
  assert.equal(FakeWorker.all.length, 1, 'nobody asked that');
  void engine.open(new Uint8Array([7]));
  void engine.page({});
  void engine.seek({ step: 5 });
  for (const question of ['open', 'page', 'seek']) first.answer(question);
  const branch = engine.branch({ player: 'eagle1', sets: [] });
  const outcome = engine.outcome();
  first.onmessage({ data: { progress: 12 } });
  assert.equal(engine.reached.get(), 12);
  engine.stop('branch');
  await assert.rejects(branch, /stopped/);
  const second = FakeWorker.all[1]!;
  assert.deepEqual([first.over, engine.reached.get(), second.questions()], [true, 0, ['open', 'page', 'seek', 'outcome']]);
  assert.deepEqual(second.asked[0]!.bytes, new Uint8Array([7]));
  second.answer('open');
  second.answer('outcome');
  assert.equal(await outcome, 'outcome');
});
