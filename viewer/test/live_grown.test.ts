// SPDX-License-Identifier: MIT
/** A run that grows is, in the end, the run that is flown at once. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { from_ascii85 } from '../ascii85.mjs';
import { Instance } from '../src/engine/module.ts';
import type { Advanced, Followed, Moment } from '../src/engine/questions.ts';
import { GrownRun } from '../src/live/grown.ts';
import { decode } from '../src/run/decode.ts';
import type { Player, Run } from '../src/run/run.ts';
import { kNoPage, kPageFile } from './page_kit.ts';

/** What a page carries. */
function part(type: string): Uint8Array<ArrayBuffer> {
  const found = new RegExp(`<script type="application/x-eyrie-${type}">([^<]*)</script>`).exec(readFileSync(kPageFile, 'utf8'))!;
  return new Uint8Array(inflateSync(from_ascii85(found[1]!)));
}

function same(name: string, a: Float64Array | Int32Array, b: Float64Array | Int32Array): void {
  assert.deepEqual(Array.from(a), Array.from(b), name);
}

function compare_player(run: Run, a: Player, b: Player): void {
  for (const key of Object.keys(b.motion) as (keyof Player['motion'])[]) same(`${b.name} ${key}`, a.motion[key], b.motion[key]);
  for (const key of Object.keys(b.gauges) as (keyof Player['gauges'])[]) same(`${b.name} ${key}`, a.gauges[key], b.gauges[key]);
  same(`${b.name} step`, a.decisions.step, b.decisions.step);
  same(`${b.name} shape`, a.decisions.shape, b.decisions.shape);
  for (let node = 0; node < 40; ++node)
    for (let field = 0; field < run.platforms[b.kind].action.length; ++field) {
      const [mine, its] = [a.decisions.value(node, field), b.decisions.value(node, field)];
      assert.equal(mine === null, its === null);
      if (mine && its) same(`${b.name} ${node}/${field}`, mine, its);
    }
  same(`${b.name} sights`, a.sights.t, b.sights.t);
  for (let i = 0; i < b.sights.t.length; i += 37) assert.deepEqual(a.sights.at(i), b.sights.at(i));
  assert.deepEqual([a.born, a.end, a.type, a.radar], [b.born, b.end, b.type, b.radar]);
}

test('a run that grows is in the end the run that is flown at once', { skip: kNoPage }, async () => {
  const module = await WebAssembly.compile(part('engine'));
  const engine = async () => {
    const instance = await Instance.of(module, () => {});
    instance.ask('take_zones', {}, part('zones'));
    return instance;
  };
  const file = part('run-file');
  const once = await engine();
  once.ask('open', {}, file);
  const { answer, bytes } = once.ask('page', {});
  const whole = decode(bytes);

  const along = await engine();
  const { flown } = along.ask('follow', {}, file).answer as Followed;
  assert.equal(flown.step, (answer as Moment).step);
  let grown: GrownRun | null = null;
  let first: Player | null = null;
  const advance = (step: number, hash = ''): Advanced => {
    const said = along.ask('advance', { step, orders: [], hash, outcome: 'running', draw: true });
    if (grown) grown.add(said.bytes);
    else grown = new GrownRun(said.bytes, undefined);
    return said.answer as Advanced;
  };
  for (let step = 0; step < flown.step; step += 389) {
    advance(step);
    const run: Run = grown!.run;
    assert.equal(run.about.duration, step * run.about.dt);
    // everybody who is there is known up to now
    for (const { motion, gauges, end } of run.players)
      if (!end) assert.deepEqual([Math.round(motion.t.at(-1)! / run.about.dt), gauges.speed.length], [step, motion.t.length]);
    first ??= run.players[0]!;
  }
  assert.equal(advance(flown.step, '0x0').agrees, false);
  assert.equal(advance(flown.step, flown.hash).agrees, true);
  assert.equal(first!.motion.t.length, 1, 'what was read before stays as it was');

  const { run } = grown!;
  assert.deepEqual(run.trees, whole.trees);
  assert.deepEqual(run.texts, whole.texts);
  assert.deepEqual(run.story, whole.story);
  assert.deepEqual(run.shapes, whole.shapes);
  whole.players.forEach((player, i) => compare_player(run, run.players[i]!, player));
  assert.equal(run.missiles.length, whole.missiles.length);
  for (const its of whole.missiles) {
    const mine = run.missiles.find(({ id }) => id === its.id)!;
    same(`missile ${its.id}`, mine.motion.east, its.motion.east);
    assert.deepEqual([mine.type, mine.end, mine.active], [its.type, its.end, its.active]);
  }
});
