// SPDX-License-Identifier: MIT
/** The page in the hands of somebody with a mouse, and of somebody who cannot see it. */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import type { Opened, UserPage } from './browsers.ts';
import { kNoPage, on_page, open_page, shoot, with_page } from './page_kit.ts';

let opened: Opened;
let page: UserPage;
let browser: Browser;
with_page({ fragment: '#t=480&p=eagle2' }, (...made) => {
  [opened, browser] = made;
  ({ page } = opened);
});

const view = () => page.evaluate(() => window.eyrie!.store.get());

/** What can be worked and has no name to call it by. */
function nameless(): Promise<string[]> {
  return page.$$eval('button, input, select, textarea, summary, a[href], [role=button], [role=slider], [tabindex]', (all) => all
    .filter((e) => e.getClientRects().length > 0)
    .filter((e) => {
      const by = (e.getAttribute('aria-labelledby') ?? '').split(' ').map((id) => document.getElementById(id)?.textContent ?? '').join('');
      const labels = [...((e as HTMLInputElement).labels ?? [])].map((label) => label.textContent ?? '').join('');
      const own = e.matches('input, select, textarea') ? '' : e.textContent ?? '';
      return !(e.getAttribute('aria-label') || by || labels || own || e.getAttribute('title') || '').trim();
    })
    .map((e) => e.outerHTML.slice(0, 120)));
}

test('every control has a name for a screen reader, with every menu open', { skip: kNoPage }, async () => {
  assert.deepEqual(await nameless(), []);
  await page.click('[data-path="root/bvr"]');
  await page.$$eval('details', (all) => all.forEach((e) => e.setAttribute('open', '')));
  assert.deepEqual(await nameless(), []);
  await page.$$eval('details.menu', (all) => all.forEach((e) => e.removeAttribute('open')));
});

test('a loser that is pointed at shows where it would have led, in the air picture too', { skip: kNoPage }, async () => {
  const rival = 'tbody[data-field=heading] .rival';
  const label = (await page.textContent(rival)).trim();
  await page.$eval(rival, (e) => e.scrollIntoView({ block: 'nearest' }));
  await page.mouse.move(5, 5);
  await page.waitForFunction(() => window.eyrie!.store.get().ghost === null);
  const without = await page.at_rest('.stage');
  await page.hover(rival);
  await page.waitForFunction(() => window.eyrie!.store.get().ghost !== null);
  const { ghost, selected } = await view();
  assert.ok(label.startsWith(ghost!.label), `${label} is not ${ghost!.label}`);
  assert.equal(ghost!.player, selected);
  await page.waitForTimeout(300);
  assert.ok(!(await page.screenshot('.stage')).equals(without), 'nothing is drawn of it');
  await shoot(page, 'ghost');
  await page.mouse.move(5, 5);
  await page.waitForFunction(() => window.eyrie!.store.get().ghost === null);
});

describe('the story', { skip: kNoPage }, () => {
  const told = () => page.$$eval('.story .told', (all) => all.map((e) => ({ kind: (e as HTMLElement).dataset['kind']!, text: e.textContent! })));
  test('is filtered by kind, by player and by words', async () => {
    const all = await told();
    await page.selectOption('select[aria-label="Kind of events"]', 'launch');
    const launches = await told();
    assert.ok(launches.length > 0 && launches.length < all.length && launches.every(({ kind }) => kind === 'launch'));
    const names = await page.$$eval('select[aria-label="Story of whom"] option', (all) => all.slice(1).map((e) => e.textContent!));
    const launchesOf = (name: string) => launches.filter(({ text }) => text.includes(name)).length;
    const who = names.find((name) => launchesOf(name) > 0 && launchesOf(name) < launches.length);
    assert.ok(who, 'a run in which several shoot');
    await page.selectOption('select[aria-label="Story of whom"]', { label: who });
    const his = await told();
    assert.ok(his.length > 0 && his.length < launches.length && his.every(({ text }) => text.includes(who)));
    await page.selectOption('select[aria-label="Kind of events"]', { index: 0 });
    await page.selectOption('select[aria-label="Story of whom"]', { index: 0 });
    await page.fill('input[aria-label="Filter the story by text"]', 'splash');
    assert.ok((await told()).every(({ text }) => /splash/.test(text)));
    await page.fill('input[aria-label="Filter the story by text"]', '');
  });
  test('leads to where it happened, and to whom', async () => {
    await page.selectOption('select[aria-label="Kind of events"]', 'kill');
    const [t, text] = await page.$eval('.story .told', (e) => [Number((e as HTMLElement).dataset['t']), e.textContent!] as const);
    await page.click('.story .told');
    await page.waitForFunction((time) => Math.abs(window.eyrie!.store.get().time - time) < 0.2, t);
    const who = await page.evaluate(() => window.eyrie!.run.players[window.eyrie!.store.get().selected]!.name);
    assert.ok(text.includes(`splash ${who}`), `${who} is not the one lost in "${text}"`);
    await page.selectOption('select[aria-label="Kind of events"]', { index: 0 });
  });
  test('leads from each launch to the decision to release', async () => {
    await page.selectOption('select[aria-label="Kind of events"]', 'launch');
    const count = await page.$$eval('.story .told', (all) => all.length);
    assert.ok(count > 0);
    for (let i = 0; i < count; ++i) {
      await page.evaluate((n) => (document.querySelectorAll('.story .told')[n] as HTMLElement).click(), i);
      await page.waitForFunction(() => document.querySelector<HTMLElement>('.inspector')!.dataset['leader']!.endsWith('release_weapon'));
    }
    await page.selectOption('select[aria-label="Kind of events"]', { index: 0 });
  });
});

