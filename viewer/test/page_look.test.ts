// SPDX-License-Identifier: MIT
/** What is shown, and in which form: state machines, trees that fit, units, times that are typed, pictures and films, fingers. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { dirname, join } from 'node:path';
import { describe, test } from 'node:test';
import { promisify } from 'node:util';
import type { Browser } from 'puppeteer-core';
import type { UserPage } from './browsers.ts';
import { kNoPage, kNoProgram, kPageFile, kProgram, kWhere, on_page, open_file, open_page, scratch_folder, shoot, with_page } from './page_kit.ts';

let page: UserPage;
let browser: Browser;
with_page({ fragment: '#t=480&p=eagle1', height: 900 }, (opened, launched) => {
  ({ page } = opened);
  browser = launched;
});

const scratch = scratch_folder();

async function go_to(time: number, player = 0): Promise<void> {
  await page.evaluate(([t, p]) => window.eyrie!.store.set({ time: t!, selected: p!, playing: false }), [time, player] as const);
}
const machine = () => page.$eval('.machine', (e) => ({ ...(e as HTMLElement).dataset }));

describe('a sequencer', { skip: kNoPage }, () => {
  test('is a state machine: its state, its transitions by name, and the one that fires', async () => {
    await go_to(480);
    assert.deepEqual([(await machine())['state'], (await machine())['fired']], ['bvr', '-1']);
    const t = await page.evaluate(() => window.eyrie!.run.story.filter((line) => line.kind === 'phase' && line.text.endsWith('wvr'))[0]!.decided);
    await go_to(t);
    await page.waitForSelector('.machine[data-state=wvr]');
    assert.match(await page.textContent('.rules .now'), /bvr → wvr: in_sight within 8 nmi/);
    assert.equal((await page.$$('.arc.now')).length, 1);
    await shoot(page, 'machine');
  });
  test('leads through its history', async () => {
    const visits = await page.$$eval('.visits button', (all) => all.map((e) => e.textContent!.split(' ')[1]));
    assert.deepEqual(visits.slice(0, 3), ['ingress', 'bvr', 'wvr']);
    await page.click('.visits button:nth-child(2)');
    await page.waitForSelector('.machine[data-state=bvr]');
    assert.notEqual((await machine())['fired'], '-1');
  });
});

test('a tree fits its panel, and a node is found by its name', { skip: kNoPage }, async () => {
  await go_to(560);
  const [wide, room] = await page.$eval('.tree', (e) => [e.scrollWidth, e.clientWidth] as const);
  assert.ok(wide <= room, `${wide} px in ${room}`);
  await page.fill('.find', 'egress/egress');
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-node="root/egress/egress"]');
  assert.ok(await page.$eval('[data-path="root/egress/egress"]', (e) => e.classList.contains('looked')));
});

test('parameters have the units that people read and write, with the engine and without', { skip: kNoProgram }, async () => {
  const file = join(scratch, 'columns.html');
  await promisify(execFile)(kProgram, ['debrief', dirname(kPageFile), '--columns', '--out', file]);
  const told = async (of: UserPage): Promise<string> => {
    await of.click('[data-path="root/bvr/pursue"]');
    return of.textContent('.details[data-node="root/bvr/pursue"] .small');
  };
  const units = /speed 560 kt, .*floor 2000 ft, .*level_range 8 nmi, .*gun_range 8202 ft, .*crank 50°/;
  await on_page(open_file(browser, file, { fragment: '#t=480&p=eagle1' }), async (other) => assert.match(await told(other), units));
  await go_to(480);
  assert.match(await told(page), units);
  const flown = (name: string) => page.$eval(`input[aria-label="${name} in words"]`, (e) => (e as HTMLInputElement).value);
  assert.deepEqual([await flown('level_range'), await flown('crank'), await flown('speed')], ['8 nmi', '50 deg', '560 kt']);
  assert.match(await page.$eval('label:has(> [aria-label="crank in words"])', (e) => (e as HTMLElement).title), /; 0° to \d+°$/);
  await page.fill('input[aria-label="crank in words"]', '60°');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => {
    const { asked, answered } = document.querySelector<HTMLElement>('.what-if')!.dataset;
    return asked !== '' && asked === answered;
  });
  assert.equal(await page.$('.what-if .caution'), null);
  // what was flown is no question
  await page.fill('input[aria-label="crank in words"]', '50 deg');
  await page.keyboard.press('Tab');
  await page.waitForSelector('.what-if[data-asked=""]');
  await page.click('[aria-label="Close the node"]');
});

test('units are metric if somebody wants that, everywhere', { skip: kNoPage }, async () => {
  const value = (field: string) => page.$eval(`[data-field=${field}]`, (e) => (e as HTMLElement).dataset['value']!);
  await go_to(480);
  assert.match(await value('altitude'), / ft$/);
  const tree = await page.evaluateHandle(() => document.querySelector('.tree'));
  await page.evaluate(() => window.eyrie!.store.set({ units: 'metric' }));
  await page.waitForFunction(() => / m$/.test(document.querySelector<HTMLElement>('[data-field=altitude]')?.dataset['value'] ?? ''));
  assert.match(await value('speed'), / km\/h$/);
  assert.match(await value('heading'), /^\d{3}°$/);
  const text = await page.evaluate(() => document.body.innerText);
  assert.doesNotMatch(text, /\d (ft|nmi|kt|lb)\b/);
  assert.ok(await page.evaluate((element) => element!.isConnected, tree), 'the panels are the same');
  await page.waitForFunction(() => location.hash.includes('u=metric'));
  await page.evaluate(() => window.eyrie!.store.set({ units: 'aviation' }));
});

test('who is seen is as far off the nose as his bearing is off the heading', { skip: kNoPage }, async () => {
  await go_to(499.2);
  await page.waitForSelector('.tracks tr.target');
  const off = await page.$$eval('.tracks tbody tr', (rows) => {
    const degrees = (of: Element | null): number => {
      const [size, way] = of!.textContent!.split('°');
      return parseFloat(size!) * (way!.includes('left') ? -1 : 1);
    };
    const heading = degrees(document.querySelector('[data-state=heading] dd'));
    return rows.map((row) => Math.abs(((degrees(row.children[3]!) - heading - degrees(row.children[4]!)) % 360 + 540) % 360 - 180));
  });
  assert.ok(off.length > 0 && off.every((error) => error < 1.6), `${off}`);
  assert.equal(await page.$eval('.tracks tr.target td:nth-child(3)', (cell) => cell.textContent), await page.$eval('[data-state=range] dd', (said) => said.textContent), 'as the crow flies, not on the map');
});

test('how old a sight is is told however young it is', { skip: kNoPage }, async () => {
  await page.evaluate(() => {
    const { run, store } = window.eyrie!;
    const { t } = run.players[0]!.sights;
    const seen = t.findIndex((time) => time > 490);
    const decided = run.players[0]!.decisions.t.find((time) => time >= t[seen]! - 1e-6)!;
    t[seen] = decided - 0.02;
    store.set({ time: decided + 0.01, selected: 0 });
  });
  await page.waitForFunction(() => document.body.textContent!.includes(', 0.02 s before the decision'));
});

test('a time of many hours has room', { skip: kNoPage }, async () => {
  const end = await page.evaluate(() => window.eyrie!.store.get().end);
  await page.evaluate(() => window.eyrie!.store.set({ end: 997_200, time: 997_200 }));
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>('input[aria-label=Time]')!.value === '16620:00.0');
  const [wide, room] = await page.$eval('input[aria-label=Time]', (input) => [input.scrollWidth, input.clientWidth] as const);
  assert.ok(wide <= room, `${wide} px in ${room}`);
  const [reached, next] = await page.$eval('.told time', (time) => {
    const text = document.createRange();
    const said = time.textContent;
    time.firstChild!.nodeValue = '16620:00.0';
    text.selectNodeContents(time);
    const { right } = text.getBoundingClientRect();
    time.firstChild!.nodeValue = said;
    return [right, time.nextElementSibling!.getBoundingClientRect().left] as const;
  });
  assert.ok(reached <= next, `${reached} px, and the glyph begins at ${next}`);
  await page.evaluate((was) => window.eyrie!.store.set({ end: was, time: 500 }), end);
});

test('a time can be typed', { skip: kNoPage }, async () => {
  await page.fill('input[aria-label=Time]', '8:20.5');
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => window.eyrie!.store.get().time), 500.5);
  await page.fill('input[aria-label=Time]', '8:75');
  await page.keyboard.press('Enter');
  assert.equal(await page.textContent('.time [role=alert]'), ' a minute has 60 seconds');
  await page.$eval('input[aria-label=Time]', (e) => (e as HTMLElement).blur());
  assert.equal(await page.$('.time [role=alert]'), null);
});

test('in the end all of it is seen, and who is followed has the opponent beside it', { skip: kNoPage }, async () => {
  const height = () => page.evaluate(() => (window.eyrie!.scene as unknown as { frame: { eye: { stance: { height: number } } } }).frame.eye.stance.height);
  await page.evaluate(() => window.eyrie!.store.set({ time: window.eyrie!.store.get().end, camera: 'whole' }));
  await page.at_rest('.scene');
  // the way there and back is a hundred miles long
  assert.ok((await height()) > 100, `${await height()} km`);
  for (const time of [482.5, 530]) {
    await page.evaluate((t) => window.eyrie!.store.set({ time: t, camera: 'follow' }), time);
    await page.at_rest('.scene');
    assert.ok(await opponent_seen(), `the opponent is out of the picture at ${time} s`);
  }
  await page.evaluate(() => window.eyrie!.store.set({ camera: 'whole' }));
});

function opponent_seen(): Promise<boolean> {
  return page.evaluate(() => {
    const { frame } = window.eyrie!.scene as unknown as { frame: { sight: { now: { tracks: { is_target: boolean; truth: number }[] } }; players: { x: number[]; y: number[]; z: number[] };
      eye: { project(x: number, y: number, z: number): boolean; on_screen(): boolean } } };
    const foe = frame.sight.now.tracks.find((track) => track.is_target)!.truth;
    return frame.eye.project(frame.players.x[foe]!, frame.players.y[foe]!, frame.players.z[foe]!) && frame.eye.on_screen();
  });
}

test('range rings, the bullseye and ways of any length are in the picture if somebody wants them', { skip: kNoPage }, async () => {
  // from so high that all of the way is in the picture
  await page.evaluate(() => window.eyrie!.store.set({ time: 560, camera: 'top', pose: [-40, 0, 0, 400, 0, 0] }));
  await page.at_rest('.scene');
  const drawn = () => page.evaluate(() => {
    const svg = window.eyrie!.scene.svg();
    const said = [...svg.matchAll(/<text [^>]*>([^<]*)</g)].map(([, words]) => words!);
    return { size: svg.length, said, ranges: said.filter((words) => /^[\d.]+ nmi$/.test(words)).length };
  });
  const flip = async () => {
    for (const words of ['range rings', 'bullseye']) await page.$eval(`input[aria-label="Layer ${words}"]`, (e) => (e as HTMLElement).click());
  };
  const without = await drawn();
  assert.ok(!without.said.includes('bullseye'));
  await flip();
  const { said, ranges } = await drawn();
  assert.ok(said.includes('bullseye') && said.some((words) => /^eagle1 \d{3}° [\d.]+ nmi$/.test(words)), `${said}`);
  assert.ok(ranges > without.ranges, `${said}`);
  await flip();
  const sizes: number[] = [];
  for (const trail of ['20', '60', '300', 'Infinity']) {
    await page.selectOption('select[aria-label="Length of the trails"]', trail);
    sizes.push((await drawn()).size);
  }
  assert.ok(sizes.every((size, i) => i === 0 || size > sizes[i - 1]!), `${sizes}`);
  await page.evaluate(() => window.eyrie!.store.set({ camera: 'whole', trail: 60 }));
});

/** What is written in the picture at a time that lies over other writing, or over the buttons. */
function piled(on: UserPage, time: number): Promise<string[]> {
  return on.evaluate((t) => {
    const { store, scene } = window.eyrie!;
    store.set({ time: t });
    scene.picture();
    const { boxes, covered } = (scene as unknown as { frame: { notes: { boxes: number[]; covered: number[] } } }).frame.notes;
    const all = [...boxes, ...covered];
    const out: string[] = [];
    for (let i = 0; i < boxes.length; i += 4)
      for (let k = i + 4; k < all.length; k += 4)
        if (all[i]! < all[k]! + all[k + 2]! && all[i]! + all[i + 2]! > all[k]! && all[i + 1]! < all[k + 1]! + all[k + 3]! && all[i + 1]! + all[i + 3]! > all[k + 1]!)
          out.push(`${all.slice(i, i + 4)} and ${all.slice(k, k + 4)} at ${t} s`);
    return boxes.length > 8 ? out : ['hardly anything is written'];
  }, time);
}

