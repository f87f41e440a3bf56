// SPDX-License-Identifier: MIT
/** The arbiters that check proposals and that choose among candidates: docs/ubf.md. */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { decider_of, kDone, type Moment, type Params, type Proposal } from '../src/decide/arbitrate.ts';
import { make_proposal } from '../src/decide/proposal.ts';
import type { ConditionStep } from '../src/run/run.ts';
import { kFields, kNever, proposal, type FieldName, type Said } from './decide_run.ts';

const kNode = 9;

function decide(type: string, said: Said[], params: Params, moment: Moment = kNever): Proposal {
  const out = make_proposal(kFields.length);
  const decider = decider_of(type, params, kFields, kNode, said.map((_, i) => i));
  assert.ok(decider, `${type} cannot be with ${JSON.stringify(params)}`);
  assert.equal(decider(said.map((s, i) => proposal(s, i)), out, moment), kDone);
  return out;
}
function field(name: FieldName): number {
  return kFields.findIndex((f) => f.name === name);
}
function value(out: Proposal, name: FieldName): number {
  return out.action[field(name)]!;
}
function rad(x: number): number {
  return (x * Math.PI) / 180;
}
function near(a: number, b: number): void {
  assert.ok(Math.abs(a - b) < 1e-4, `${a} is not ${b}`);
}

describe('verify', () => {
  const said: Said[] = [{ vote: 10, altitude: 3000 }, { vote: 60, altitude: 200 }, { vote: 40, altitude: 1000 }];
  const floor = { 'bounds.altitude.min': 1000 };
  test('takes the highest vote of those that pass, ends included', () => {
    assert.equal(decide('verify', said, floor).leader, 2);
    assert.equal(decide('verify', said, { 'bounds.altitude.min': 1001 }).leader, 0);
    assert.equal(decide('verify', said, { 'bounds.altitude.max': 200 }).leader, 1);
    assert.equal(decide('verify', said, { 'bounds.altitude.min': 5000 }).status, 'failure');
  });
  test('lets pass what is not set', () => assert.equal(decide('verify', [{ vote: 5, speed: 200 }], floor).leader, 0));
  test('does not see the rounding of the page, and sees more', () => {
    assert.equal(decide('verify', [{ vote: 5, altitude: 999.9996 }], floor).leader, 0);
    assert.equal(decide('verify', [{ vote: 5, altitude: 999.999 }], floor).leader, -1);
    const north = { 'bounds.heading.min': rad(350), 'bounds.heading.max': rad(10) };
    const leads = (heading: number): boolean => decide('verify', [{ vote: 5, heading }], north).leader === 0;
    assert.deepEqual([350, 0, 10, 355].map((x) => leads(rad(x))), [true, true, true, true]);
    assert.deepEqual([leads(rad(350) - 4e-7), leads(rad(350) - 2e-6), leads(rad(10) + 4e-7), leads(rad(10) + 2e-6)], [true, false, true, false]);
    assert.deepEqual([leads(rad(180)), leads(rad(349)), leads(rad(11))], [false, false, false]);
  });
  test('asks the fallback, unchecked, only if nobody else passes', () => {
    const last: Said = { vote: 1, altitude: 100 };
    assert.equal(decide('verify', [...said, last], { ...floor, fallback: 'true' }).leader, 2);
    assert.equal(decide('verify', [said[1]!, last], { ...floor, fallback: 'true' }).leader, 1);
    assert.equal(decide('verify', [said[1]!, { ...last, status: 'failure' }], { ...floor, fallback: 'true' }).leader, -1);
    assert.equal(decide('verify', [said[1]!, last], { ...floor, fallback: 'false' }).leader, -1);
  });

  const kFuel = 4;
  const step = (op: ConditionStep['op'], more: Partial<ConditionStep> = {}): ConditionStep =>
    ({ op, left: 0, right: 0, target: 0, within: 0, ...more });
  const with_fuel = (fuel: number): Moment => ({ t: 0, state: (f) => (f === kFuel ? fuel : NaN) });
  const refuses = (steps: ConditionStep[], one: Said, fuel = NaN): boolean =>
    decide('verify', [one], { refuse: [{ that: 'a test', steps }] }, with_fuel(fuel)).leader < 0;
  test('refuses by conditions on the state and on the proposal', () => {
    // action.speed > 250 and fuel < 1000
    const fast_and_light = [
      step('>', { left: { action: field('speed') }, right: 250 }), step('and', { target: 3 }), step('<', { left: { state: kFuel }, right: 1000 }),
    ];
    assert.equal(refuses(fast_and_light, { vote: 5, speed: 260 }, 900), true);
    assert.equal(refuses(fast_and_light, { vote: 5, speed: 260 }, 1000), false);
    assert.equal(refuses(fast_and_light, { vote: 5, speed: 240 }, 900), false);
    assert.equal(refuses(fast_and_light, { vote: 5 }, 900), false);
    assert.equal(refuses([...fast_and_light, step('not')], { vote: 5 }, 900), true);
    assert.equal(refuses(fast_and_light.map((s, i) => (i === 1 ? step('or', { target: 3 }) : s)), { vote: 5 }, 900), true);
  });
  test('compares nothing with what has no value, and what is rounded by its rounding', () => {
    for (const op of ['<', '<=', '>', '>=', '==', '!='] as const)
      assert.equal(refuses([step(op, { left: { state: kFuel }, right: 1 })], { vote: 5 }), false, op);
    const at = (op: ConditionStep['op'], fuel: number) => refuses([step(op, { left: { state: kFuel }, right: 1, within: 5e-5 })], { vote: 5 }, fuel);
    assert.deepEqual((['<', '<=', '>', '>=', '==', '!='] as const).map((op) => at(op, 1.00004)), [false, true, false, true, true, false]);
    assert.deepEqual((['<', '<=', '>', '>=', '==', '!='] as const).map((op) => at(op, 1.0002)), [false, false, true, true, false, true]);
  });
  test('knows flags, and of what is no number whether it is set', () => {
    const flag = (name: FieldName) => [step('flag', { left: { action: field(name) } })];
    assert.deepEqual([refuses(flag('trigger'), { vote: 5, trigger: 1 }), refuses(flag('trigger'), { vote: 5, trigger: 0 })], [true, false]);
    assert.deepEqual([refuses(flag('target'), { vote: 5, target: 0 }), refuses(flag('mode'), { vote: 5 })], [true, false]);
  });
  test('cannot be without anything to check', () => {
    const cannot: Params[] = [{}, { fallback: 'true', ...floor }, { 'bounds.altitude.min': 2, 'bounds.altitude.max': 1 }, { 'bounds.heading.min': 1 }];
    for (const params of cannot) assert.equal(decider_of('verify', params, kFields, kNode, [0]), null, JSON.stringify(params));
  });
});

