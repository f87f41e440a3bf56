// SPDX-License-Identifier: MIT
/** Moving in time: steps, jumps, zoom, and the clock. */
import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { run_clock, subscribe_paced } from '../src/clock.ts';
import {
  fight_of, jump, keep_in_sight, measure, pan_by, step_decision, step_leader, toggle_play, toggle_zoom, zoom_by, zoom_to,
} from '../src/ui/actions.ts';
import { link_pages } from '../src/ui/compare.tsx';
import { ticks_of } from '../src/ui/timeline.tsx';
import { clock_text, tick_text } from '../src/words/text.ts';
import type { Player } from '../src/run/run.ts';
import { View } from '../src/store.ts';
import { view_in } from '../src/ui/page.ts';
import { kBreaks, kPursues, kStory, page_of, told_run } from './ui_run.ts';

const kDecisions = Array.from({ length: 1000 }, (_, i) => (i >= 300 && i < 320 ? kBreaks : kPursues));
const kRun = told_run(kDecisions);
const near = (a: number, b: number): void => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test('a step goes from decision to decision, and back to the one that was passed', () => {
  const page = page_of(kRun, { time: 5.05, playing: true });
  step_decision(page, 1);
  near(page.store.get().time, 5.1);
  assert.equal(page.store.get().playing, false);
  step_decision(page, -1);
  near(page.store.get().time, 5);
  jump(page, 5.05);
  step_decision(page, -1);
  near(page.store.get().time, 5);
});

test('at the ends a step stays', () => {
  const page = page_of(kRun, { time: 0 });
  step_decision(page, -1);
  assert.equal(page.store.get().time, 0);
});

test('the next change of who leads', () => {
  const page = page_of(kRun, { time: 10 });
  step_leader(page, 1);
  near(page.store.get().time, 30);
  step_leader(page, 1);
  near(page.store.get().time, 32);
  step_leader(page, -1);
  near(page.store.get().time, 30);
});

test('what is jumped to comes into sight and stays in the run', () => {
  const page = page_of(kRun, { zoom: [10, 20] });
  jump(page, 15);
  assert.deepEqual(page.store.get().zoom, [10, 20]);
  jump(page, 50);
  assert.deepEqual(page.store.get().zoom, [45, 55]);
  jump(page, 1e6);
  assert.deepEqual([page.store.get().time, page.store.get().zoom], [100, [90, 100]]);
});

test('zoom keeps the time under the pointer, ends at the run and at two seconds', () => {
  const page = page_of(kRun);
  zoom_by(page, 0.5, 20);
  assert.deepEqual(page.store.get().zoom, [10, 60]);
  pan_by(page, -50);
  assert.deepEqual(page.store.get().zoom, [0, 50]);
  for (let i = 0; i < 20; ++i) zoom_by(page, 0.5, 10);
  const [from, to] = page.store.get().zoom!;
  near(to - from, 2);
  zoom_by(page, 1000, 10);
  assert.equal(page.store.get().zoom, null);
  zoom_to(page, 99, 120);
  assert.deepEqual(page.store.get().zoom, [79, 100]);
  toggle_zoom(page);
  assert.equal(page.store.get().zoom, null);
});

test('while it plays, the strips go along', () => {
  const page = page_of(kRun, { zoom: [10, 20], time: 19, playing: true });
  const stop = keep_in_sight(page);
  page.store.set({ time: 20 });
  assert.deepEqual(page.store.get().zoom, [10, 20]);
  page.store.set({ time: 20.5 });
  assert.deepEqual(page.store.get().zoom, [20, 30]);
  page.store.set({ time: 99.9 });
  assert.deepEqual(page.store.get().zoom, [90, 100]);
  page.store.set({ playing: false, zoom: [0, 5] });
  assert.deepEqual(page.store.get().zoom, [0, 5]);
  page.store.set({ playing: true, time: -0.01 });
  assert.deepEqual(page.store.get().zoom, [0, 5], 'there is nothing before the run');
  stop();
});

test('a second measurement of the same player takes the ruler away', () => {
  const page = page_of(kRun);
  measure(page, 1);
  assert.deepEqual(page.store.get().ruler, [0, 1]);
  measure(page, 1);
  assert.equal(page.store.get().ruler, null);
});

test('playing from the end begins at the beginning', () => {
  const page = page_of(kRun, { time: 100 });
  toggle_play(page);
  assert.deepEqual([page.store.get().playing, page.store.get().time], [true, 0]);
});

/** Time as a test says, instead of the machine's until the test is over. */
class Stopped {
  private time = 0;
  private last = 0;
  private readonly calls = new Map<number, { at: number; call: () => void }>();
  constructor(t: TestContext) {
    t.mock.method(performance, 'now', () => this.time);
    t.mock.method(globalThis, 'setTimeout', (call: () => void, wait: number) => {
      this.calls.set(++this.last, { at: this.time + wait, call });
      return this.last;
    });
    t.mock.method(globalThis, 'clearTimeout', (timer: number) => void this.calls.delete(timer));
  }
  pass(ms: number): void {
    this.time += ms;
    for (const [timer, { at, call }] of [...this.calls]) if (at <= this.time && this.calls.delete(timer)) call();
  }
}

