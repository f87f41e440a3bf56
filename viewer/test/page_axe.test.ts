// SPDX-License-Identifier: MIT
/** The page for those who cannot see it well, or hold no mouse: what axe-core finds of WCAG 2.2 AA, and the way of the tabulator. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import type { UserPage } from './browsers.ts';
import { kNoPage, kNoProgram, launch, open_file, open_page, scratch_folder, two_runs } from './page_kit.ts';

const kAxe = readFileSync(createRequire(join(process.env['EYRIE_VIEWER_FOLDER']!, 'package.json')).resolve('axe-core'), 'utf8');
/** Best practices too, as of headings and landmarks. */
const kTags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

/** Of the whole page, or of what `within` finds in it. */
async function findings(page: UserPage, within?: string): Promise<string[]> {
  await page.evaluate(kAxe);
  return page.evaluate(async (tags, part) => {
    const { axe } = window as unknown as { axe: { run(where: Document | string, how: object): Promise<{ violations: { id: string; nodes: { html: string; failureSummary: string }[] }[] }> } };
    const { violations } = await axe.run(part ?? document, { runOnly: tags });
    return violations.flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 140)} ${failureSummary}`));
  }, kTags, within);
}

describe('axe finds nothing', { skip: kNoPage }, () => {
  const folders = { light: scratch_folder(), dark: scratch_folder() };
  let browser: Browser;
  before(async () => (browser = await launch()));
  after(async () => browser?.close());

  for (const theme of ['light', 'dark'] as const) {
    test(`${theme}: at the first moment, with a sequencer, everything open, and what if`, async () => {
      const { page } = await open_page(browser, { theme, fragment: `#d=${theme}` });
      assert.deepEqual(await findings(page), []);
      await page.evaluate(() => window.eyrie!.store.set({ time: 480, selected: 1 }));
      await page.click('[data-path="root/bvr"]');
      await page.selectOption('select[aria-label="Arbiter of bvr"]', 'fusion');
      await page.waitForSelector('.what-if .verdict');
      assert.deepEqual(await findings(page), []);
      for (const menu of await page.$$('details.menu')) {
        await menu.evaluate((e) => e.setAttribute('open', ''));
        assert.deepEqual(await findings(page, 'details.menu[open]'), []);
        await menu.evaluate((e) => e.removeAttribute('open'));
      }
      await page.keyboard.press('?');
      assert.deepEqual(await findings(page), []);
      await page.close();
    });
    test(`${theme}: in a narrow window with each of its sheets`, async () => {
      const { page } = await open_page(browser, { theme, width: 390, height: 844, fragment: `#d=${theme}` });
      for (const sheet of ['Players and story', 'Decision']) {
        await page.click(`button[aria-label="Show: ${sheet}"]`);
        assert.deepEqual(await findings(page), [], sheet);
      }
      await page.close();
    });
    test(`${theme}: of two runs`, { skip: kNoProgram }, async () => {
      const { file } = await two_runs(folders[theme], ['trees.bvr.per_field.release_weapon.zone=1']);
      const { page } = await open_file(browser, file, { theme, fragment: `#d=${theme}` });
      await page.waitForSelector('body[data-ready=true]');
      assert.deepEqual(await findings(page), []);
      await page.close();
    });
  }

  test('lists are one tab stop each, and arrows go through them', async () => {
    const { page } = await open_page(browser);
    const stops = await page.$$eval('button, input, select, summary, [tabindex]', (all) => all
      .filter((e) => e.getClientRects().length > 0 && (e as HTMLElement).tabIndex >= 0 && !e.closest('details:not([open]) > :not(summary)')).length);
    assert.ok(stops < 70, `${stops} tab stops`);
    for (const [items, key] of [['.story ol button', 'ArrowDown'], ['.players button', 'ArrowDown'], ['.tree [role=treeitem]', 'ArrowDown'], ['.moments ol button', 'ArrowRight']] as const) {
      assert.equal(await page.$$eval(items, (all) => all.filter((e) => (e as HTMLElement).tabIndex === 0).length), 1, items);
      await page.$eval(`${items}:not([tabindex="-1"])`, (e) => (e as HTMLElement).focus());
      await page.keyboard.press('Home');
      await page.keyboard.press(key);
      assert.equal(await page.$$eval(items, (all) => [...all].findIndex((e) => e === document.activeElement)), 1, items);
    }
    await page.keyboard.press('Enter');
    assert.equal(await page.$eval('.moments button:nth-of-type(1)[aria-current=true], .moments li:nth-child(2) button', (e) => e.getAttribute('aria-current')), 'true');
    await page.close();
  });
});
