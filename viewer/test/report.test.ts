// SPDX-License-Identifier: MIT
/** The report of a campaign as a person uses it, in both browsers, from disk: from a bar to a replicate, flown again in the page. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'puppeteer-core';
import { kBrowsers, launch, open_url, type UserPage } from './browsers.ts';

const { env } = process;
const kProgram = env['EYRIE_PROGRAM'] ?? '';
const kNone = kProgram ? false : 'EYRIE_PROGRAM is not set: no campaign to report of';
const kShots = env['EYRIE_SHOTS'];
const folder = mkdtempSync(join(tmpdir(), 'eyrie-report-'));
const report = join(folder, 'out/report.html');
const forged = join(folder, 'forged.html');

const eyrie = (...options: string[]): string =>
  execFileSync(kProgram, options, { cwd: folder, encoding: 'utf8', env: { ...env, EYRIE_HOME: join(env['EYRIE_VIEWER_FOLDER']!, '..') } });

before(() => {
  if (kNone) return;
  writeFileSync(join(folder, 'c.yaml'), `
eyrie: 1
name: "</script><b>tactics"
scenario: sweep
set: ['until=600 s']
factors:
  tactic: {path: trees.veteran.sequencer.trees.bvr.tree, values: {"<b>near</b>, and so much more to be said of it than there is room for, even in a window as wide as there are few": short_skate, "</script>": banzai}}
replicates: 4
measures:
  end: {what: end_time}
  shots: {what: shots, who: blue}
  fuel: {what: fuel_left, who: blue}
  exchange: {what: exchange_ratio, who: blue}
  miss: {what: event, event: detonation, who: red, take: first, value: miss}
`);
  eyrie('campaign', 'c.yaml', '--out', 'out');
  eyrie('report', 'out', '--ways', '0');
  // as if another program had flown the replicate with the seed 3 of the second cell
  writeFileSync(forged, readFileSync(report, 'utf8').replace(/\[1,2,3,("[^"]*",[^,]*),"0x/, '[1,2,3,$1,"0xf'));
});
after(() => rmSync(folder, { recursive: true }));

const ready = (page: UserPage) => page.waitForSelector('body[data-ready=true]');
/** By the words on it. */
async function press(page: UserPage, selector: string, words: string): Promise<void> {
  const at = (await page.$$eval(selector, (all) => all.map((one) => one.textContent))).findIndex((text) => text!.includes(words));
  assert.notEqual(at, -1, `no ${selector} says ${words}`);
  await (await page.$$(selector))[at]!.click();
}