test('no writing of the air picture lies over other writing, in a sweep and in a merge', { skip: kNoPage || kNoProgram }, async () => {
  const merge = join(scratch, 'merge');
  await promisify(execFile)(kProgram, ['fly', 'merge', '--quiet', '--out', merge]);
  for (const file of [kPageFile, join(merge, 'debrief.html')]) {
    await on_page(open_file(browser, file, { width: 900, height: 700 }), async (other) => {
      const [from, to] = await other.evaluate(() => {
        const { story } = window.eyrie!.run;
        const shots = story.filter(({ kind }) => kind === 'launch' || kind === 'kill').map(({ t }) => t);
        return [Math.min(...shots) - 20, Math.max(...shots) + 20] as const;
      });
      for (const camera of ['whole', 'top', 'follow'] as const) {
        await other.evaluate((c) => window.eyrie!.store.set({ camera: c, layers: { ...window.eyrie!.store.get().layers, rings: true, bullseye: true } }), camera);
        for (let t = from; t < to; t += (to - from) / 40) assert.deepEqual(await piled(other, t), [], camera);
      }
    });
  }
});

test('who is home stays where that was, and the grid is told in even steps', { skip: kNoPage }, async () => {
  const words = async (time: number, camera: 'whole' | 'follow') => {
    await page.evaluate(([t, c]) => window.eyrie!.store.set({ time: t, camera: c }), [time, camera] as const);
    await page.at_rest('.scene');
    return page.evaluate(() => [...window.eyrie!.scene.svg().matchAll(/<text [^>]*>([^<]*)</g)].map(([, said]) => said!));
  };
  const at_end = await words(await page.evaluate(() => window.eyrie!.store.get().end), 'whole');
  for (const name of ['eagle1', 'eagle2', 'eagle3', 'eagle4']) assert.ok(at_end.some((said, i) => said === name && at_end[i + 1] === 'home'), `${name} in ${at_end}`);
  for (const time of [300, 482, 500, 530, 560]) {
    const figures = (await words(time, 'follow')).filter((said) => /^[\d.]+ [NESW]$/.test(said));
    assert.ok(figures.length > 3, `${figures} at ${time} s`);
    for (const ways of ['NS', 'EW']) {
      // the middle has no figure, and one that has no room is left out
      const along = figures.filter((said) => ways.includes(said.at(-1)!)).map((said) => parseFloat(said) * (/[SW]/.test(said) ? -1 : 1));
      const row = [...along, ...(Math.min(...along) < 0 && Math.max(...along) > 0 ? [0] : [])].sort((x, y) => x - y);
      const gaps = row.slice(1).map((value, i) => value - row[i]!), step = Math.min(...gaps);
      if (gaps.length === 0) continue;
      assert.ok(gaps.every((gap) => Math.abs(gap / step - Math.round(gap / step)) < 1e-6), `${row} at ${time} s`);
      assert.ok(/^0*[.0]*[125]0*(\.0*)?(e\+\d+)?$/.test(step.toPrecision(2)), `a step of ${step} at ${time} s`);
    }
  }
  await page.evaluate(() => window.eyrie!.store.set({ camera: 'whole' }));
});

