// SPDX-License-Identifier: MIT
/** A mission in the browser while the program flies it: looked at, steered, flown by hand, and the same to the last bit. */
import assert from 'node:assert/strict';
import { execFile, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { promisify } from 'node:util';
import type { Browser } from 'puppeteer-core';
import { open_url, type UserPage } from './browsers.ts';
import { kNoProgram, kProgram, launch, on_page, scratch_folder, serve, shoot } from './page_kit.ts';

const folder = kNoProgram ? '' : scratch_folder();
let browser: Browser, program: ChildProcess, page: UserPage;
let address = '';
let complaints: string[] = [];

before(async () => {
  if (kNoProgram) return;
  browser = await launch();
  ({ program, address } = await serve(['sweep', '--rate', '20', '--paused'], folder));
  ({ page, complaints } = await open_url(browser, address, { width: 1280, height: 800 }));
  await page.waitForSelector('body[data-ready=true]');
});
after(async () => {
  await browser?.close();
  program?.kill('SIGKILL');
});

const time = (): Promise<number> => page.evaluate(() => window.eyrie!.store.get().time);
const flown = (): Promise<number> => page.evaluate(() => window.eyrie!.run.about.duration);
const wait = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
const is_same = (of = page): Promise<boolean> => of.evaluate(() => document.querySelector('.pace .verified') !== null && document.querySelector('.big.bad') === null);
const told = (page: UserPage, words: string): Promise<void> => page.waitForFunction((wanted: string) => window.eyrie!.run.story.some(({ text }) => text.includes(wanted)), words);
const rate = (text: string): Promise<unknown> => page.$eval('[aria-label="Rate of the mission"]', (list, wanted) => {
  (list as HTMLSelectElement).value = wanted;
  list.dispatchEvent(new Event('change', { bubbles: true }));
}, text);

test('flies along once the mission is played, and stops when it is paused', { skip: kNoProgram }, async () => {
  assert.equal(await time(), 0);
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.eyrie!.store.get().time > 20);
  await page.keyboard.press(' ');
  await page.waitForFunction(() => !window.eyrie!.store.get().playing);
  await wait(300);
  const stopped = await time();
  assert.equal(stopped, await flown());
  await wait(300);
  assert.equal(await time(), stopped);
  assert.ok(await is_same());
  // as slow as the clock from here on: a busy machine has minutes until the mission is over
  await rate('1');
  await page.keyboard.press(' ');
});

test('looks back while the mission goes on, and comes to the present again', { skip: kNoProgram }, async () => {
  await page.keyboard.press('Home');
  const before = await flown();
  await page.waitForFunction((then: number) => window.eyrie!.run.about.duration > then + 10, before);
  assert.equal(await time(), 0);
  await shoot(page, 'live_past_1280');
  await page.click('.to-now');
  await page.waitForFunction((then: number) => window.eyrie!.store.get().time > then, before);
  // nobody sees what was not flown yet
  await page.keyboard.press('End');
  assert.ok((await time()) <= (await flown()));
  assert.equal(await page.$eval('.to-now', (button) => button.getAttribute('aria-pressed')), 'true');
});

test('gives another tree and takes a player away, and everybody agrees', { skip: kNoProgram }, async () => {
  const trees = await page.$$eval('.orders select option', (all) => all.filter((one) => !(one as HTMLOptionElement).disabled).map((one) => (one as HTMLOptionElement).value).filter(Boolean));
  assert.ok(trees.length, 'there is another tree');
  await page.keyboard.press('2');
  await page.$eval('.orders select', (list, wanted) => {
    (list as HTMLSelectElement).value = wanted;
    list.dispatchEvent(new Event('change', { bubbles: true }));
  }, trees[0]!);
  await page.waitForFunction((wanted: string) => {
    const { run } = window.eyrie!;
    return run.trees[run.shapes[run.players[1]!.decisions.shape.at(-1)!]!.tree]!.name === wanted;
  }, trees[0]!);
  await page.keyboard.press('3');
  await page.waitForFunction(() => document.querySelector('.orders')?.getAttribute('aria-label')?.includes('eagle3'));
  const press = (words: string): Promise<void> => page.$$eval('.orders button', (all, wanted) => (all.find((one) => one.textContent!.startsWith(wanted)) as HTMLElement).click(), words);
  await press('kill …');
  await page.waitForSelector('.orders .bad');
  assert.equal(await page.evaluate(() => window.eyrie!.run.players[2]!.end), '', 'not without a second word');
  await press('kill eagle3');
  await page.waitForFunction(() => window.eyrie!.run.players[2]!.end === 'lost');
  await wait(1200);
  assert.ok(await is_same());
});

