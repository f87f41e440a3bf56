// SPDX-License-Identifier: MIT
/** What is edited in the playground: files and what they include; and how a link holds it. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { Text } from '@codemirror/state';
import { Address, link_of, read_link } from '../src/play/address.ts';
import { offset } from '../src/play/editor.ts';
import { edited, help_of, is_edited, is_seed, seed_of, tree_names, with_includes, type Project } from '../src/play/project.ts';

const kShipped = {
  'scenarios/sweep.yaml': 'eyrie: 1\nhelp: "a sweep"\ninclude: [packages/pilots.yaml, packages/none.yaml]\nseed: 13  # why\ntrees:\n  own: navigate\nblue: {}\n',
  'scenarios/packages/pilots.yaml': 'include:\n  - more.yaml\ntrees:\n  sweep:\n    root: navigate\n  # a comment\n\n  patrol: navigate\n',
  'scenarios/packages/more.yaml': 'data: {}\n',
  'data/missiles/aim120.yaml': 'mass: 1 kg\n',
};
const kProject: Project = { shipped: kShipped, edits: {}, scenario: 'scenarios/sweep.yaml', seed: '' };

test('a file is shown with what it includes, each once', () => {
  assert.deepEqual(with_includes(kProject, kProject.scenario), ['scenarios/sweep.yaml', 'scenarios/packages/pilots.yaml', 'scenarios/packages/more.yaml']);
  const circle = edited(kProject, 'scenarios/packages/more.yaml', 'include: pilots.yaml\n');
  assert.equal(with_includes(circle, circle.scenario).length, 3);
});

test('a file is shown with the scenario that it extends', () => {
  const other = { ...edited(kProject, 'scenarios/other.yaml', 'extends: sweep  # by name\ntrees:\n  more: navigate\n'), scenario: 'scenarios/other.yaml' };
  assert.deepEqual(with_includes(other, other.scenario), ['scenarios/other.yaml', ...with_includes(kProject, kProject.scenario)]);
  assert.deepEqual(tree_names(other), ['more', 'own', 'sweep', 'patrol']);
  const file = edited(other, 'scenarios/other.yaml', 'extends: sweep.yaml\n');
  assert.equal(with_includes(file, other.scenario)[1], 'scenarios/sweep.yaml');
});

test('trees are known by their names, of included files too', () => {
  assert.deepEqual(tree_names(kProject), ['own', 'sweep', 'patrol']);
});

test('help and seed are what the scenario says', () => {
  assert.equal(help_of(kShipped['scenarios/sweep.yaml']), 'a sweep');
  assert.equal(seed_of(kProject), '13');
  assert.equal(seed_of(edited(kProject, kProject.scenario, 'eyrie: 1\n')), '1');
  const heir = edited(kProject, 'scenarios/heir.yaml', 'extends: sweep\n');
  assert.equal(seed_of({ ...heir, scenario: 'scenarios/heir.yaml' }), '13', 'what it extends has it');
});

test('a seed is a whole number that the engine takes, and nothing is made of another text', () => {
  for (const seed of ['0', '007', '18446744073709551615']) assert.ok(is_seed(seed), seed);
  for (const none of ['', '1.5', '-5', '1e3', '٣', '18446744073709551616', '100000000000000000000']) assert.ok(!is_seed(none), none);
});

test('a text that is as it was shipped is no edit', () => {
  const other = edited(kProject, kProject.scenario, 'eyrie: 1\n');
  assert.deepEqual(Object.keys(other.edits), [kProject.scenario]);
  assert.deepEqual(edited(other, kProject.scenario, kShipped['scenarios/sweep.yaml']).edits, {});
});

test('a flight is edited if something is that it flies with', () => {
  const shipped = { ...kShipped, 'scenarios/sweep.yaml': `${kShipped['scenarios/sweep.yaml']}aircraft: f15c\n`, 'scenarios/other.yaml': 'eyrie: 1\n', 'data/aircraft/f15c.yaml': 'stations: [{store: aim120}]\n' };
  const project = { ...kProject, shipped };
  assert.ok(!is_edited(project));
  for (const file of ['scenarios/sweep.yaml', 'scenarios/packages/more.yaml', 'data/aircraft/f15c.yaml', 'data/missiles/aim120.yaml'])
    assert.ok(is_edited(edited(project, file, `# other\n${shipped[file as keyof typeof shipped]}`)), file);
  assert.ok(!is_edited({ ...edited(project, 'scenarios/sweep.yaml', ''), scenario: 'scenarios/other.yaml' }));
});

test('a link brings back scenario, seed and edits', async () => {
  const project = { ...edited(kProject, 'data/missiles/aim120.yaml', 'mass: 2 kg  # Ä <b>\n'), seed: '7' };
  const link = await link_of(project);
  assert.match(link, /^#s=[\w-]+$/);
  assert.deepEqual(await read_link(link, kShipped), project);
  assert.deepEqual(await read_link(`${link}&t=312&p=eagle1`, kShipped), project);
  assert.equal(await read_link('#t=312', kShipped), null);
  assert.ok(link.length < 250, `${link.length} characters`);
  assert.equal(await link_of(edited(kProject, kProject.scenario, 'x'.repeat(2_000_000))), '', 'a link that cannot be read');
});

test('a link that is not ours is refused in words', async () => {
  const packed = (value: unknown): string => `#s=${deflateSync(JSON.stringify(value)).toString('base64url')}`;
  const good = { v: 1, scenario: 'scenarios/sweep.yaml' };
  assert.ok(await read_link(packed(good), kShipped));
  const refused: [string, RegExp][] = [
    ['#s=', /damaged or cut/], ['#s=%%%', /damaged or cut/], ['#s=AAAA', /damaged or cut/], [(await link_of(kProject)).slice(0, -5), /damaged or cut/],
    [`#s=${'A'.repeat(300_000)}`, /too long/], [packed({ ...good, edits: { 'scenarios/sweep.yaml': 'x'.repeat(2_000_000) } }), /too large/],
    [packed(null), /another version/], [packed([]), /another version/], [packed({ ...good, v: 2 }), /another version/],
    [packed({ ...good, scenario: 'data/missiles/aim120.yaml' }), /scenario is not one/], [packed({ ...good, scenario: '__proto__' }), /scenario is not one/],
    [packed({ ...good, seed: '1e3' }), /seed is no number/], [packed({ ...good, seed: 7 }), /seed is no number/],
    [packed({ ...good, edits: { 'scenarios/other.yaml': '' } }), /not there/], [packed({ ...good, edits: { toString: '' } }), /not there/],
    [packed({ ...good, edits: { 'scenarios/sweep.yaml': 3 } }), /no texts/], [packed({ ...good, edits: [] }), /changes are none/],
    [packed({ ...good, edits: { 'scenarios/sweep.yaml': 'eyrie: 1 # \ud800' } }), /damaged or cut/],
  ];
  for (const [link, why] of refused) await assert.rejects(read_link(link, kShipped), why, link.slice(0, 60));
});

/** An address as a browser has it. */
function of_browser(hash: string): { hash: string } {
  const location = { hash, pathname: '/', search: '' };
  const history = { replaceState: (_: unknown, __: string, to: string) => (location.hash = to.startsWith('#') ? to : '') };
  Object.assign(globalThis, { location, history });
  return location;
}