test('the clock moves the time by what has passed times the rate, and stops at the end', (t) => {
  const frames: FrameRequestCallback[] = [];
  Object.assign(globalThis, { requestAnimationFrame: (f: FrameRequestCallback) => frames.push(f), cancelAnimationFrame: () => undefined });
  const { store } = page_of(kRun, { rate: 4, end: 0.6 });
  const watch = new Stopped(t);
  watch.pass(5000);
  const stop = run_clock(store);
  store.set({ playing: true });
  frames.pop()!(5100);
  near(store.get().time, 0.4);
  frames.pop()!(5200);
  assert.deepEqual([store.get().time, store.get().playing, frames.length], [0.6, false, 0]);
  stop();
});

test('a frame that began before the clock was started moves no time', (t) => {
  const frames: FrameRequestCallback[] = [];
  Object.assign(globalThis, { requestAnimationFrame: (f: FrameRequestCallback) => frames.push(f), cancelAnimationFrame: () => undefined });
  const { store } = page_of(kRun, { rate: 4 });
  const watch = new Stopped(t);
  watch.pass(5000);
  const stop = run_clock(store);
  store.set({ playing: true });
  frames.pop()!(4990);
  assert.equal(store.get().time, 0);
  frames.pop()!(5090);
  near(store.get().time, 0.4);
  stop();
});

test('panels are told at once of all but the time, and of the time at a pace', (t) => {
  const { store } = page_of(kRun, { playing: true });
  const watch = new Stopped(t);
  let told = 0;
  const stop = subscribe_paced(store, () => ++told);
  for (let i = 1; i <= 20; ++i) store.set({ time: i / 100 });
  assert.equal(told, 1);
  store.set({ selected: 1 });
  assert.equal(told, 2);
  store.set({ time: 0.5 });
  watch.pass(99);
  assert.equal(told, 2);
  watch.pass(1);
  assert.equal(told, 3);
  watch.pass(1000);
  assert.equal(told, 3, 'nothing is new');
  stop();
});

test('two runs show the same time, and players of the same name', () => {
  const other = { ...kRun, players: [{ ...kRun.players[1]!, index: 0 }, { ...kRun.players[0]!, index: 1 }] };
  const [a, b] = [page_of(kRun), page_of(other)];
  link_pages(a, b);
  a.store.set({ time: 7, selected: 1, ruler: [1, 0] });
  assert.deepEqual([b.store.get().time, b.store.get().selected, b.store.get().ruler], [7, 0, [0, 1]]);
  b.store.set({ time: 8, zoom: [1, 9] });
  assert.deepEqual([a.store.get().time, a.store.get().zoom, a.store.get().selected], [8, [1, 9], 1]);
});

test('another mission shows the same players by their names, and nothing of who is not there', () => {
  const [eagle, bogey] = kRun.players as [Player, Player];
  const view = { ...new View(), selected: 1, ruler: [1, 0] as [number, number], zoom: [1, 9] as [number, number], theme: 'dark' as const };
  const ghost = { player: 1, t: 3, heading: 1, altitude: null, speed: null, label: 'pursue' };
  assert.deepEqual(view_in(kRun, kRun, { ...view, ghost }), { ...view, ghost });
  const turned = { ...kRun, players: [{ ...bogey, index: 0 }, { ...eagle, index: 1 }] };
  assert.deepEqual(view_in(turned, kRun, { ...view, ghost }), { ...view, selected: 0, ruler: [0, 1], ghost: { ...ghost, player: 0 }, zoom: null });
  const fewer = { ...kRun, players: [eagle] };
  assert.deepEqual(view_in(fewer, kRun, { ...view, ghost }), { ...view, selected: 0, ruler: null, ghost: null, zoom: null });
});

test('times are written as the terminal writes them', () => {
  assert.equal(clock_text(348.18), '05:48.2');
  assert.equal(clock_text(59.96), '01:00.0');
  assert.equal(tick_text(348, 2), '5:48');
  assert.equal(tick_text(0.5, 0.5), '0:00.5');
});

test('a fight begins a minute before the first shot, not at a loss before it, and ends after the last loss', () => {
  const told = (...lines: [number, string][]) => page_of(told_run(kDecisions, lines.map(([t, kind]) => ({ ...kStory[0]!, t, kind }))));
  assert.deepEqual(fight_of(told([5, 'loss'], [120, 'launch'], [150, 'gun_burst'], [170, 'loss'])), [60, 230]);
  assert.deepEqual(fight_of(told([5, 'loss'], [150, 'gun_burst'], [170, 'loss'])), [90, 230], 'of guns alone');
  assert.equal(fight_of(told([5, 'loss'])), null);
});

test('labels of an axis have room, in a run of any length', () => {
  for (const [hours, wanted] of [[1, 300], [30, 10_800], [277, 86_400], [2770, 16 * 86_400]] as const) {
    const { step, ticks } = ticks_of(0, hours * 3600, 800, 12);
    assert.deepEqual([step, ticks.at(-1)! + step > hours * 3600], [wanted, true], `${hours} h`);
  }

  const { step, ticks } = ticks_of(10, 70, 600, 12);
  assert.equal(step, 10);
  assert.deepEqual(ticks, [10, 20, 30, 40, 50, 60, 70]);
});
