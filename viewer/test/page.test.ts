// SPDX-License-Identifier: MIT
/** The page as a person uses it, in a real browser, against what the program says of the same run. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import type { Opened, UserPage } from './browsers.ts';
import {
  ask_command, explain, kNoPage, kNoProgram, kPageFile, open_file, open_page, scratch_folder, shoot, two_runs, with_page, without_labels,
  type DecisionJson,
} from './page_kit.ts';

let browser: Browser;
let opened: Opened;
let page: UserPage;
with_page({}, (...made) => {
  [opened, browser, page] = [...made, made[0].page];
});

/** s */
function time_now(): Promise<number> {
  return page.evaluate(() => window.eyrie!.store.get().time);
}
async function go_to(time: number): Promise<void> {
  await page.evaluate((t) => window.eyrie!.store.set({ time: t, playing: false }), time);
  await settled();
}
/** Until what the store says is on the screen. */
async function settled(): Promise<void> {
  await page.waitForFunction(() => {
    const { run, store } = window.eyrie!;
    const { time, selected } = store.get();
    const player = run.players[selected]!;
    const shown = document.querySelector<HTMLElement>('[data-player][data-step]')!.dataset;
    const { t, step } = player.decisions;
    let index = -1;
    while (index + 1 < t.length && t[index + 1]! <= time + 1e-9) ++index;
    return shown['player'] === player.name && shown['step'] === String(index < 0 ? '' : step[index]);
  });
}
async function select(name: string): Promise<void> {
  await page.click(`button[data-player="${name}"]`);
  await settled();
}
function inspector(): Promise<Record<string, string | undefined>> {
  return page.$eval('[data-player][data-step]', (element) => ({ ...(element as HTMLElement).dataset }));
}
/** s: when somebody was killed. */
function kills(): Promise<number[]> {
  return page.evaluate(() => window.eyrie!.run.story.filter((line) => line.tone === 'kill').map((line) => line.t));
}
/** Times (s) of decisions of a player, about `count`, spread over the run, and where somebody else began to lead. */
function times_of(name: string, count: number): Promise<number[]> {
  return page.evaluate(([who, few]) => {
    const { run } = window.eyrie!;
    const { t, shape } = run.players.find((p) => p.name === who)!.decisions;
    const wanted = new Set(Array.from({ length: few }, (_, i) => Math.floor(((i + 0.5) * t.length) / few)));
    for (let i = 1; i < t.length && wanted.size < 2 * few; ++i)
      if (run.shapes[shape[i]!]!.leader !== run.shapes[shape[i - 1]!]!.leader) wanted.add(i);
    return [...wanted].sort((a, b) => a - b).map((i) => t[i]!);
  }, [name, count] as const);
}

test('opens from disk without a network', { skip: kNoPage }, async (t) => {
  const after = (what: string) => page.evaluate((name) => performance.getEntriesByName(name)[0]?.duration ?? NaN, what);
  // what it may take is measured by ./eyrie bench page: here a machine may be busy
  t.diagnostic(`the first picture after ${(await after('eyrie-picture')).toFixed(0)} ms, ready after ${(await after('eyrie-open')).toFixed(0)} ms`);
  assert.match(await page.title(), /Eyrie debrief/);
  const text = readFileSync(kPageFile, 'utf8');
  assert.ok(text.length < 1.8e6, `the file has ${text.length} bytes`);
  for (const name of ['preact', 'three', 'uplot']) assert.match(text, new RegExp(`\\n${name} \\d[^]*Permission (to|is)`), `no licence of ${name}`);
  await shoot(page, 'whole-light-1280');
});

test('plays and pauses', { skip: kNoPage }, async () => {
  await go_to(100);
  await page.click('button[aria-label="Play"]');
  await page.waitForFunction(() => window.eyrie!.store.get().time > 101);
  await page.click('button[aria-label="Pause"]');
  const stopped = await time_now();
  await page.waitForTimeout(150);
  assert.equal(await time_now(), stopped);
});