test('the strips lead to a time, zoom, and play as fast as asked', { skip: kNoPage }, async () => {
  const plot = await page.box('.stack-plot');
  const row = await page.box('.row.leader');
  const axis = async () => {
    const { from, to } = await page.$eval('.stack-plot', (e) => ({ ...(e as HTMLElement).dataset }));
    return [Number(from), Number(to)] as const;
  };
  const [from, to] = await axis();
  await page.mouse.click(plot.x + plot.width * 0.25, row.y + row.height / 2);
  const pixel = (to - from) / plot.width;
  await page.waitForFunction(([t, off]) => Math.abs(window.eyrie!.store.get().time - t!) <= off!, [from + (to - from) * 0.25, 2 * pixel + 0.1] as const);
  await page.click('button[aria-label="Zoom in around now"]');
  const [near_from, near_to] = await axis();
  assert.ok(near_to - near_from < (to - from) * 0.6, `${near_from} to ${near_to} s`);
  await page.keyboard.press('z');
  await page.selectOption('select[aria-label="Speed"]', { index: 0 });
  assert.equal((await view()).rate, await page.$eval('select[aria-label="Speed"]', (e) => Number((e as HTMLSelectElement).options[0]!.value)));
});

test('what is under the pointer in timeline and strips is said above all else, inside of the window', { skip: kNoPage }, async () => {
  for (const [width, height] of [[1280, 800], [1920, 1080]] as const) {
    await on_page(open_page(browser, { width, height }), async (other) => {
      for (const row of ['events', 'leader ', 'altitude', 'range']) {
        const box = await other.box(`[data-row^="${row}"]`);
        for (const part of [0.1, 0.3, 0.97]) {
          await other.mouse.move(box.x + box.width * part, box.y + box.height / 2);
          const seen = await other.evaluate(() => {
            const tip = document.querySelector<HTMLElement>('.tip')!;
            tip.style.pointerEvents = 'auto';
            const { left, top, right, bottom } = tip.getBoundingClientRect();
            const at = (x: number, y: number): boolean => tip.contains(document.elementFromPoint(x, y));
            return [tip.textContent !== '', at(left + 3, top + 3), at(right - 3, top + 3), at(left + 3, bottom - 3), at(right - 3, bottom - 3)];
          });
          assert.deepEqual(seen, [true, true, true, true, true], `${row} at ${part} of ${width} x ${height}`);
        }
      }
    });
  }
});

test('it opens at the first shot with its decision, and each key moment leads to its own', { skip: kNoPage }, async () => {
  await on_page(open_page(browser), async (fresh) => {
    const shown = () => fresh.$eval('.inspector', (e) => ({ ...(e as HTMLElement).dataset }));
    assert.match((await shown())['leader']!, /release_weapon$/);
    const written = await fresh.evaluate(() => window.eyrie!.scene.svg());
    for (const name of ['eagle1', 'bogey1']) assert.ok(written.includes(`>${name}<`), `${name} is in the picture`);
    const moments = await fresh.$$eval('.moment', (all) => all.map((e) => (e as HTMLElement).dataset['moment']));
    for (const kind of ['kill', 'launch', 'phase']) assert.ok(moments.includes(kind), kind);
    await fresh.click('[data-moment=kill]');
    const who = await fresh.$eval('[data-moment=kill] b', (e) => e.textContent!);
    await fresh.waitForFunction((text) => text.includes(document.querySelector<HTMLElement>('.inspector')!.dataset['player']!), who);
  });
});

test('theme, layers and units are remembered', { skip: kNoPage }, async () => {
  await on_page(open_page(browser), async (first) => {
    await first.evaluate(() => {
      const { store } = window.eyrie!;
      store.set({ theme: 'dark', units: 'metric', layers: { ...store.get().layers, rings: true } });
    });
  });
  await on_page(open_page(browser), async (second) => {
    const { theme, units, layers } = await second.evaluate(() => window.eyrie!.store.get());
    assert.deepEqual([theme, units, layers.rings], ['dark', 'metric', true]);
    await second.evaluate(() => {
      const { store } = window.eyrie!;
      store.set({ theme: 'light', units: 'aviation', layers: { ...store.get().layers, rings: false } });
    });
  });
});

test('nothing was complained of', { skip: kNoPage }, () => assert.deepEqual(opened.complaints, []));
