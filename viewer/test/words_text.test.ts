// SPDX-License-Identifier: MIT
/** Values in words, as the terminal writes them. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Run } from '../src/run/run.ts';
import { speak } from '../src/words/units.ts';
import { fixed, general, read_clock, reworded, value_text, type FieldInfo } from '../src/words/text.ts';

const kRun = { texts: ['hold', 'follow'] } as unknown as Run;

function text(field: Partial<FieldInfo>, value: number): string {
  return value_text(kRun, { name: 'x', unit: '', kind: 'number', ...field }, value);
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

test('quantities are in the units of aviation', () => {
  assert.equal(text({ name: 'heading', unit: 'rad' }, Math.PI / 4), '045°');
  assert.equal(text({ name: 'altitude', unit: 'm' }, 1828.8), '6000 ft');
  assert.equal(text({ name: 'altitude', unit: 'm' }, 9753.6), '32000 ft');
  assert.equal(text({ name: 'height above', unit: 'm' }, 3048), '10000 ft');
  assert.equal(text({ name: 'range', unit: 'm' }, 300), '984 ft');
  assert.equal(text({ name: 'range', unit: 'm' }, 18520), '10.0 nmi');
  assert.equal(text({ name: 'speed', unit: 'm/s' }, 240), '467 kt');
  assert.equal(text({ name: 'turn', unit: 'rad/s' }, Math.PI / 60), '3.0°/s');
  assert.equal(text({ name: 'fuel', unit: 'kg' }, 1000), '2205 lb');
  assert.equal(text({ name: 'time', unit: 's' }, 1234.5), '1234 s');
  assert.equal(text({ name: 'time', unit: 's' }, 12.345), '12.3 s');
  assert.equal(text({ name: 'load_factor' }, 5.285), '5.29');
  assert.equal(text({ name: 'off_nose', unit: 'rad' }, -0.001), '0°');
  assert.deepEqual([-0.001, -Math.PI / 2, 7].map((x) => text({ name: 'heading', unit: 'rad' }, x)), ['000°', '270°', '041°']);
  assert.equal(text({ name: 'crossing', unit: 'rad' }, -Math.PI / 2), '-90°');
  assert.equal(text({ name: 'temperature', unit: 'K' }, 288.15), '15°C');
});

test('or metric, in the words of the engine too', () => {
  assert.equal(reworded('splash bogey1, 14.2 nmi, 305 m behind, at 7.4 km'), 'splash bogey1, 14.2 nmi, 1001 ft behind, at 4.0 nmi');
  speak('metric');
  assert.equal(text({ name: 'altitude', unit: 'm' }, 9753.6), '9754 m');
  assert.equal(text({ name: 'range', unit: 'm' }, 18520), '18.5 km');
  assert.equal(text({ name: 'speed', unit: 'm/s' }, 100), '360 km/h');
  assert.equal(reworded('fox 3 on bogey1, 10.0 nmi (AIM-120), 305 m'), 'fox 3 on bogey1, 18.5 km (AIM-120), 305 m');
  speak('aviation');
});

test('a time can be typed', () => {
  assert.deepEqual(['8:20.5', '08:20', '500.5', ' 12 s', '1:75', 'soon', ''].map(read_clock), [500.5, 500, 500.5, 12, 135, null, null]);
});

test('what is not a number is in words', () => {
  assert.equal(text({ name: 'heading', unit: 'rad' }, NaN), '-');
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'text' }, x)), ['hold', 'follow', '-']);
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'flag' }, x)), ['false', 'true', '-']);
  assert.deepEqual([0, 3, NaN].map((x) => text({ kind: 'id' }, x)), ['nobody', '#3', '-']);
  // of the state
  assert.deepEqual([0, 1, NaN].map((x) => text({ kind: 'flag', choices: [] }, x)), ['no', 'yes', 'no']);
  assert.deepEqual([1, NaN].map((x) => text({ kind: 'choice', choices: ['a', 'b'] }, x)), ['b', '-']);
});
