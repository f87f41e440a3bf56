// SPDX-License-Identifier: MIT
/** The other future from a moment that only another future has. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { UserPage } from './browsers.ts';
import { kNoPage, with_page } from './page_kit.ts';

let page: UserPage;
with_page({ fragment: '#t=480&p=eagle2', height: 900 }, (opened) => ({ page } = opened));

test('from a moment after the run has ended it flies on from that end, and says so', { skip: kNoPage }, async () => {
  await page.click('[data-path="root/bvr/follow_lead"]');
  await page.fill('input[aria-label="vote in words"]', '45');
  await page.press('input[aria-label="vote in words"]', 'Tab');
  const fly_on = async (): Promise<string> => {
    await page.waitForSelector('.future button:enabled');
    await page.click('.future button');
    await page.waitForSelector('.future [data-outcome]');
    return page.textContent('.future');
  };
  assert.match(await fly_on(), /with it from 08:00\.0/);
  // as if the other future had gone on for longer
  const end = await page.evaluate(() => {
    const { run, store } = window.eyrie!;
    store.set({ end: run.about.duration + 100, time: run.about.duration + 50 });
    return run.about.duration;
  });
  const [, minutes, seconds] = /with it from (\d+):([\d.]+)/.exec(await fly_on())!;
  assert.ok(Math.abs(60 * Number(minutes) + Number(seconds) - end) < 0.06, `${minutes}:${seconds}, and the run ended at ${end} s`);
});