describe('saves', { skip: kNoPage }, () => {
  /** Bytes of what the page hands to the browser to be kept. */
  const saved = (index: number) => page.evaluate(async (i) => {
    const blob = (window as unknown as { kept: Blob[] }).kept[i];
    return blob ? { type: blob.type, size: blob.size, head: [...new Uint8Array(await blob.slice(0, 4).arrayBuffer())], text: blob.type.includes('svg') ? await blob.text() : '' } : null;
  }, index);
  const choose = async (words: string): Promise<void> => {
    await page.$$eval('.stage .menu-body button', (all, wanted) => (all.find((e) => e.textContent === wanted) as HTMLElement).click(), words);
  };
  test('pictures as PNG and as SVG, with the names in them', async () => {
    await page.evaluate(() => {
      const kept: Blob[] = [];
      Object.assign(window, { kept });
      URL.createObjectURL = (blob) => `about:blank#${kept.push(blob as Blob)}`;
      HTMLAnchorElement.prototype.click = () => {};
    });
    await choose('picture, PNG');
    await page.waitForFunction(() => (window as unknown as { kept: Blob[] }).kept.length === 1);
    assert.deepEqual((await saved(0))!.head, [0x89, 0x50, 0x4e, 0x47]);
    await choose('picture, SVG');
    const svg = (await saved(1))!.text;
    const [broken, names] = await page.evaluate((text) => {
      const made = new DOMParser().parseFromString(text, 'image/svg+xml');
      return [made.querySelector('parsererror') !== null, [...made.querySelectorAll('text')].map((e) => e.textContent)] as const;
    }, svg);
    assert.ok(!broken && names.includes('eagle1') && !svg.includes('NaN'), svg.slice(0, 400));
  });
  test('a film of what plays', async () => {
    await choose('film from here, WebM');
    await page.waitForSelector('.filming');
    await page.waitForTimeout(1500);
    await page.click('.filming');
    await page.waitForFunction(() => (window as unknown as { kept: Blob[] }).kept.length === 3);
    const film = (await saved(2))!;
    assert.deepEqual(film.head, [0x1a, 0x45, 0xdf, 0xa3]);
    assert.ok(film.size > 10_000, `${film.size} bytes`);
  });
});

