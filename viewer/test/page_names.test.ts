// SPDX-License-Identifier: MIT
/** The longest names that files may have, in the narrow panels of the page. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { promisify } from 'node:util';
import type { Browser } from 'puppeteer-core';
import { kNoProgram, kProgram, launch, on_page, open_file, scratch_folder, shoot } from './page_kit.ts';

const folder = scratch_folder();
const kFlight = 'a_very_long_name_of_a_flight_of_letters_'.slice(0, 40);
const kNode = 'a_very_long_name_of_a_node_which_has_as_many_letters_as_may_be_x'.slice(0, 64);
let browser: Browser;
before(async () => {
  if (kNoProgram) return;
  browser = await launch();
  writeFileSync(join(folder, 'names.yaml'), `
eyrie: 1
name: names
reference: {latitude: 33 deg, longitude: -68 deg}
until: 20 s
trees: {pilot: {winner_takes_all: [{follow_lead: {name: ${kNode}, vote: 50}}, navigate]}}
blue:
  flights:
    ${kFlight}:
      aircraft: f15c
      tree: pilot
      players: [${kFlight}1, ${kFlight}2]
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
      route: [{north: 0 nmi, east: 40 nmi, altitude: 20000 ft, speed: 450 kt}]
`);
  await promisify(execFile)(kProgram, ['fly', 'names.yaml', '--quiet', '--out', 'run'], { cwd: folder });
});
after(async () => browser?.close());

for (const width of [1280, 390])
  test(`what is long is cut, the rank of a player never is, and nothing is pushed out, at ${width} px`, { skip: kNoProgram }, async () => {
    await on_page(open_file(browser, join(folder, 'run', 'debrief.html'), { width, height: 900 }), async (page) => {
      await page.evaluate(() => window.eyrie!.store.set({ time: 15, selected: 1, playing: false }));
      const seen: string[] = [];
      const look = async (): Promise<number> => seen.push(...await page.evaluate(() => {
        const outside = (e: Element): boolean => {
          const panel = e.closest('.left, .right, .bottom')!.getBoundingClientRect();
          const { left, right, width: wide } = e.getBoundingClientRect();
          return wide > 0 && (right > panel.right + 1 || left < panel.left - 1);
        };
        const all = [...document.querySelectorAll('.players h2 .dim, .who-line > *, .details header > *, .fields .winner, .rival, .lead-line b, .legend li, .row-label > .cut')];
        // what is cut at its beginning ends where its box does
        const cut = [...document.querySelectorAll('.front')].filter((e) => {
          const [box, words] = [e.getBoundingClientRect(), e.firstElementChild!.getBoundingClientRect()];
          return box.width > 0 && (words.right > box.right + 1 || e.getAttribute('title') !== e.textContent);
        });
        const sideways = [...document.querySelectorAll('.players, .inspector-body, .story ol')].filter((e) => e.scrollWidth > e.clientWidth);
        return [...all.filter(outside), ...cut, ...sideways].map((e) => e.outerHTML.slice(0, 120));
      }));
      if (width < 900) {
        await page.click('button[aria-label="Show: Players and story"]');
        await look();
        await shoot(page, `names_left_${width}`);
        await page.click('button[aria-label="Show: Decision"]');
      }
      await page.click(`[data-path="root/${kNode}"]`);
      await page.waitForSelector('.details h3');
      await look();
      await shoot(page, `names_${width}`);
      assert.deepEqual(seen, []);
      assert.equal(await page.$eval('.details h3', (title) => title.getAttribute('title')), `root/${kNode}`);
    });
  });
