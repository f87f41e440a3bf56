// SPDX-License-Identifier: MIT
/** What the page does with what the program sends: steps, orders and hashes in their order, a broken line, and the time that is shown. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Advance } from '../src/engine/questions.ts';
import { Line, type Ear, type Socket } from '../src/live/line.ts';
import { Lockstep, merged, type Reached } from '../src/live/lockstep.ts';
import { next_shown } from '../src/live/live.ts';

test('grants up to the first with a hash are one', () => {
  const { grant, left } = merged([
    { step: 1, outcome: 'running', orders: ['a'] }, { step: 2, outcome: 'running', orders: ['b'], hash: '0x2' }, { step: 3, outcome: 'time' },
  ]);
  assert.deepEqual(grant, { step: 2, outcome: 'running', orders: ['a', 'b'], hash: '0x2' });
  assert.equal(left.length, 1);
});

/** An engine that knows the hash of each step, and how long its answers take. */
function fake_engine(ms_per_step: number) {
  const asked: Advance[] = [];
  let clock = 0;
  let here = 0;
  return {
    asked,
    now: () => clock,
    async advance(request: Advance) {
      asked.push(request);
      clock += (request.step - here) * ms_per_step;
      here = request.step;
      const hash = `0x${here}`;
      return { moment: { step: here, time: here / 50, hash }, agrees: request.hash === '' || request.hash === hash, bytes: new Uint8Array(request.draw ? 1 : 0) };
    },
  };
}
const fail = (why: unknown): never => assert.fail(String(why));
const settled = () => new Promise<void>((done) => setTimeout(done, 5));

test('gives every order once, and compares each hash at its step', async () => {
  const engine = fake_engine(0);
  const news: Reached[] = [];
  const lockstep = new Lockstep(engine, (reached) => news.push(reached), fail, engine.now);
  lockstep.grant({ step: 10, outcome: 'running', orders: ['one'] });
  lockstep.grant({ step: 20, outcome: 'running', orders: ['two'], hash: '0x20' });
  lockstep.grant({ step: 30, outcome: 'running', orders: ['three'] });
  lockstep.grant({ step: 40, outcome: 'time', hash: '0xbad' });
  await settled();
  assert.deepEqual(engine.asked.flatMap(({ orders }) => orders), ['one', 'two', 'three']);
  assert.deepEqual(news.filter(({ checked }) => checked).map(({ step, agrees, there }) => [step, agrees, there]), [[20, true, '0x20'], [40, false, '0xbad']]);
  assert.equal(engine.asked.at(-1)!.outcome, 'time');
});

test('flies what is much in answers that leave room for questions', async () => {
  const engine = fake_engine(2);
  const news: Reached[] = [];
  const lockstep = new Lockstep(engine, (reached) => news.push(reached), fail, engine.now);
  lockstep.grant({ step: 5000, outcome: 'running', orders: ['one'], hash: '0x5000' });
  await settled();
  assert.ok(news.length > 20, String(news.length));
  assert.deepEqual(engine.asked.flatMap(({ orders }) => orders), ['one']);
  assert.deepEqual(engine.asked.map(({ hash }) => hash).filter(Boolean), ['0x5000']);
  assert.equal(news.at(-1)!.step, 5000);
  assert.ok(news.at(-1)!.drawn);
});

test('says once why it cannot go on', async () => {
  const failures: unknown[] = [];
  const lockstep = new Lockstep({ advance: () => Promise.reject(new Error('no')) }, fail, (error) => failures.push(error), () => 0);
  lockstep.grant({ step: 1, outcome: 'running' });
  lockstep.grant({ step: 2, outcome: 'running' });
  await settled();
  lockstep.grant({ step: 3, outcome: 'running' });
  await settled();
  assert.equal(failures.length, 1);
});

test('takes up a line that breaks, and then hears the run so far again', async () => {
  const settled = (ms: number) => new Promise<void>((done) => setTimeout(done, ms));
  const sockets: Socket[] = [];
  const heard: string[] = [];
  const ear: Ear = {
    joined: (file) => heard.push(`joined ${file.length}`), news: ({ step }) => heard.push(`step ${step}`), pacing: ({ missed }) => heard.push(`missed ${missed}`),
    refused: (words) => heard.push(words), broken: (words) => heard.push(`broken: ${words}`),
  };
  const line = new Line(() => {
    sockets.push({ binaryType: '', readyState: 1, onmessage: null, onclose: null, send: (text) => heard.push(text), close: () => {} });
    return sockets.at(-1)!;
  }, ear, { first: 1, last: 2, silence: 100 });
  const say = (data: unknown) => sockets.at(-1)!.onmessage!({ data });
  say(new ArrayBuffer(3));
  say('{"step": 7, "rate": 1, "paused": false, "viewers": 1, "outcome": "running"}');
  say('{"pacing": {"missed": 2}}');
  say('{"refused": "no"}');
  assert.equal(line.say({ do: 'pause' }), true);
  sockets[0]!.onclose!({ reason: 'too slow' });
  assert.equal(line.say({ do: 'play' }), false);
  await settled(20);
  assert.equal(sockets.length, 2);
  sockets[0]!.onmessage!({ data: '{"step": 8}' });  // of the old one nothing is heard
  say(new ArrayBuffer(4));
  assert.deepEqual(heard, ['joined 3', 'step 7', 'missed 2', 'no', '{"do":"pause"}', 'broken: too slow', 'joined 4']);
  await settled(200);
  line.end();
  assert.ok(heard.includes('broken: nothing is heard'));
});

test('the time that is shown goes smoothly, and is at most a tenth of a second late', () => {
  for (const rate of [0.1, 1, 20]) {
    let [shown, flown, late] = [0, 0, 0];
    const steps: number[] = [];
    for (let frame = 0; frame < 600; ++frame) {
      if (frame % 3 === 0) flown += 0.05 * rate;  // 20 grants a second, 60 pictures
      const next = next_shown(shown, flown, rate, 1 / 60);
      if (frame > 120) {
        steps.push((next - shown) / rate);
        late = Math.max(late, (flown - next) / rate);
      }
      assert.ok(next <= flown && next >= shown);
      shown = next;
    }
    assert.ok(late < 0.1, `${late} s late at ${rate}`);
    assert.ok(Math.max(...steps) - Math.min(...steps) < 0.006, 'no picture leaps');
  }
  assert.equal(next_shown(3, 50, 1, 1 / 60), 50);
  assert.equal(next_shown(3, 50, Infinity, 1 / 60), 50);
});