test('in a window of any width the picture has its place, and nothing lies outside', { skip: kNoPage }, async () => {
  for (const [width, height] of [[390, 844], [800, 1100], [1280, 800], [1920, 1080], [3840, 2160]] as const) {
    await on_page(open_page(browser, { width, height }), async (other) => {
      const { height: high, width: wide } = await other.box('.scene');
      assert.ok(high > 0.4 * height && wide > 0.45 * width, `the picture has ${wide} x ${high} of ${width} x ${height}`);
      const outside = () => other.$$eval('.top button, .transport button, .transport select, .stage-tools button', (all) => all
        .filter((e) => e.getClientRects().length > 0 && !e.closest('details:not([open])'))
        .filter((e) => e.getBoundingClientRect().right > innerWidth || e.getBoundingClientRect().left < 0).map((e) => e.outerHTML.slice(0, 80)));
      assert.deepEqual(await outside(), [], `${width}`);
      const [left, right] = await other.$eval('.moment[aria-current=true]', (e) => [e.getBoundingClientRect().left, e.getBoundingClientRect().right]);
      assert.ok(left! >= 0 && right! <= width, `the key moment of now reaches from ${left} to ${right} of ${width}`);
      const [writing, rem] = await other.evaluate(() => [parseFloat((window.eyrie!.scene as unknown as { frame: { notes: { context: CanvasRenderingContext2D } } }).frame.notes.context.font),
        parseFloat(getComputedStyle(document.documentElement).fontSize)] as const);
      assert.ok(writing > 0.9 * rem, `${writing} px in the picture, ${rem} px around it, in ${width}`);
      if (width < 900)
        for (const sheet of ['Players and story', 'Decision']) {
          await other.click(`button[aria-label="Show: ${sheet}"]`);
          assert.ok((await other.box('.scene')).height > 0.2 * height, `the picture above ${sheet}`);
          assert.deepEqual(await outside(), [], `${width} with ${sheet}`);
        }
    });
  }
});