test('in a narrow window the name of the scenario stands beside what is told of the clock', { skip: kNoProgram }, async () => {
  await on_page(open_url(browser, address, { width: 360, height: 740 }), async (narrow) => {
    await narrow.waitForSelector('.pace span');
    const [words, whole, within] = await narrow.$eval('.about > summary b', (name) => {
      const { right, top, height } = name.getBoundingClientRect();
      return [name.textContent, name.contains(document.elementFromPoint(right - 2, top + height / 2)), document.documentElement.scrollWidth <= innerWidth] as const;
    });
    assert.deepEqual([words, whole, within], ['sweep', true, true]);
    await shoot(narrow, 'live_360');
  });
});

test('who joins late sees the same', { skip: kNoProgram }, async () => {
  const late = await open_url(browser, address, { width: 1920, height: 1080 });
  await late.page.waitForSelector('body[data-ready=true]');
  await late.page.waitForSelector('.pace .verified');
  assert.equal(await late.page.evaluate(() => window.eyrie!.run.players[2]!.end), 'lost');
  await shoot(late.page, 'live_1920');
  await late.page.close();
});

/** Ends the mission; what flying its run again says, which fails where it is not the same to the last bit. */
async function replays(mission: ChildProcess, within: string, complaints: string[]): Promise<string> {
  mission.kill('SIGINT');
  await once(mission, 'exit');
  const [name] = readdirSync(join(within, 'runs')).filter((one) => one !== 'latest');
  const { stdout } = await promisify(execFile)(kProgram, ['replay', join(within, 'runs', name!), '--workers', '3', '--json']);
  assert.deepEqual(complaints.filter((one) => !/favicon|^network: http:\/\/127|WebSocket|ws:/.test(one)), []);
  return stdout;
}

const take_over = (page: UserPage): Promise<void> => page.$$eval('.orders button', (all) => (all.find((one) => one.textContent === 'Take over') as HTMLElement).click());

test('an aircraft is taken over, turned, shoots, and is handed back', { skip: kNoProgram }, async (t) => {
  // a missile soon reaches somebody, however far a page on a busy machine lags behind
  const own = scratch_folder();
  const { program: mission, address } = await serve(['sweep', '--set', 'blue.flights.eagle.start.east=30 nmi', '--paused'], own);
  const { page, complaints } = await open_url(browser, address, { width: 1280, height: 800 });
  t.after(async () => {
    await page.close();
    mission.kill('SIGKILL');
  });
  await page.waitForSelector('body[data-ready=true]');
  await page.keyboard.press(' ');
  await page.keyboard.press('1');
  await page.waitForFunction(() => document.querySelector('.orders')?.getAttribute('aria-label')?.includes('eagle1'));
  await take_over(page);
  await page.waitForSelector('.card');
  await shoot(page, 'live_card_1280');
  await page.keyboard.press('?');
  assert.equal(await page.$('.card'), null);
  await told(page, 'is taken over by a person');
  // what is flown and what is asked for, in degrees, as the table has it; to where the others come from
  const headings = (): Promise<number[]> => page.$$eval('.seat tbody tr:first-child td', (all) => all.slice(0, 2).map((cell) => parseInt(cell.textContent!, 10)));
  const [, before] = await headings();
  await page.keyboard.down('ArrowLeft');
  await wait(800);
  await page.keyboard.up('ArrowLeft');
  await page.waitForFunction((was: number) => {
    const [flown, asked] = [...document.querySelectorAll('.seat tbody tr:first-child td')].map((cell) => parseInt(cell.textContent!, 10)) as [number, number];
    return (was - asked + 360) % 360 > 10 && Math.abs((flown - asked + 540) % 360 - 180) < 5;
  }, before!);
  // by the stick of a gamepad, pulled
  const before_it = await page.evaluate(() => {
    const { motion, gauges } = window.eyrie!.run.players[0]!;
    return { low: motion.up.at(-1)!, samples: gauges.load_factor.length };
  });
  await page.keyboard.press('s');
  await page.evaluate(() => {
    const pad = { axes: [0, 0.7], buttons: Array.from({ length: 10 }, () => ({ pressed: false, value: 0 })) };
    navigator.getGamepads = () => [pad as unknown as Gamepad];
  });
  await page.waitForFunction(({ low, samples }: { low: number; samples: number }) => {
    const { motion, gauges } = window.eyrie!.run.players[0]!;
    return motion.up.at(-1)! > low + 200 && gauges.load_factor.slice(samples).some((g) => g > 2);
  }, before_it);
  await page.evaluate(() => { navigator.getGamepads = () => []; });
  await page.keyboard.press('s');
  // there is a target once the radar has found one, and a shot once it is in reach
  const press_until = async (key: 't' | ' ', is_done: () => boolean): Promise<void> => {
    for (let times = 0; !(await page.evaluate(is_done)); ++times) {
      assert.ok(times < 400, `'${key}' does nothing`);
      await page.keyboard.press(key);
      await wait(200);
    }
  };
  await press_until('t', () => !document.querySelector<HTMLButtonElement>('.acts button:nth-child(2)')!.disabled);
  await press_until(' ', () => window.eyrie!.run.missiles.some(({ shooter }) => shooter === 0));
  await wait(1200);
  assert.ok(await is_same(page));
  await shoot(page, 'live_taken_1280');
  // what was done beside what the tree recommended
  await page.click('.play');
  await page.waitForFunction(() => !window.eyrie!.store.get().playing);
  await page.waitForFunction(() => Number(document.querySelector<HTMLElement>('.overruled')?.dataset['count']) > 0);
  await shoot(page, 'live_overruled_1280');
  await page.click('.play');
  await page.keyboard.press('h');
  await told(page, 'is handed back');
  assert.equal(await page.$('.seat'), null);
  await replays(mission, own, complaints);
});