test('scrubs along the events to a kill', { skip: kNoPage }, async () => {
  const [kill] = await kills();
  assert.ok(kill !== undefined, 'nobody was killed in this run');
  const row = await page.box('[data-row=events]');
  const plot = await page.box('.stack-plot');
  const axis = await page.$eval('.stack-plot', (e) => ({ ...(e as HTMLElement).dataset }));
  const [from, to] = [Number(axis['from']), Number(axis['to'])];
  const x = (t: number) => plot.x + ((t - from) / (to - from)) * plot.width;
  const y = row.y + row.height / 2;
  await page.mouse.move(x(kill) - 60, y);
  await page.mouse.down();
  for (const step of [-30, -10, -3, 0]) await page.mouse.move(x(kill) + step, y);
  await page.mouse.up();
  await settled();
  const pixel = (to - from) / plot.width;
  assert.ok(Math.abs((await time_now()) - kill) <= 2 * pixel, `at ${await time_now()} s, not ${kill} s`);
  await shoot(page, 'kill');
});

/** Every node that is drawn, every field with its winner, reason and rivals. */
async function shown_decision() {
  const nodes = await page.$$eval('[data-path]', (all) => all.map((e) => ({ ...(e as HTMLElement).dataset })));
  const fields = await page.$$eval('[data-field]', (all) => all.map((e) => ({
    name: (e as HTMLElement).dataset['field'], winner: (e as HTMLElement).dataset['winner'], text: (e as HTMLElement).dataset['value'],
    rivals: Number((e as HTMLElement).dataset['rivals']), reason: e.querySelector('.reason')?.textContent,
  })));
  return { nodes: new Map(nodes.map((n) => [n['path']!, n])), fields };
}

async function compare_with(decision: DecisionJson): Promise<void> {
  const where = `${decision.time_s} s`;
  const head = await inspector();
  assert.equal(head['step'], String(decision.step), where);
  assert.equal(head['leader'] || null, decision.leader, where);
  assert.equal(Math.fround(Number(head['vote'])), Math.fround(decision.vote), where);
  const { nodes, fields } = await shown_decision();
  for (const { path, asked, status, vote } of decision.nodes) {
    const node = nodes.get(path);
    if (!node) {
      assert.ok(!asked, `${where}: ${path} was asked and is not drawn`);
      continue;
    }
    assert.deepEqual([node['asked'], node['status']], [String(asked), asked ? status : 'none'], `${where}: ${path}`);
    if (asked) assert.equal(Math.fround(Number(node['vote'])), Math.fround(vote!), `${where}: ${path}`);
  }
  assert.deepEqual(fields, decision.action.map(({ name, winner, text, rivals, reason }) =>
    ({ name, winner, text, rivals: rivals.length, reason })), where);
}

describe('a decision is what the program explains', { skip: kNoProgram }, () => {
  for (const name of ['eagle2', 'eagle1', 'bogey1']) {
    test(`of ${name}`, async () => {
      await select(name);
      for (const time of await times_of(name, 4)) {
        await go_to(time);
        await compare_with(await explain(name, time));
      }
      await shoot(page, `decision-${name}`);
    });
  }
});

