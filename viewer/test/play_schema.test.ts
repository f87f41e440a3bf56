// SPDX-License-Identifier: MIT
/** Where a cursor is in a scenario, and what may stand there. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Grammar, place_of, type Schema } from '../src/play/schema.ts';

/** The place of the bar. */
const place = (text: string) => {
  const { path, at, said } = place_of(text.slice(0, text.indexOf('|')));
  return [path.join('.'), at, said];
};

test('a key is found by its column', () => {
  assert.deepEqual(place('|'), ['', 'key', '']);
  assert.deepEqual(place('eyrie: 1\nna|'), ['', 'key', 'na']);
  assert.deepEqual(place('blue:\n  flights:\n    eagle:\n      tree: sweep\n      bi|'), ['blue.flights.eagle', 'key', 'bi']);
  assert.deepEqual(place('blue:\n  flights:\n    eagle:\n      tree: sweep\n    |'), ['blue.flights', 'key', '']);
  assert.deepEqual(place('blue:\n  home: {}\nred:\n  ho|'), ['red', 'key', 'ho']);
  assert.deepEqual(place('trees:\n|'), ['', 'key', '']);
  assert.deepEqual(place('trees:\n  mean:\n  |'), ['trees', 'key', '']);
  assert.deepEqual(place('eagle:\n  route:\n    - {north: 1 nmi}\n    |'), ['eagle.route', 'key', '']);
});

test('a value is found behind its key', () => {
  assert.deepEqual(place('ends: |'), ['ends', 'value', '']);
  assert.deepEqual(place('ends:|'), ['ends', 'value', '']);
  assert.deepEqual(place('eyrie: 1\nblue:\n  bingo: 20 k|'), ['blue.bingo', 'value', '20 k']);
  assert.deepEqual(place('"ends": bl|'), ['ends', 'value', 'bl']);
});

test('items of lists stand below their key or in its column', () => {
  assert.deepEqual(place('root:\n  - navigate\n  - na|'), ['root.-', 'key', 'na']);
  assert.deepEqual(place('root:\n- navigate\n- navigate: {}\n  vo|'), ['root.-', 'key', 'vo']);
  assert.deepEqual(place('a:\n  - b:\n      - c:\n          vote: 3|'), ['a.-.b.-.c.vote', 'value', '3']);
});

test('braces are followed, over lines too', () => {
  assert.deepEqual(place('start: {north: 0 nmi, |'), ['start', 'key', '']);
  assert.deepEqual(place('start: {north: 0 nmi, east: 3|'), ['start.east', 'value', '3']);
  assert.deepEqual(place('route:\n  - {north: 5 nmi, alt|'), ['route.-', 'key', 'alt']);
  assert.deepEqual(place('trees: {a: {selector: [{navigate: {\n   vote: |'), ['trees.a.selector.-.navigate.vote', 'value', '']);
  assert.deepEqual(place('players: [one, tw|'), ['players.-', 'key', 'tw']);
  assert.deepEqual(place('start: {north: 0 nmi}\nen|'), ['', 'key', 'en']);
  assert.deepEqual(place('name: {"a, b": 1}\nen|'), ['', 'key', 'en']);
});

test('comments do not count', () => {
  assert.deepEqual(place('a:\n  # b:\n  c|'), ['a', 'key', 'c']);
  assert.deepEqual(place('a: [1, # ]\n  2|'), ['a.-', 'key', '2']);
});

const kSchema: Schema = {
  properties: {
    ends: { enum: ['blue_home', 'time'], description: 'what ends it' },
    root: { $ref: '#/definitions/node' },
    flights: { type: 'object', additionalProperties: { properties: { bingo: { allOf: [{ $ref: '#/definitions/mass' }], description: 'fuel' }, lost: { type: 'boolean' } } } },
  },
  definitions: {
    mass: { anyOf: [{ type: 'string', pattern: '^[ \\t]*[-+]?([0-9]+)[ \\t]*(kg|lb|kg/s²)[ \\t]*$' }, { const: 0 }] },
    node: { anyOf: [{ enum: ['navigate'] }, { properties: { selector: { type: 'array', items: { $ref: '#/definitions/node' } }, navigate: { properties: { vote: { type: 'number', description: 'how strongly' } } } } }] },
  },
};

test('the grammar knows keys, words, units and what they mean', () => {
  const grammar = new Grammar(kSchema);
  assert.deepEqual([...grammar.keys([]).keys()], ['ends', 'root', 'flights']);
  assert.equal(grammar.keys([]).get('flights')!.nested, true);
  assert.equal(grammar.keys([]).get('ends')!.nested, false);
  assert.deepEqual(grammar.words(['ends']), ['blue_home', 'time']);
  assert.deepEqual(grammar.words(['flights', 'eagle', 'lost']), ['true', 'false']);
  assert.deepEqual(grammar.units(['flights', 'eagle', 'bingo']), ['kg', 'lb', 'kg/s²']);
  const deep = ['root', 'selector', '-', 'selector', '-'];
  assert.deepEqual([...grammar.keys(deep).keys()], ['selector', 'navigate']);
  assert.deepEqual(grammar.words(deep), ['navigate']);
  assert.equal(grammar.help([...deep, 'navigate', 'vote']), 'how strongly');
  assert.deepEqual([...grammar.keys(['nowhere']).keys()], []);
  assert.equal(grammar.help(['constructor']), '');
});
