// SPDX-License-Identifier: MIT
/** The air picture with and without a graphics card, in a real browser: the same picture. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import type { UserPage } from './browsers.ts';
import type { Pose } from '../src/store.ts';
import { kNoPage, kWhere, launch, open_page, shoot, without_labels } from './page_kit.ts';

/** Debian's Firefox has no WebGL where there is no graphics card. */
const kNoCard = kNoPage || (kWhere === 'firefox' && 'Firefox does not let the processor stand in for a graphics card');

/** Squares along each side, in which colours are compared: lines are smoothed in two ways, but they are where they are. */
const [kAcross, kDown] = [40, 28];
/** Of 255: how far apart the mean of one square may be, and that of all. */
const [kApart, kApartAll] = [35, 2.2];

let browser: Browser;
before(async () => {
  if (!kNoPage) browser = await launch();
});
after(async () => browser?.close());

/** Mean red, green and blue of each square of the air picture. */
async function squares(page: UserPage): Promise<number[]> {
  const box = await page.box('.scene > canvas');
  const png = await page.screenshot(box);
  return page.evaluate(async ([data, across, down]) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const { width, height } = image;
    const pen = new OffscreenCanvas(width, height).getContext('2d')!;
    pen.drawImage(image, 0, 0);
    const pixels = pen.getImageData(0, 0, width, height).data;
    const sums = new Array<number>(4 * across * down).fill(0);
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x) {
        const square = 4 * (Math.floor((y * down) / height) * across + Math.floor((x * across) / width));
        for (let k = 0; k < 3; ++k) sums[square + k]! += pixels[4 * (y * width + x) + k]!;
        ++sums[square + 3]!;
      }
    return sums.flatMap((sum, i) => (i % 4 === 3 ? [] : [sum / sums[i - (i % 4) + 3]!]));
  }, [png.toString('base64'), kAcross, kDown] as const);
}

/** From where the camera of the page looks, or from `pose`: where it comes to rest depends on how fast pictures came. */
async function drawn(draw: 'webgl' | 'canvas', theme: 'light' | 'dark', fragment: string, from: Pose | null = null): Promise<{ means: number[]; pose: Pose | null }> {
  const { page, complaints } = await open_page(browser, { draw, theme, fragment });
  const kind = await page.$eval('.scene > canvas', (canvas) =>
    (canvas as HTMLCanvasElement).getContext('2d') ? 'canvas' : 'webgl');
  assert.equal(kind, draw, 'it is drawn as the address asks');
  await page.mouse.move(5, 5);
  await without_labels(page);
  // until the camera stands still
  await page.waitForFunction(() => window.eyrie!.scene.is_still());
  if (from) await page.evaluate((pose) => window.eyrie!.store.set({ pose }), from);
  await page.waitForFunction(() => window.eyrie!.scene.is_still());
  await page.at_rest('.stage');
  const means = await squares(page);
  await shoot(page, `draw_${draw}_${theme}_${fragment.replace(/\W+/g, '_')}`);
  assert.deepEqual(complaints, []);
  const pose = await page.evaluate(() => window.eyrie!.store.get().pose);
  await page.close();
  return { means, pose };
}

for (const [theme, fragment] of [
  ['light', '#t=590&p=eagle1&c=free&e=-30.012,9.4288,1.9873,33.1682,0,0.95'], ['dark', '#t=640&p=eagle1&c=follow'], ['light', '#t=640&p=bogey1&c=top'],
  // the radar's volume reaches behind the eye
  ['light', '#t=692&p=eagle1&c=free&e=-29.2631,8.8353,6.3753,16,0,0.95'],
] as const)
  test(`${theme} ${fragment} is the same with and without a graphics card`, { skip: kNoCard }, async () => {
    const { means: card, pose } = await drawn('webgl', theme, fragment);
    const { means: flat } = await drawn('canvas', theme, fragment, pose);
    const apart = card.map((value, i) => Math.abs(value - flat[i]!));
    const mean = apart.reduce((a, b) => a + b) / apart.length;
    assert.ok(mean < kApartAll, `${mean.toFixed(2)} apart in the mean`);
    assert.ok(Math.max(...apart) < kApart, `${Math.max(...apart).toFixed(0)} apart in one square`);
    assert.ok(Math.max(...flat) - Math.min(...flat) > 30, 'and it is not empty');
  });

test('without a graphics card none is stood in for', { skip: kNoPage }, async () => {
  const { page } = await open_page(browser);
  assert.ok(await page.$eval('.scene > canvas', (canvas) => (canvas as HTMLCanvasElement).getContext('2d') !== null));
  await page.close();
});