test('what a menu says last is reached in a small window, too', { skip: kNoPage }, async () => {
  await on_page(open_page(browser, { width: 720, height: 450 }), async (other) => {
    for (const [menu, last] of [['.about', 'same bits'], ['.stage-tools .menu', 'units']] as const) {
      await other.click(`${menu} > summary`);
      const [words, seen] = await other.$eval(menu, (e) => {
        const line = [...e.querySelectorAll('dl div, label')].at(-1)!;
        line.scrollIntoView({ block: 'nearest' });
        const { left, top, height } = line.getBoundingClientRect();
        return [line.textContent!, line.contains(document.elementFromPoint(left + 5, top + height / 2))] as const;
      });
      assert.ok(words.includes(last) && seen, `${menu}: ${words}`);
      await other.keyboard.press('Escape');
    }
  });
});

test('the air picture is turned and zoomed by keys, too', { skip: kNoPage }, async () => {
  await page.evaluate(() => window.eyrie!.store.set({ camera: 'free', playing: false, time: 480 }));
  await page.at_rest('.scene');
  const pose = () => page.evaluate(() => window.eyrie!.store.get().pose!);
  const [before, time] = [await pose(), await page.evaluate(() => window.eyrie!.store.get().time)];
  await page.press('.scene', 'ArrowRight');
  await page.keyboard.press('+');
  await page.at_rest('.scene');
  const after = await pose();
  assert.ok(after[3] < before[3] && after[4] !== before[4], `${before} to ${after}`);
  assert.equal(await page.evaluate(() => window.eyrie!.store.get().time), time, 'the arrow was not the timeline\'s');
});