describe('what if', { skip: kNoPage }, () => {
  /** Looks at a node of the phase beyond visual range, where eagle2 pursues. */
  async function look_at(path: string): Promise<void> {
    await go_to(480);
    if (!(await page.$(`[data-node="${path}"]`))) await page.click(`[data-path="${path}"]`);
  }
  /** The attributes of the answer, and the command for the terminal that it shows. */
  async function answer() {
    await page.waitForFunction(() => {
      const { asked, answered } = document.querySelector<HTMLElement>('.what-if')!.dataset;
      return asked !== '' && asked === answered;
    });
    const told = await page.$eval('.what-if', (e) => ({ ...(e as HTMLElement).dataset }));
    return { told, command: (await page.textContent('.command code'))! };
  }
  async function compare(): Promise<void> {
    const { told, command } = await answer();
    const { decisions, different, first } = await ask_command(command);
    assert.deepEqual(
      [told['decisions'], told['different'], told['firstStep'], told['firstFlown'], told['firstOther']],
      [String(decisions), String(different), String(first?.step ?? ''), first?.leader.flown ?? '', first?.leader.other ?? ''], command);
    const shown = await page.$$eval('.changed tr', (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent!)));
    assert.deepEqual(shown.map(([name, flown, , other]) => ({ name, flown, other })),
      (first?.fields ?? []).map(({ name, flown, other }) => ({ name, flown, other })), command);
  }
  before(async () => page && select('eagle2'));
  after(async () => page?.evaluate(() => document.querySelector<HTMLElement>('.what-if header button')?.click()));

  const choose = (type: string) => page.selectOption('select[aria-label="Arbiter of bvr"]', type);
  /** As a person does it, who then goes on. */
  async function write(name: string, value: string): Promise<void> {
    await page.fill(`input[aria-label="${name} in words"]`, value);
    await page.press(`input[aria-label="${name} in words"]`, 'Tab');
  }
  test('another arbiter answers as the program does', { skip: kNoProgram }, async () => {
    await look_at('root/bvr');
    for (const type of ['winner_takes_all', 'fusion', 'priority', 'weighted_random']) {
      await choose(type);
      await compare();
    }
    await choose('paper_fusion');
    await write('high_vote', '50');
    await compare();
    await choose('verify');
    await write('bounds', '{altitude: {max: 29000 ft}}');
    await compare();
    await shoot(page, 'what-if-verify');
    await choose('commitment');
    for (const [name, value] of [['margin', '20'], ['min_time', '5 s'], ['hold', '3 s']] as const) {
      await write(name, value);
      await compare();
    }
  });
  test('another vote, and another parameter of a behavior, answer as the program does', { skip: kNoProgram }, async () => {
    await page.click('.what-if header button');
    await look_at('root/bvr/follow_lead');
    await write('vote', '45');
    await compare();
    await page.click('.what-if header button');
    await look_at('root/bvr/survive/break_turn');
    await write('danger_range', '9 nmi');
    await compare();
    await shoot(page, 'what-if');
  });
  test('a mistake is answered in the words of the terminal', { skip: kNoProgram }, async () => {
    await page.click('.what-if header button');
    await look_at('root/bvr/follow_lead');
    await write('vote', '45 nmi');
    await answer();
    assert.match((await page.textContent('.what-if .caution'))!, /vote: .*nmi/);
  });
  test('what is asked anew is said at once, and the answer before is marked as one', { skip: kNoProgram }, async () => {
    const asked = (vote: string): Promise<(string | boolean)[]> => page.evaluate(async (text) => {
      const field = document.querySelector<HTMLInputElement>('.details input[aria-label="vote in words"]')!;
      field.value = text;
      field.dispatchEvent(new Event('change', { bubbles: true }));
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      const panel = document.querySelector('.what-if')!;
      const is_there = (selector: string): boolean => panel.querySelector(selector) !== null;
      return [panel.textContent!.includes('asking …'), is_there('.caution'), is_there('.old .verdict'), is_there('.future')];
    }, vote);
    assert.deepEqual(await asked('44'), [true, false, false, false]);
    await answer();
    assert.deepEqual(await asked('43'), [true, false, true, false]);
    await answer();
    assert.ok(await page.$('.what-if .future'));
    assert.equal(await page.$('.what-if .old'), null);
  });
  test('flies on from now with the change, and says how it ends', { skip: kNoProgram }, async () => {
    await write('vote', '45');
    await answer();
    await page.click('.future button');
    await page.waitForSelector('.future [data-outcome]');
    assert.match(await page.textContent('.future'), /as flown.*blue home at \d+:\d\d.*with it from 08:00/s);
  });
  test('the other future flies beside the one that was flown, to the end of either', { skip: kNoProgram }, async () => {
    const rows = () => page.$$eval('.row.leader', (all) => all.map((row) => (row as HTMLElement).dataset['row']));
    const end = () => page.evaluate(() => window.eyrie!.store.get().end);
    const scene = () => page.at_rest('.scene');
    const told = await page.textContent('.future');
    const ends = [...told.matchAll(/at (\d+):([\d.]+)/g)].map(([, minutes, seconds]) => 60 * Number(minutes) + Number(seconds));
    assert.equal(ends.length, 2, told);
    assert.ok(Math.abs((await end()) - Math.max(...ends)) < 0.06, `${await end()} s`);
    assert.ok((await rows()).includes('leader flown on'));
    await without_labels(page);
    // where it goes with it and where without
    const both = async (time: number): Promise<boolean> => {
      await go_to(time);
      await page.mouse.move(5, 5);
      const with_it = await scene();
      await shoot(page, `flown-on-${time}`);
      await page.click('.future button:last-child');
      // what comes under the pointer is not meant
      await page.mouse.move(5, 5);
      assert.ok(!(await rows()).includes('leader flown on'));
      return (await scene()).equals(with_it);
    };
    assert.ok(await both(479), 'it is drawn before the two part');
    await go_to(480);
    await page.click('.future button');
    await page.waitForSelector('.future [data-outcome]');
    assert.ok(!(await both(540)), 'nothing is drawn of it');
    await go_to(480);
  });
  test('the other future stays where the panel that asked for it is hidden', { skip: kNoProgram }, async () => {
    await page.click('.future button');
    await page.waitForSelector('.future [data-outcome]');
    await page.click('button[aria-label="Hide: Decision"]');
    await page.waitForTimeout(200);
    assert.ok(await page.$('[data-row="leader flown on"]'), 'it is gone');
    await page.click('button[aria-label="Show: Decision"]');
    await page.waitForSelector('.future [data-outcome]');
  });
  test('and the others can be looked at in it', { skip: kNoProgram }, async () => {
    await select('eagle1');
    await page.waitForSelector('.future [data-outcome]');
    assert.ok(await page.$('[data-row="leader flown on"]'), 'it is gone');
    await select('eagle2');
    assert.equal(await page.textContent('.future button'), 'fly on from here with it', 'moved while its answer is awaited');
    await answer();
  });
  test('it is stopped while it is flown, and can be flown again', { skip: kNoProgram }, async () => {
    const left = await page.evaluate(async () => {
      for (const button of ['.future button', '.future .late']) {
        document.querySelector<HTMLElement>(button)!.click();
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      }
      return document.querySelector('.future')!.textContent;
    });
    assert.equal(left, 'fly on from here with it');
    await page.click('.future button');
    await page.waitForSelector('.future [data-outcome]');
  });
  test('is as flown again after a reset', async () => {
    await page.$eval('.what-if header button', (e) => e.scrollIntoView({ block: 'center' }));  // out from under a title
    await page.click('.what-if header button');
    await page.waitForFunction(() => document.querySelector<HTMLElement>('[data-decisions]')!.dataset['decisions'] === '');
  });
});