test('what if is asked anew once it is over, of all that was decided', { skip: kNoProgram }, async () => {
  const answered = (): Promise<void> => page.waitForFunction(() => {
    const { asked, answered, decisions } = document.querySelector<HTMLElement>('.what-if')!.dataset;
    return asked && asked === answered && Number(decisions) > 0;
  });
  const decisions = (): Promise<number> => page.$eval('.what-if', (panel) => Number((panel as HTMLElement).dataset['decisions']));
  await page.keyboard.press(' ');
  await page.waitForFunction(() => !window.eyrie!.store.get().playing);
  await page.keyboard.press('4');
  await page.waitForSelector('[data-player=eagle4] .tree .node.way');
  await page.$$eval('.tree .node.way', (way) => way.at(-1)!.dispatchEvent(new MouseEvent('click', { bubbles: true })));
  // one that no node has: avoid_collision has 90, of which nothing would be asked
  await page.fill('.details input[aria-label="vote in words"]', '91');
  await page.keyboard.press('Enter');
  await answered();
  const before = await decisions();
  await rate('Infinity');
  await page.click('.play');
  await page.waitForFunction(() => window.eyrie!.run.about.outcome !== 'running');
  await answered();
  await page.waitForFunction(() => JSON.parse(document.querySelector<HTMLElement>('.what-if')!.dataset['answered']!)[2] === true);
  const all = await page.evaluate(() => window.eyrie!.run.players[3]!.decisions.t.length);
  assert.ok(before < all, `${before} of ${all} before the end`);
  assert.equal(await decisions(), all);
});

test('ends as the program says, and the run that is left is flown again', { skip: kNoProgram }, async () => {
  await page.waitForFunction(() => !/^now/.test(document.querySelector('.to-now')!.textContent!));
  await page.waitForFunction(() => window.eyrie!.run.about.outcome !== 'running');
  await wait(1500);
  assert.ok(await is_same());
  await page.waitForFunction(() => !/running/.test(document.querySelector('.about summary')!.textContent!));
  await shoot(page, 'live_over_1280');
  const hash = await page.evaluate(() => window.eyrie!.run.about.hash);
  const again = await replays(program, folder, complaints);
  assert.ok(again.includes(hash), again);
});

test('offers no vote of a vehicle, which cannot be told one', { skip: kNoProgram }, async () => {
  const { program: other, address: there } = await serve(['convoy', '--paused'], folder);
  try {
    await on_page(open_url(browser, there, { width: 1280, height: 800 }), async (convoy) => {
      await convoy.click('.tool.words');  // a second on
      for (const [kind, offered] of [['aircraft', true], ['vehicle', false]] as const) {
        const name = await convoy.evaluate((wanted) => {
          const { run, store } = window.eyrie!;
          const one = run.players.find((player) => player.kind === wanted)!;
          store.set({ selected: one.index });
          return one.name;
        }, kind);
        await convoy.waitForSelector(`[data-player=${name}] .tree [data-path]`);
        await convoy.click('.tree [data-path$="/navigate"], .tree [data-path$="/follow_lead"]');
        await convoy.waitForSelector('.details .asks');
        assert.equal((await convoy.$('.vote-order')) !== null, offered, kind);
      }
    });
  } finally {
    other.kill('SIGKILL');
  }
});

test('offers nothing that other programs would have to wait for', { skip: kNoProgram }, async () => {
  const shared = await serve(['merge', '--ours', 'blue', '--dis', '239.1.2.3:32123', '--paused'], folder);
  const { page: other } = await open_url(browser, shared.address, { width: 1280, height: 800 });
  try {
    await other.waitForSelector('body[data-ready=true]');
    const play = '.tool.play:not([disabled])', rate_list = '[aria-label="Rate of the mission"]';
    await other.waitForSelector(`${rate_list}[disabled]`);
    await other.waitForSelector(play);  // it has not begun
    await other.keyboard.press(' ');
    await other.waitForSelector('.tool.play[disabled]');
    assert.match(await other.$eval(rate_list, (list) => list.getAttribute('title') ?? ''), /do not wait/);
    assert.ok(await other.$eval('.tool.words', (step) => (step as HTMLButtonElement).disabled));
  } finally {
    await other.close();
    shared.program.kill('SIGKILL');
  }
});
