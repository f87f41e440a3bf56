// SPDX-License-Identifier: MIT
/** A link says what the page showed, and a broken one does no harm. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { View, layers_of } from '../src/store.ts';
import { link_text, not_understood, read_link, read_link_in_page } from '../src/ui/link.ts';
import { kPursues, told_run } from './ui_run.ts';

const kRun = told_run(Array.from({ length: 100 }, () => kPursues));

test('what a link says is what is read from it', () => {
  const view = { time: 3.42, selected: 1, camera: 'follow', pose: null, zoom: [2, 8.5], ruler: [1, 0] } as const;
  const text = link_text(kRun, { ...new View(), ...view, zoom: [...view.zoom], ruler: [...view.ruler] });
  assert.equal(text, '#t=3.42&p=bogey1&c=follow&z=2-8.5&r=bogey1,eagle2');
  const { pose, ...told } = view;
  assert.equal(pose, null);
  assert.deepEqual(read_link(kRun, text), told);
});

test('a link to a moment that is opened in the page takes stretch and ruler away', () => {
  assert.deepEqual(read_link_in_page(kRun, '#t=3', 10), { time: 3, zoom: null, ruler: null });
  assert.deepEqual(read_link_in_page(kRun, '#t=3&z=2-8.5&r=bogey1,eagle2', 10), { time: 3, zoom: [2, 8.5], ruler: [1, 0] });
  assert.deepEqual(read_link_in_page(kRun, '#c=top', 10), { camera: 'top' });
});

test('a free camera stands where the link says', () => {
  const view = { time: 1, selected: 0, camera: 'free', pose: [1.5, 6, -20.25, 80, 0.5, 0.9], zoom: null, ruler: null } as const;
  const text = link_text(kRun, { ...new View(), ...view });
  assert.equal(text, '#t=1&p=eagle2&c=free&e=1.5,6,-20.25,80,0.5,0.9');
  assert.deepEqual(read_link(kRun, text).pose, view.pose);
  assert.ok(!link_text(kRun, { ...new View(), ...view, camera: 'follow' }).includes('e='), 'the other cameras find their own place');
  assert.equal(read_link(kRun, '#c=free&e=1,2,3').pose, undefined);
});

test('theme, layers, units and trails are in it where they are not as usual', () => {
  const taste = { theme: 'dark', layers: layers_of(['labels', 'rings']), units: 'metric', trail: Infinity } as const;
  const text = link_text(kRun, { ...new View(), ...taste });
  assert.equal(text, '#t=0&p=eagle2&c=whole&d=dark&l=rings,labels&u=metric&w=Infinity');
  const { time, selected, camera, ...told } = read_link(kRun, text);
  assert.deepEqual(told, taste);
  assert.deepEqual(read_link(kRun, '#d=blue&u=cubits&w=7'), {});
});

test('what a playground edits stays in the link', () => {
  const view = { time: 1, selected: 0, camera: 'whole', pose: null, zoom: null, ruler: null } as const;
  assert.equal(link_text(kRun, { ...new View(), ...view }, '#t=9&s=a-b_c'), '#t=1&p=eagle2&c=whole&s=a-b_c');
});

test('names with unusual letters survive', () => {
  const run = { ...kRun, players: [{ ...kRun.players[0]!, name: 'Ä & B,#1' }] };
  const view = { time: 0, selected: 0, camera: 'top', pose: null, zoom: null, ruler: null } as const;
  assert.equal(read_link(run, link_text(run, { ...new View(), ...view })).selected, 0);
});

test('times are kept within the run', () => {
  assert.equal(read_link(kRun, '#t=1e9').time, 10);
  assert.equal(read_link(kRun, '#t=-5').time, 0);
});

test('nonsense is left out', () => {
  for (const text of ['', '#', '#t=soon&p=nobody&c=upside_down&z=8-2&r=eagle2,eagle2', '#z=1', '#t=', '#r=eagle2', '#%%%'])
    assert.deepEqual(read_link(kRun, text), {}, text);
});

test('what is left out is told', () => {
  assert.deepEqual(not_understood(kRun, '#t=abc&p=nobody&c=top&l=foo&s=a-b&time=5'), ['t=abc', 'p=nobody', 'l=foo', 'time=5']);
  assert.deepEqual(not_understood(kRun, '#t=3&p=eagle2&c=free&e=1,2,3,4,5,6&z=2-8&r=bogey1,eagle2&d=dark&l=&u=metric&w=20'), []);
  assert.deepEqual(not_understood(kRun, ''), []);
});

test('layers that there are not hide none', () => {
  assert.equal(read_link(kRun, '#l=foo').layers, undefined);
  assert.deepEqual(read_link(kRun, '#l=foo,rings').layers, layers_of(['rings']));
  assert.deepEqual(read_link(kRun, '#l=').layers, layers_of([]));
  assert.deepEqual(not_understood(kRun, '#l=foo,rings'), ['l=foo']);
});