describe('the keyboard', { skip: kNoPage }, () => {
  // a button that was clicked would keep the space bar
  before(async () => page?.evaluate(() => (document.activeElement as HTMLElement | null)?.blur()));
  const index_now = () => page.evaluate(() => {
    const { run, store } = window.eyrie!;
    const shown = document.querySelector<HTMLElement>('[data-player][data-step]')!.dataset['step'];
    return run.players[store.get().selected]!.decisions.step.indexOf(Number(shown));
  });
  test('steps from decision to decision', async () => {
    await page.keyboard.press('2');
    await go_to(480);
    const began = await index_now();
    for (const [key, index] of [['ArrowRight', 1], ['ArrowRight', 2], ['ArrowLeft', 1]] as const) {
      await page.keyboard.press(key);
      await settled();
      assert.equal(await index_now(), began + index, key);
    }
  });
  test('steps to where somebody else leads, and to events', async () => {
    await go_to(480);
    const was = (await inspector())['leader'];
    await page.keyboard.press('}');
    await settled();
    assert.notEqual((await inspector())['leader'], was);
    const before_event = await time_now();
    await page.keyboard.press(']');
    assert.ok((await time_now()) > before_event);
  });
  test('selects players, plays, and changes theme and camera', async () => {
    await page.keyboard.press('1');
    await settled();
    assert.equal((await inspector())['player'], await page.evaluate(() => window.eyrie!.run.players[0]!.name));
    await page.keyboard.press(' ');
    assert.equal(await page.evaluate(() => window.eyrie!.store.get().playing), true);
    await page.keyboard.press(' ');
    const { theme, camera } = await page.evaluate(() => window.eyrie!.store.get());
    await page.keyboard.press('t');
    await page.keyboard.press('c');
    const now = await page.evaluate(() => window.eyrie!.store.get());
    assert.notEqual(now.theme, theme);
    assert.notEqual(now.camera, camera);
    assert.equal(await page.evaluate(() => document.documentElement.dataset['theme']), now.theme);
    await page.keyboard.press('t');
  });
});