test('two fingers zoom, one turns, and one that rests measures', { skip: kNoPage || (kWhere !== 'chromium' && 'fingers are those of Chromium') }, async () => {
  const { x, y, width, height } = await page.box('.scene');
  const [cx, cy] = [x + width / 2, y + height / 2];
  const pose = () => page.evaluate(() => window.eyrie!.store.get().pose!);
  await page.evaluate(() => window.eyrie!.store.set({ camera: 'free', playing: false }));
  await page.at_rest('.scene');
  const before = await pose();
  const [one, two] = [await page.touch.touchStart(cx - 40, cy), await page.touch.touchStart(cx + 40, cy)];
  for (const reach of [60, 80, 100, 120]) {
    await one.move(cx - reach, cy);
    await two.move(cx + reach, cy);
  }
  await one.end();
  await two.end();
  await page.at_rest('.scene');
  const zoomed = await pose();
  assert.ok(zoomed[3] < 0.6 * before[3], `${before[3]} to ${zoomed[3]} km`);
  await page.evaluate(() => window.eyrie!.store.set({ time: 300, selected: 0, ruler: null, camera: 'whole' }));
  await page.at_rest('.scene');
  const mate = await page.evaluate(() => {
    const { frame: { players, eye } } = window.eyrie!.scene as unknown as { frame: { players: { x: number[]; y: number[]; z: number[] }; eye: { px: number; py: number; project(x: number, y: number, z: number): boolean } } };
    eye.project(players.x[1]!, players.y[1]!, players.z[1]!);
    return [eye.px, eye.py] as const;
  });
  const resting = await page.touch.touchStart(x + mate[0], y + mate[1]);
  await page.waitForTimeout(600);
  await resting.end();
  assert.deepEqual(await page.evaluate(() => [window.eyrie!.store.get().ruler, window.eyrie!.store.get().selected]), [[0, 1], 0]);
  await page.evaluate(() => window.eyrie!.store.set({ ruler: null, camera: 'free' }));
  await page.at_rest('.scene');
  const turned = await pose();
  const finger = await page.touch.touchStart(cx, cy);
  for (const way of [20, 40, 80]) await finger.move(cx + way, cy);
  await finger.end();
  await page.at_rest('.scene');
  assert.notEqual((await pose())[4], turned[4]);
});
