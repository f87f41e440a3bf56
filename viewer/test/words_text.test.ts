// SPDX-License-Identifier: MIT
/** Values in words, as the terminal writes them. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import type { Run } from '../src/run/run.ts';
import { climb_words } from '../src/scene/frame.ts';
import { fixed, general, outcome_text, read_clock, read_vote, reworded, side_text, value_text, type FieldInfo, speak } from '../src/words/text.ts';

const kRun = { texts: ['hold', 'follow'] } as unknown as Run;

function text(field: Partial<FieldInfo>, value: number): string {
  return value_text(kRun, { unit: '', form: 'quantity', kind: 'number', ...field }, value);
}

test('decimals round halves to even', () => {
  assert.deepEqual([0.5, 1.5, 2.5, -2.5, 0.4999].map((x) => fixed(x, 0)), ['0', '2', '2', '-2', '0']);
  assert.deepEqual([0.25, 0.75, 0.35, 1e3 + 0.125].map((x) => fixed(x, 1)), ['0.2', '0.8', '0.3', '1000.1']);
  assert.equal(fixed(1000.125, 2), '1000.12');
});

test('general numbers have six digits, or as many as asked for', () => {
  assert.deepEqual([0, 40, 70.0999984741211, 0.0001, 0.00001, 1e6, 123456.5, 999999.5, -1234567].map((x) => general(x)),
    ['0', '40', '70.1', '0.0001', '1e-05', '1e+06', '123456', '1e+06', '-1.23457e+06']);
  assert.deepEqual([6.666, 0.05, 12.34, 99.96].map((x) => general(x, 3)), ['6.67', '0.05', '12.3', '100']);
  assert.deepEqual([NaN, Infinity, -Infinity].map((x) => general(x)), ['nan', 'inf', '-inf']);
});

test('quantities read as in the terminal, in either system', () => {
  const lines = readFileSync(join(process.env['EYRIE_VIEWER_FOLDER']!, '../tests/quantities.txt'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  assert.ok(lines.length > 20);
  for (const line of lines) {
    const [, kind, si, aviation, metric] = /^(\S+) +(\S+) +\| (.*?) +\| (.*)$/.exec(line)!;
    const field: Partial<FieldInfo> = kind === 'height' || kind === 'climb' || kind === 'direction' ? { form: kind } : { unit: kind === '1' ? '' : kind! };
    const said = () => (kind === 'side' ? side_text(Number(si)) : text(field, Number(si)));
    speak('metric');
    assert.equal(said(), metric, line);
    speak('aviation');
    assert.equal(said(), aviation, line);
  }
});

test('and the words of engine and files do', () => {
  assert.equal(reworded('splash bogey1, 14.2 nmi, 305 m behind, at 7.4 km'), 'splash bogey1, 14.2 nmi, 1001 ft behind, at 4.0 nmi');
  assert.equal(reworded('off_nose < 60 deg and turn > 3 deg/s and 7 miles, 3 min'), 'off_nose < 60° and turn > 3.0°/s and 7 miles, 3 min');
  assert.equal(reworded('[200 m/s, 19.6133 m/s2], 0.7 rad'), '[389 kt, 2.0 g], 40°');
  speak('metric');
  assert.equal(reworded('fox 3 on bogey1, 10.0 nmi (AIM-120), 305 m'), 'fox 3 on bogey1, 18.5 km (AIM-120), 305 m');
  assert.equal(reworded('closing > 100 kt and fuel < 2000 lb'), 'closing > 185 km/h and fuel < 907 kg');
  speak('aviation');
});

test('a time can be typed, and what is none is told', () => {
  assert.deepEqual(['8:20.5', '08:20', '500.5', ' 12 s', '16:40'].map((text) => read_clock(text, 1000)), [500.5, 500, 500.5, 12, 1000]);
  for (const text of ['soon', '1:2:3', '-5', '8:20,5', '']) assert.match(String(read_clock(text, 1000)), /not a time such as/, text);
  assert.equal(read_clock('8:75', 1000), 'a minute has 60 seconds');
  assert.equal(read_clock('99:59', 1000), 'it ends at 16:40.0');
});

test('a vote is what files take for one, and what is none is told', () => {
  assert.deepEqual(['70', ' 12.5 ', '.5', '1e2', '0', '+3', '1000'].map(read_vote), [70, 12.5, 0.5, 100, 0, 3, 1000]);
  for (const text of ['Infinity', '1e999', '0x10', 'abc', '-3', '12,5', '1001', '', '5 nmi']) assert.match(String(read_vote(text)), /is no vote/, text);
});

test('a height above another is in hundreds, and none has no sign', () => {
  assert.deepEqual([0.75, -0.75, 0.01, -0.01, 0].map(climb_words), ['+2500 ft', '-2500 ft', '0 ft', '0 ft', '0 ft']);
});

test('why a mission was over is in words', () => {
  assert.deepEqual(['blue_home', 'time', 'running'].map(outcome_text), ['blue home', 'time is up', 'running']);
});

test('what is not a number is in words', () => {
  assert.equal(text({ form: 'direction' }, NaN), '-');
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'text' }, x)), ['hold', 'follow', '-']);
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'flag' }, x)), ['false', 'true', '-']);
  assert.deepEqual([0, 3, NaN].map((x) => text({ kind: 'id' }, x)), ['nobody', '#3', '-']);
  // of the state
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'flag', choices: [] }, x)), ['no', 'yes', 'no']);
  assert.deepEqual([1, NaN].map((x) => text({ kind: 'choice', choices: ['a', 'b'] }, x)), ['b', '-']);
});
