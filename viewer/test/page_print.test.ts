// SPDX-License-Identifier: MIT
/** What is printed: all of it, on white. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import type { UserPage } from './browsers.ts';
import { kNoPage, kWhere, shoot, with_page } from './page_kit.ts';

const kNone = kNoPage || (kWhere === 'chromium' ? false : 'only Chromium can be told to show what it would print');
let page: UserPage;
// with a graphics card's drawing, of which nothing is kept to be printed
with_page({ fragment: '#t=480&p=eagle1', theme: 'dark', draw: 'webgl' }, (opened, _: Browser) => {
  ({ page } = opened);
});

/** The share of dark pixels in the upper half of the air picture. */
const darkness = (): Promise<number> => page.$eval('.scene > canvas:last-child', (e) => {
  const canvas = e as HTMLCanvasElement;
  const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height / 2);
  let dark = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i]! + data[i + 1]! + data[i + 2]! < 300) ++dark;
  return (4 * dark) / data.length;
});

test('on paper the page is white and whole, and has nothing to press', { skip: kNone }, async () => {
  await page.evaluate(() => void window.dispatchEvent(new Event('beforeprint')));
  await page.print_media('print');
  const { scheme, cut, controls } = await page.evaluate(() => {
    const all = [...document.querySelectorAll<HTMLElement>('.page :not(.unseen)')].filter((e) => e.getClientRects().length > 0);
    return {
      scheme: getComputedStyle(document.documentElement).colorScheme,
      cut: all.filter((e) => e.scrollHeight > e.clientHeight + 2 && /auto|scroll|hidden/.test(getComputedStyle(e).overflowY)).map((e) => e.className),
      controls: all.filter((e) => e.matches('input, select, .tool')).map((e) => e.outerHTML.slice(0, 80)),
    };
  });
  assert.deepEqual([scheme, cut, controls], ['light', [], []]);
  for (const part of ['.about b', '.moment', '.scene', '.tree', '.told:last-of-type', '.player'])
    assert.ok((await page.box(part)).height > 5, part);
  const [right, left] = [await page.box('.right'), await page.box('.left')];
  assert.ok(left.y >= right.y + right.height, 'one lies over the other');
  assert.ok((await darkness()) < 0.2, 'the picture is not white');
  await shoot(page, 'print');
});

test('and afterwards it is as it was', { skip: kNone }, async () => {
  await page.print_media('screen');
  await page.evaluate(() => void window.dispatchEvent(new Event('afterprint')));
  assert.equal((await page.$$('.scene > canvas')).length, 2);
  assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).colorScheme), 'dark');
  await page.waitForFunction(() => getComputedStyle(document.querySelector('.scene')!).backgroundColor === 'rgb(6, 9, 14)');
});

test('of a long story every line is printed', { skip: kNone }, async () => {
  const lines = await page.evaluate(() => {
    const { story } = window.eyrie!.run;
    story.push(...Array.from({ length: 500 }, () => story.at(-1)!));  // as of a fight of many
    return story.length;
  });
  await page.fill('.filters input', ' ');
  const told = (): Promise<number> => page.evaluate(() => document.querySelectorAll('.told').length);
  await page.waitForFunction(() => document.querySelector('.story .more'));
  const before = await told();
  assert.ok(before < lines);
  await page.evaluate(() => void window.dispatchEvent(new Event('beforeprint')));
  assert.equal(await told(), lines);
  await page.evaluate(() => void window.dispatchEvent(new Event('afterprint')));
  assert.equal(await told(), before);
});