test('the address leads back to the same moment', { skip: kNoPage }, async () => {
  await select('eagle2');
  await go_to(587.3);
  await page.waitForFunction(() => location.hash.includes('t=587.3') && location.hash.includes('p=eagle2'));
  const again = await open_page(browser, { fragment: await page.evaluate(() => location.hash), theme: 'dark', width: 3840, height: 2160 });
  const { time, selected } = await again.page.evaluate(() => window.eyrie!.store.get());
  assert.deepEqual([time, selected], [587.3, await page.evaluate(() => window.eyrie!.store.get().selected)]);
  await shoot(again.page, 'moment-dark-3840');
  assert.deepEqual(again.complaints, []);
  await again.page.close();
});

describe('two runs on one page', { skip: kNoProgram }, () => {
  const folder = scratch_folder();

  test('part where the program says, at one clock', async () => {
    const { file, parting } = await two_runs(folder, ['trees.bvr.per_field.release_weapon.zone=1']);
    const who = /^(\w+): (\w+) leads\b.*? and (\w+) leads\b.* in the other$/.exec(parting.text);
    assert.ok(who, parting.text);
    const two = await open_file(browser, file, { fragment: `#p=${who[1]}`, width: 1600, height: 900 });
    assert.doesNotMatch(await two.page.textContent('.parting'), /alike|same/, 'nobody knows while they are being flown');
    await two.page.waitForSelector('body[data-ready=true]');
    assert.deepEqual([await two.page.evaluate(() => window.eyrie!.runs.length), (await two.page.$$('.stage canvas')).length >= 2], [2, true]);
    assert.deepEqual(await two.page.$$eval('.about .own', (all) => all.map((one) => one.textContent)), ['release_weapon.zone=1']);
    const told = await two.page.$eval('[data-divergence-step]', (e) => ({ step: (e as HTMLElement).dataset['divergenceStep'], text: e.textContent! }));
    assert.equal(told.step, String(parting.step));
    assert.ok(told.text.includes(who[2]!) && told.text.includes(who[3]!), told.text);
    await two.page.click('[data-divergence-step] button');
    assert.ok(Math.abs((await two.page.evaluate(() => window.eyrie!.store.get().time)) - parting.time_s) < 0.2);
    // of a quantity both, and how far they are apart
    await two.page.evaluate(() => {
      const { store } = window.eyrie!;
      store.set({ time: 530, layers: { ...store.get().layers, labels: true } });
    });
    assert.ok(Number.isFinite(Number(await two.page.$eval('[data-apart]', (e) => (e as HTMLElement).dataset['apart']))));
    await shoot(two.page, 'two-runs');
    const button = await two.page.$('button[title^="One picture"]');
    await button!.click();
    assert.equal((await two.page.$$('.stage')).length, 1);
    await two.page.at_rest('.scene');
    assert.match(await two.page.evaluate(() => window.eyrie!.scene.svg()), />(lost, )?B</, 'who of the other run is elsewhere has its letter');
    await shoot(two.page, 'two-runs-ghosts');
    assert.deepEqual(two.complaints, []);
    await two.page.close();
  });
});

test('nothing was complained of and nothing asked for elsewhere', { skip: kNoPage }, () => assert.deepEqual(opened.complaints, []));