for (const where of Object.keys(kBrowsers) as (keyof typeof kBrowsers)[])
  describe(`in ${where}`, { skip: kNone }, () => {
    let browser: Browser;
    before(async () => {
      browser = await launch(where);
    });
    after(async () => browser?.close());

    test('a click on a replicate flies it here, to the world of the results', async () => {
      const { page, complaints } = await open_url(browser, pathToFileURL(report).href, { width: 1280, height: 800 });
      await press(page, '#measures button', 'shots');
      await press(page, '#chart g', '1: </script>');
      await page.click('#behind svg g');
      const [seed] = await page.$$eval('#list tbody tr td:nth-child(2)', (cells) => cells.map((cell) => cell.textContent));
      const [, outcome, hash] = eyrie('query', 'out', `SELECT outcome, hash FROM replicates WHERE cell = 1 AND seed = ${seed}`).split('\n').flatMap((line, i) => i === 1 ? [line, ...line.split(',')] : []);
      await page.click('#list tbody td:last-child button');
      assert.match(await page.textContent('#list code'), new RegExp(`banzai.* --seed ${seed}$`));
      await page.click('#list tbody tr');
      await ready(page);
      assert.equal(await page.textContent('.verified'), '✓ same bits as in the results');
      const run = await page.evaluate(() => window.eyrie!.run.about);
      assert.deepEqual([run.hash, run.seed, run.outcome], [hash, seed, outcome]);
      assert.match(run.scenario, /^replicate \d, cell 1: <\/script>$/);
      if (kShots) writeFileSync(join(kShots, `replicate_${where}.png`), await page.screenshot());

      // the address is one of the replicate and the moment
      await page.evaluate(() => window.eyrie!.store.set({ time: 100 }));
      await page.waitForFunction(() => location.hash.includes('t=100'));
      const link = await page.evaluate(() => location.href);
      const again = await open_url(browser, link);
      await ready(again.page);
      assert.deepEqual(await again.page.evaluate(() => [window.eyrie!.run.about.hash, window.eyrie!.store.get().time]), [hash, 100]);

      await again.page.close();
      await page.click('.back');
      await page.waitForSelector('#list tbody tr');
      assert.match(await page.textContent('#behind h2'), /^shots in cell 1: <\/script>: 4 of 4/);
      if (kShots) writeFileSync(join(kShots, `report_${where}.png`), await page.screenshot());
      assert.deepEqual([...complaints, ...again.complaints], []);
    });

    test('cells, bars and replicates are worked by keys, and a replicate that is not there is told', { skip: where !== 'chromium' }, async () => {
      const { page, complaints } = await open_url(browser, `${pathToFileURL(report).href}#cell=1&replicate=99`, { width: 390, height: 800 });
      assert.equal(await page.textContent('#none'), 'This report has no replicate 99 of cell 1.');
      await page.$eval('#chart g', (cell) => (cell as SVGElement).focus());
      await page.keyboard.press('Enter');
      assert.match(await page.textContent('#behind h2'), / in cell 0: /);
      assert.ok(await page.$eval('#chart', (box) => box.querySelector('svg')!.getBoundingClientRect().right <= box.getBoundingClientRect().right), 'the chart is wider than its box');
      await page.$eval('#behind svg g', (bar) => (bar as SVGElement).focus());
      await page.keyboard.press(' ');
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the whole page scrolls sideways');
      await page.press('#list tbody td:first-child button', 'Enter');
      await ready(page);
      assert.deepEqual(complaints, []);
      await page.close();
    });

    test('a long name of a cell is cut beside its bar, and no factor is said to do nothing where cells differ', { skip: where !== 'chromium' }, async () => {
      const { page } = await open_url(browser, pathToFileURL(report).href, { width: 1280, height: 800 });
      const [words, whole, end, begin] = await page.$eval('#chart g', (cell) => {
        const text = cell.querySelector('text')!;
        const [, bar] = cell.querySelectorAll('rect');
        return [text.firstChild!.textContent!, text.querySelector('title')!.textContent!, text.getBoundingClientRect().right, bar!.getBoundingClientRect().left] as const;
      });
      assert.match(words, /^0: <b>near<\/b>, and so much.*…$/);
      assert.match(whole, /as there are few$/);
      assert.ok(end < begin, `${end} px, and its bar begins at ${begin}`);
      await press(page, '#measures button', 'fuel');
      const means = await page.evaluate(() => (JSON.parse(document.querySelector('#data')!.textContent!) as { cells: { estimates: number[][] }[] }).cells.map(({ estimates }) => estimates[2]![0]));
      assert.notEqual(means[0], means[1]);
      assert.equal(await page.textContent('#effects'), 'Each cell has a level of its own: see Against each other.');
      await page.close();
    });

    test('replicates that a measure divides by 0, or does not apply to, are counted and listed', { skip: where !== 'chromium' }, async () => {
      const asked = (what: string): number[] => eyrie('query', 'out', `SELECT ${what} FROM replicates GROUP BY cell`).trim().split('\n').slice(1).map(Number);
      const by_0 = asked('sum("exchange.per" = 0)'), with_miss = asked('count(miss)'), cell = by_0.findIndex((n) => n > 0 && n < 4);
      assert.ok(cell >= 0 && with_miss.some((n) => n < 4), `the flights are not such: ${by_0}, ${with_miss}`);
      const { page } = await open_url(browser, `${pathToFileURL(report).href}#measure=3&cell=${cell}`, { width: 1280, height: 800 });
      await page.waitForSelector('#list tbody tr');
      assert.match(await page.textContent('#behind .dim'), new RegExp(`^${by_0[cell]} divide by 0: `));
      const values = await page.$$eval('#list tbody td:nth-child(5)', (cells) => cells.map((one) => one.textContent!));
      assert.equal(values.length, 4);
      assert.deepEqual(values.map((value) => / : 0$/.test(value)), values.map((_, i) => i >= 4 - by_0[cell]!));
      const told = await page.$$eval('#all tbody td:last-child', (cells) => cells.map((one) => one.textContent!));
      assert.deepEqual(told.map((text) => / of (\d+)$/.exec(text)?.[1]), with_miss.map((n) => n < 4 ? `${n}` : undefined));
      assert.match(await page.textContent('#paired'), /^Paired by replicate; /);
      await page.close();
    });

    test('on paper its tables are whole and its drawings fit', { skip: where !== 'chromium' }, async () => {
      const { page } = await open_url(browser, `${pathToFileURL(report).href}#measure=1&cell=1`, { width: 700, height: 500 });
      await page.waitForSelector('#list tbody tr');
      await page.print_media('print');
      const [cut, wide, pressed] = await page.evaluate(() => [
        [...document.querySelectorAll('.scroll')].filter((e) => getComputedStyle(e).overflowY !== 'visible').length,
        [...document.querySelectorAll('svg')].filter((e) => e.getBoundingClientRect().right > innerWidth).length,
        [...document.querySelectorAll('button:not(.pick)')].filter((e) => e.getClientRects().length).map((e) => e.textContent),
      ] as const);
      assert.deepEqual([cut, wide, pressed], [0, 0, ['shots']]);
      await page.close();
    });

    test('one that ends otherwise than in the results is told so, and not shown', async () => {
      const { page } = await open_url(browser, `${pathToFileURL(forged).href}#measure=0&cell=1&replicate=2`);
      await page.waitForSelector('[role=alert]');
      assert.match(await page.textContent('[role=alert]'), /replicate 2, cell 1.*It ends otherwise here than in the results.*eyrie fly .*banzai.* --seed 3/);
      await page.click('[role=alert] button');
      await page.waitForSelector('#list tbody tr');
    });
  });