test('the address holds what it can, and stays as it is until something is changed', async () => {
  const location = of_browser('#s=damaged');
  const address = new Address(kProject);
  await assert.rejects(address.read(kProject), /damaged/);
  assert.equal(await address.read(kProject), null, 'that was told');
  assert.ok(address.holds(kProject));
  const small = edited(kProject, kProject.scenario, 'eyrie: 1\n'), large = edited(kProject, kProject.scenario, 'x'.repeat(2_000_000));
  assert.ok(!address.holds(small));
  assert.deepEqual(await Promise.all([address.write(kProject), address.write(small)]), [true, true]);
  assert.ok(address.holds(small) && !address.holds(kProject), 'the last one stands there');
  assert.equal(location.hash, await link_of(small));
  assert.equal(await address.write(large), false);
  assert.ok(address.holds(small) && !address.holds(large));
  assert.ok(await address.write(kProject));
  assert.equal(location.hash, '');
});

test('what an address became on the ways back and forward is read, and nothing is written over it', async () => {
  const location = of_browser('');
  const address = new Address(kProject);
  assert.equal(await address.read(kProject), null);
  const small = edited(kProject, kProject.scenario, 'eyrie: 1\n'), other = edited(kProject, kProject.scenario, 'eyrie: 1  # other\n');
  const late = address.write(small);
  location.hash = await link_of(other);
  await late;
  assert.equal(location.hash, await link_of(other), 'it is not read yet');
  const reading = address.read(small);
  await address.write(small);
  const read = await reading;
  assert.equal(location.hash, await link_of(other));
  assert.deepEqual(read, other);
  assert.ok(address.holds(read!));
  // two ways at once: the last one counts
  location.hash = '';
  const first = address.read(other);
  location.hash = await link_of(small);
  assert.deepEqual(await Promise.all([first, address.read(other)]), [null, small]);
  location.hash = await link_of(other);
  address.pass_over();
  await address.write({ ...small });
  assert.equal(location.hash, await link_of(small));
});

test('a mistake is marked where it is, behind characters of two units too', () => {
  const doc = Text.of(['a: 1', "name: '✈😀😀', a: x"]);
  const column = [..."name: '✈😀😀', a: x"].indexOf('x') + 1;
  assert.equal(doc.sliceString(offset(doc, 2, column)), 'x');
  assert.equal(offset(doc, 2, 1000), doc.length);
  assert.equal(offset(doc, 0, 0), 0);
});
