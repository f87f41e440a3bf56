// SPDX-License-Identifier: MIT
/** The page runs its own script and nothing else, whatever the texts of a run hold. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { promisify } from 'node:util';
import type { Browser } from 'puppeteer-core';
import { kNoPage, kNoProgram, kPageFile, kProgram, launch, open_file, scratch_folder } from './page_kit.ts';

let browser: Browser;
const folder = scratch_folder();
before(async () => {
  if (!kNoPage) browser = await launch();
});
after(async () => browser?.close());

const kReady = 'body[data-ready=true]';

test('allows by name its own script and style, and nothing else', { skip: kNoPage }, () => {
  const policy = /<meta http-equiv="Content-Security-Policy" content="([^"]*)">/.exec(readFileSync(kPageFile, 'utf8'))?.[1];
  assert.ok(policy, 'the page has no policy');
  const rules = new Map(policy.split(';').map((rule) => rule.trim().split(/ (.*)/s) as [string, string]));
  assert.equal(rules.get('default-src'), "'none'");
  assert.match(rules.get('style-src') ?? '', /^'sha256-[A-Za-z0-9+/]{43}='$/);
  // what the page unpacks of itself is a blob, which no text of a run can make
  assert.match(rules.get('script-src') ?? '', /^('sha256-[A-Za-z0-9+/]{43}=' ){2}blob: 'wasm-unsafe-eval'$/);
  assert.equal(rules.get('worker-src'), 'blob:');
  // an icon without a byte, or browsers ask for one
  assert.equal(rules.get('img-src'), 'data:');
  assert.doesNotMatch(policy.replace("'wasm-unsafe-eval'", '').replace('img-src data:', ''), /unsafe|\*|http|data:/);
});

test('runs no other script, were one put into it', { skip: kNoPage }, async () => {
  const file = join(folder, 'injected.html');
  const foreign = `<script>window.pwned = 'script'</script>
    <script src="data:text/javascript,window.pwned='data'"></script>
    <img src="data:image/png,x" onerror="window.pwned = 'handler'">
    <svg onload="window.pwned = 'svg'"></svg><iframe srcdoc="<script>parent.pwned = 'frame'</script>"></iframe>
    <a id="link" href="javascript:window.pwned = 'link'">link</a>`;
  writeFileSync(file, readFileSync(kPageFile, 'utf8').replace('<body>', () => `<body>${foreign}`));
  const { page, complaints } = await open_file(browser, file);
  await page.waitForSelector(kReady);
  await page.evaluate(() => (document.querySelector('#link') as HTMLElement).click());
  assert.equal(await page.evaluate(() => (window as { pwned?: string }).pwned), undefined);
  assert.ok(complaints.filter((c) => /Content.Security.Policy/.test(c)).length >= 5, complaints.join('\n'));
  await page.close();
});

test('says that its end is missing', { skip: kNoPage }, async () => {
  const file = join(folder, 'cut.html');
  const whole = readFileSync(kPageFile, 'utf8');
  writeFileSync(file, whole.slice(0, whole.length / 2));
  const { page } = await open_file(browser, file);
  assert.match(await page.textContent('[role=alert]'), /not whole/);
  await page.close();
});

test('shows texts of a run as texts', { skip: kNoProgram }, async () => {
  const evil = (where: string) => `<img src=x onerror=window.pwned='${where}'>`;
  const quoted = (text: string) => JSON.stringify(text);
  writeFileSync(join(folder, 'evil.yaml'), `
eyrie: 1
name: ${quoted('evil ' + evil('name'))}
help: ${quoted(`</script><script>window.pwned='help'</script>${evil('help')}`)}
reference: {latitude: 33 deg, longitude: -68 deg}
until: 20 s
data: {aircraft: {evil: {base: f15c, label: ${quoted(evil('model'))}}}}
trees:
  evil:
    sequencer:
      trees: {${quoted(evil('phase'))}: {selector: [{navigate: {name: ${quoted(evil('node'))}}}]}, other: navigate}
      start: ${quoted(evil('phase'))}
      transitions: [{from: ${quoted(evil('phase'))}, to: other, when: route_done}]
blue:
  flights:
    eagle:
      aircraft: evil
      tree: evil
      players: [eagle1]
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
`);
  await promisify(execFile)(kProgram, ['fly', 'evil.yaml', '--quiet', '--out', 'run'], { cwd: folder });
  const { page, complaints } = await open_file(browser, join(folder, 'run', 'debrief.html'));
  await page.waitForSelector(kReady);
  await page.evaluate(() => window.eyrie!.store.set({ time: 10, playing: false }));
  await page.waitForFunction(() => document.querySelector('[data-player][data-step]')?.getAttribute('data-step'));
  const shown = await page.evaluate(() => document.body.textContent ?? '');
  for (const where of ['name', 'model', 'phase', 'node']) assert.ok(shown.includes(evil(where)), where);
  assert.equal((await page.$$('img')).length, 0);
  assert.equal(await page.evaluate(() => (window as { pwned?: string }).pwned), undefined);
  assert.deepEqual(complaints, []);
  await page.close();
});
