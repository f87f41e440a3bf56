// SPDX-License-Identifier: MIT
/** `eyrie serve` without a scenario: one is chosen, changed by the form and flown, and its run is listed and compared. */
import assert from 'node:assert/strict';
import type { ChildProcess } from 'node:child_process';
import { after, before, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import { open_url, type UserPage } from './browsers.ts';
import { kNoProgram, launch, scratch_folder, serve, shoot } from './page_kit.ts';

const folder = kNoProgram ? '' : scratch_folder();
let browser: Browser, program: ChildProcess, page: UserPage;
let address = '';
let complaints: string[] = [];

before(async () => {
  if (kNoProgram) return;
  browser = await launch();
  ({ program, address } = await serve(['--rate', 'max'], folder));
  ({ page, complaints } = await open_url(browser, address, { width: 1280, height: 800 }));
});
after(async () => {
  await browser?.close();
  program?.kill('SIGKILL');
});

/** Chooses merge, and has it flown with that seed for that time. */
async function fly_merge(seed: string, until: string): Promise<void> {
  await page.click('button[value=merge]');
  await page.fill('#seed', seed);
  await page.evaluate(() => document.querySelector<HTMLDetailsElement>('details')!.open = true);
  await page.fill('[data-path=until]', until);
  await page.click('#fly');
}

test('shows each scenario with words and a picture of who begins where', { skip: kNoProgram }, async () => {
  await page.waitForSelector('[data-path=until]');
  const cards = await page.$$eval('#scenarios li', (all) => all.map((one) => [one.querySelector('strong')!.textContent, one.querySelector('span')!.textContent!.length > 20, one.querySelectorAll('circle').length] as const));
  assert.deepEqual(cards.find(([name]) => name === 'sweep'), ['sweep', true, 6]);
  assert.deepEqual(cards.filter(([, told, dots]) => !told || dots === 0), []);
  assert.match(await page.textContent('#chosen'), /^sweep: /);
  const paths = await page.$$eval('#fields [data-path]', (all) => all.map((one) => (one as HTMLElement).dataset['path']));
  assert.deepEqual(paths.filter((path) => ['until', 'ends', 'reference.latitude', 'rates.decisions'].includes(path!)).sort(), ['ends', 'rates.decisions', 'reference.latitude', 'until']);
  await shoot(page, 'home_1280');
});

test('says what is wrong with a value, and flies nothing', { skip: kNoProgram }, async () => {
  await fly_merge('5', '10 apples');
  await page.waitForFunction(() => /until: .*apples/.test(document.querySelector('#problem')!.textContent!));
  assert.equal(await page.$eval('#fly', (button) => (button as HTMLButtonElement).disabled), false);
});

test('flies what was chosen, and then lists it', { skip: kNoProgram }, async () => {
  for (const seed of ['5', '6']) {
    await fly_merge(seed, '20 s');
    await page.waitForFunction(() => window.eyrie !== undefined && window.eyrie.run.about.outcome !== 'running', undefined, { timeout: 120_000 });
    const flown = await page.evaluate(() => { const { about } = window.eyrie!.run; return [about.seed, Math.round(about.duration)]; });
    assert.deepEqual(flown.map(String), [seed, '20']);
    await page.click('a[href="/home"]');
    await page.waitForFunction(() => document.querySelector('#runs td') !== null);
  }
  const rows = await page.$$eval('#runs tr', (all) => all.map((row) => [...row.children].slice(1).map((cell) => cell.textContent)));
  assert.deepEqual(rows.map((row) => row.slice(0, 4)), [['merge-6', 'merge', '6', 'until=20 s'], ['merge-5', 'merge', '5', 'until=20 s']]);
});

test('compares two runs', { skip: kNoProgram }, async () => {
  for (const name of ['merge-5', 'merge-6']) await page.click(`[aria-label="compare ${name}"]`);
  await shoot(page, 'home_runs_1280');
  await page.click('#compare');
  await page.waitForSelector('body[data-ready=true]');
  assert.match(await page.evaluate(() => location.href), /run=merge-5&run=merge-6|run=merge-6&run=merge-5/);
  assert.equal(await page.evaluate(() => window.eyrie!.runs.length), 2);
  assert.deepEqual(complaints.filter((one) => !/favicon|^network: http:\/\/127|WebSocket|ws:|404|ERR_CONNECTION/.test(one)), []);  // between two hosts
});