describe('vote_grid and utility', () => {
  const compass: Params = { 'grid.heading.from': 0, 'grid.heading.to': 2 * Math.PI, 'grid.heading.steps': 36, 'grid.heading.reach': rad(60) };
  const heading = (said: Said[], params = compass, type = 'vote_grid'): number => (value(decide(type, said, params), 'heading') * 180) / Math.PI;
  test('take what many can live with, the first of equals', () => {
    near(heading([{ vote: 3, heading: rad(357) }]), 0);
    near(heading([{ vote: 4, heading: 0 }, { vote: 3, heading: rad(40) }, { vote: 3, heading: rad(50) }]), 40);
    for (let off = 0.1; off < 10; off += 0.1)
      near(heading([{ vote: 3.3, heading: rad(70 + off) }, { vote: 3.3, heading: rad(120 + off) }]), 80);
  });
  test('do not choose by the rounding of the page', () => {
    const between = [...Array(36).keys()].map((i) => rad(10 * i + 5));
    for (const exact of between.slice(0, 35)) {
      const rounded = Math.round(exact / 1e-6) * 1e-6;
      near(heading([{ vote: 40, heading: rounded }]), (exact * 180) / Math.PI - 5);
    }
  });
  test('make a choice of their own, and take other fields from the strongest', () => {
    const out = decide('vote_grid', [{ vote: 5, heading: 1, target: 7 }, { status: 'success', vote: 9, speed: 200 }], compass);
    assert.deepEqual([out.status, out.vote, out.leader, out.supplier[field('heading')]], ['success', 9, kNode, kNode]);
    assert.deepEqual([value(out, 'speed'), value(out, 'target'), out.supplier[field('target')]], [200, 7, 0]);
    const silent = decide('vote_grid', [{ vote: 5, speed: 200 }], compass);
    assert.deepEqual([silent.leader, value(silent, 'heading')], [0, NaN]);
    assert.equal(decide('vote_grid', [{ status: 'failure' }, { vote: 0, heading: 1 }], compass).status, 'failure');
  });
  test('weigh what comes of a command', () => {
    const line: Params = { 'grid.altitude.from': 0, 'grid.altitude.to': 1000, 'grid.altitude.steps': 11, 'grid.altitude.reach': 200 };
    const said: Said[] = [{ vote: 10, altitude: 300 }, ...[700, 750, 800].map((altitude) => ({ vote: 3.9, altitude }))];
    const altitude = (spread: number) => value(decide('utility', said, { ...line, 'grid.altitude.spread': spread }), 'altitude');
    assert.equal(altitude(0), value(decide('vote_grid', said, line), 'altitude'));
    assert.deepEqual([altitude(0), altitude(150)], [300, 700]);
  });
  test('cannot be over what is no grid', () => {
    const cannot: Params[] = [{}, { ...compass, 'grid.heading.steps': 1 }, { ...compass, 'grid.heading.reach': 0 }, { ...compass, 'grid.heading.to': 7 },
      { ...compass, 'grid.heading.steps': 2.5 }, { ...compass, 'grid.heading.spread': 0.5 }, { 'grid.mode.from': 0, 'grid.mode.to': 1, 'grid.mode.steps': 2, 'grid.mode.reach': 1 }];
    for (const params of cannot) assert.equal(decider_of('vote_grid', params, kFields, kNode, [0]), null, JSON.stringify(params));
  });
});
