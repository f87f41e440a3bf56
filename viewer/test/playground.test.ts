// SPDX-License-Identifier: MIT
/** The playground as a person uses it, in both browsers, from disk, against what the program says of the same text and seed. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { deflateSync, inflateSync } from 'node:zlib';
import type { Browser } from 'puppeteer-core';
import { kBrowsers, launch, open_url, type Opened, type UserPage } from './browsers.ts';

const { env } = process;
const kPlayground = env['EYRIE_PLAYGROUND'] ?? '';
const kProgram = env['EYRIE_PROGRAM'] ?? '';
const kHome = join(env['EYRIE_VIEWER_FOLDER'] ?? '', '..');
const kNone = kPlayground && kProgram ? false : 'EYRIE_PLAYGROUND or EYRIE_PROGRAM is not set: no playground to open';
const kUrl = pathToFileURL(join(kPlayground, 'index.html')).href;
const kSweep = 'scenarios/sweep.yaml';
/** As long as one can be. */
const kSeed = '18446744073709551615';

/** The hash that the program gives for a text of a scenario and a seed. */
async function flown_by_program(text: string, seed: string): Promise<string> {
  const folder = mkdtempSync(join(tmpdir(), 'eyrie-playground-'));
  try {
    cpSync(join(kHome, 'scenarios/packages'), join(folder, 'packages'), { recursive: true });
    writeFileSync(join(folder, 'sweep.yaml'), text);
    const { stdout } = await promisify(execFile)(kProgram, ['fly', 'sweep.yaml', '--seed', seed, '--json', '--no-debrief', '--out', 'run'], { cwd: folder, env: { ...env, EYRIE_HOME: kHome } });
    return (JSON.parse(stdout) as { hash: string }).hash;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const link = (value: object): string => `#s=${deflateSync(JSON.stringify(value)).toString('base64url')}`;

const open = async (browser: Browser, fragment = ''): Promise<Opened> => {
  const opened = await open_url(browser, kUrl + fragment, { width: 1440, height: 900 });
  await opened.page.waitForSelector('body[data-open=true]');
  await reads(opened.page);
  return opened;
};
/** Until the loader has read what the text is now. */
async function reads(page: UserPage): Promise<void> {
  await page.waitForFunction(() => document.querySelector('.problems')?.getAttribute('data-state') === 'reading', null, { timeout: 500 }).catch(() => {});
  await page.waitForSelector('.problems:not([data-state=reading])');
}
const problems = (page: UserPage): Promise<string[]> => page.$$eval('.problem', (all) => all.map((one) => one.textContent!));
/** Puts the cursor at the end of the first line that holds `text`, and types. */
async function type_behind(page: UserPage, text: string, typed: string): Promise<void> {
  const line = await page.evaluateHandle((wanted) => {
    const lines = [...document.querySelector('.editor')!.shadowRoot!.querySelectorAll<HTMLElement>('.cm-line')];
    return lines.find((one) => one.textContent!.includes(wanted))!;
  }, text);
  await line.click();
  await page.keyboard.press('End');
  await page.keyboard.type(typed);
}
const marked = (page: UserPage): Promise<string[]> =>
  page.$eval('.editor', (editor) => [...editor.shadowRoot!.querySelectorAll('.cm-lintRange-error')].map((one) => one.textContent!));
const text_now = (page: UserPage): Promise<string> =>
  page.$eval('.editor', (editor) => [...editor.shadowRoot!.querySelectorAll('.cm-line')].map((one) => one.textContent!).join('\n'));
async function fly(page: UserPage, seed: string): Promise<string> {
  const before = await page.$$eval('.last', (all) => all.map((one) => one.getAttribute('data-hash')));
  await page.fill('[aria-label=Seed]', seed);
  await page.click('.top .fly');
  await page.waitForFunction((old) => {
    const hash = document.querySelector('.last')?.getAttribute('data-hash');
    return hash && hash !== old;
  }, before[0] ?? null);
  return page.$eval('.last', (last) => last.getAttribute('data-hash')!);
}
const golden = (): string[] => /^sweep seed (\d+)[^]*?hash (\w+)/m.exec(readFileSync(join(kHome, 'tests/determinism/golden_runs.txt'), 'utf8'))!.slice(1);

for (const where of Object.keys(kBrowsers) as (keyof typeof kBrowsers)[])
  describe(`in ${where}`, { skip: kNone }, () => {
    let browser: Browser;
    let opened: Opened;
    let page: UserPage;
    before(async () => {
      browser = await launch(where);
      opened = await open(browser);
      page = opened.page;
    });
    after(async () => browser?.close());

    test('a scenario stands there without a mistake, and flies to the golden world', async () => {
      assert.deepEqual(await problems(page), []);
      const [seed, hash] = golden();
      assert.equal(await fly(page, seed!), hash);
      const [blue, red] = await page.$$eval('.tally tbody tr', (rows) => rows.map((row) => [...row.querySelectorAll('td')].map((cell) => Number(cell.textContent))));
      assert.equal(blue![0], red![1], 'what blue killed red lost');
      assert.ok((await page.$$('.results .told')).length > 20, 'there is no story');
    });

    test('a mistake is said with line, column and the nearest name while it is typed, and is marked', async () => {
      await type_behind(page, 'aircraft: f15c', 'x');
      await reads(page);
      const line = readFileSync(join(kHome, kSweep), 'utf8').split('\n').findIndex((one) => one.includes('aircraft: f15c')) + 1;
      assert.deepEqual(await problems(page), [`${kSweep}:${line}:17 unknown aircraft 'f15cx'; did you mean 'f15c'?`]);
      // the mark follows in the next picture
      await page.waitForFunction(() => document.querySelector('.editor')!.shadowRoot!.querySelector('.cm-lintRange-error') !== null);
      assert.deepEqual(await marked(page), ['f15cx']);
      assert.equal(await page.$eval('.top .fly', (button) => (button as HTMLButtonElement).disabled), true);
      await page.keyboard.press('Backspace');
      await reads(page);
      assert.deepEqual(await problems(page), []);
    });

    test('keys, names and units are proposed and taken', async () => {
      const proposed = (): Promise<string[]> => page.$eval('.editor', (editor) => [...editor.shadowRoot!.querySelectorAll('.cm-completionLabel')].map((one) => one.textContent!));
      const until_proposed = (label: string) => page.waitForFunction((wanted) => [...document.querySelector('.editor')!.shadowRoot!.querySelectorAll('.cm-completionLabel')].some((one) => one.textContent === wanted), label);
      await type_behind(page, 'bingo: 2200', '\nfue');
      await until_proposed('fuel');
      assert.ok(!(await proposed()).includes('navigate'), 'nodes are proposed where flights have their keys');
      // what was proposed a moment ago may be taken
      await new Promise((done) => setTimeout(done, 200));
      await page.keyboard.press('Enter');
      await page.keyboard.type('0.9');
      assert.ok((await text_now(page)).includes('fuel: 0.9'));
      for (let i = 0; i < 3; ++i) await page.keyboard.press('Backspace');
      await page.keyboard.type('4000 k');
      await until_proposed('kg');
      await new Promise((done) => setTimeout(done, 200));
      await page.keyboard.press('Enter');
      assert.ok((await text_now(page)).includes('fuel: 4000 kg'), await text_now(page));
      await reads(page);
      assert.deepEqual(await problems(page), []);
    });

    test('what was edited flies with a seed to the world to which the program flies it', async () => {
      const text = readFileSync(join(kHome, kSweep), 'utf8').replace('bingo: 2200 kg\n', 'bingo: 2200 kg\n      fuel: 4000 kg\n');
      assert.equal(await fly(page, kSeed), await flown_by_program(text, kSeed));
      assert.equal((await page.$$('.flights tbody tr')).length, 2);
    });

    test('a link brings the edit and the seed back, and flies nothing of its own', async () => {
      await page.$$eval('.top button', (all) => all.find((one) => one.textContent === 'Share')!.click());
      await page.waitForFunction(() => location.hash.startsWith('#s='));
      const other = await open(browser, await page.evaluate(() => location.hash));
      assert.ok((await text_now(other.page)).includes('fuel: 4000 kg'));
      assert.equal(await other.page.$eval('[aria-label=Seed]', (field) => (field as HTMLInputElement).value), kSeed);
      assert.equal(await other.page.$('.last'), null);
      assert.deepEqual(other.complaints, []);
      await other.page.close();
    });

    test('a link opens on a file of its scenario, and what is said of it goes when that changes', async () => {
      const edits = { 'scenarios/packages/veteran.yaml': '# of another scenario\n' };
      const { page: other, complaints } = await open(browser, link({ v: 1, scenario: 'scenarios/notch.yaml', edits }));
      assert.equal(await other.$eval('.tabs [aria-pressed=true]', (one) => one.getAttribute('data-file')), 'scenarios/notch.yaml');
      const says = (wanted: boolean) => other.waitForFunction((words) => (document.querySelector('.top [role=status]')!.textContent !== '') === words, wanted);
      await other.$$eval('.top button', (all) => all.find((one) => one.textContent === 'Share')!.click());
      await says(true);
      await type_behind(other, 'name: notch', ' # by night');
      await says(false);
      await other.fill('[aria-label=Seed]', '12x');
      await other.waitForFunction(() => [...document.querySelectorAll<HTMLButtonElement>('.top button')].find((one) => one.textContent === 'Share')!.disabled);
      assert.deepEqual(complaints, []);
      await other.close();
    });

    test('what no link can hold is told, and no link is given that nobody can open', async () => {
      const line = `# ${'x'.repeat(97)}\n`;
      const filled = (lines: number): object => ({ v: 1, scenario: kSweep, edits: { [kSweep]: `# last\n${line.repeat(lines)}` } });
      // as large as a link may be, but for less than a line
      const fragment = link(filled(Math.floor((1_000_000 - JSON.stringify(filled(0)).length) / JSON.stringify(line).slice(1, -1).length)));
      const { page: other, complaints } = await open(browser, fragment);
      await type_behind(other, '# last', line.trim());
      await reads(other);
      await other.$$eval('.top button', (all) => all.find((one) => one.textContent === 'Share')!.click());
      await other.waitForFunction(() => document.querySelector('.top [role=status]')!.textContent === 'The changes are too large for a link.');
      const given = await other.evaluate(() => location.hash.slice('#s='.length));
      assert.ok(inflateSync(Buffer.from(given, 'base64url')).length <= 1_000_000);
      assert.deepEqual(complaints, []);
      await other.close();
    });

    test('a hostile link does nothing but say why it cannot be used', async () => {
      for (const [fragment, why] of [['#s=AAAA', 'damaged'], [link({ v: 1, scenario: 'data/guns/m61.yaml' }), 'scenario is not one'],
        [link({ v: 1, scenario: kSweep, edits: { [kSweep]: 'eyrie: 1 # \ud800' } }), 'damaged']] as const) {
        const { page: other, complaints } = await open(browser, fragment);
        assert.match(await other.$eval('.top [role=status]', (one) => one.textContent!), new RegExp(why));
        assert.equal(await other.evaluate(() => location.hash), fragment, 'whoever has it may mend it');
        assert.deepEqual(complaints, []);
        await other.close();
      }
      const evil = `<img src=x onerror=window.pwned=1><script>window.pwned=1</script>`;
      const { page: other, complaints } = await open(browser, link({ v: 1, scenario: kSweep, edits: { [kSweep]: `name: "${evil}"\n${evil}: [` } }));
      assert.ok((await text_now(other)).includes(evil));
      assert.ok((await problems(other)).length > 0);
      assert.equal(await other.evaluate(() => (window as { pwned?: number }).pwned), undefined);
      assert.equal((await other.$$('img')).length, 0);
      assert.deepEqual(complaints, []);
      await other.close();
    });

    test('the flight is debriefed in the same page, and the edit is still there afterwards', async () => {
      await (await page.find('.does .fly')).click({ count: 2 });
      await page.waitForSelector('body[data-ready=true]');
      assert.equal((await page.$$('.debriefed')).length, 1, 'a second click opens nothing more');
      const hash = await page.evaluate(() => window.eyrie!.run.about.hash);
      assert.equal(hash, await page.$eval('.last', (last) => last.getAttribute('data-hash')));
      assert.ok((await page.$$('.debriefed .player')).length === 6);
      await page.click('.back');
      await page.waitForSelector('.playground');
      assert.equal(await page.$('.debriefed'), null);
      await page.waitForFunction(() => document.activeElement?.textContent === 'Debrief');
      assert.ok((await text_now(page)).includes('fuel: 4000 kg'));
    });

    test('the way back of the browser leads from the debrief to the editor, too', async () => {
      const flights = (await page.$$('.flights tbody tr')).length;
      await page.click('.does .fly');
      await page.waitForSelector('body[data-ready=true]');
      await page.evaluate(() => history.back());
      await page.waitForFunction(() => !document.querySelector('.debriefed'));
      // before there is anything of it, too
      await page.click('.does .fly');
      await page.evaluate(() => history.back());
      await page.waitForFunction(() => document.activeElement?.textContent === 'Debrief' && !document.querySelector('.debriefed'));
      assert.equal((await page.$$('.flights tbody tr')).length, flights);
      assert.ok((await text_now(page)).includes('fuel: 4000 kg'));
      // and forward to what was closed nowhere: what was edited since stays
      await type_behind(page, 'fuel: 4000 kg', '  # newer');
      await page.evaluate(() => new Promise<void>((done) => {
        addEventListener('popstate', function came({ state }) {
          if (state !== 'editor') return;
          removeEventListener('popstate', came);
          done();
        });
        history.forward();
      }));
      assert.ok((await text_now(page)).includes('4000 kg  # newer'));
      for (let i = 0; i < '  # newer'.length; ++i) await page.keyboard.press('Backspace');
    });

    test('what is stopped is kept, and can be debriefed', async () => {
      const { page: other, complaints } = await open(browser);
      try {
        await other.evaluate(() => new Promise<void>((done) => {
          const click = (): void => document.querySelector<HTMLButtonElement>('.top .fly')!.click();
          const look = (): void => {
            if (!document.querySelector('.last .progress')) return void requestAnimationFrame(look);
            click();
            done();
          };
          click();
          look();
        }));
        await other.waitForSelector('.last[data-outcome=stopped]');
        await other.click('.does .fly');
        await other.waitForSelector('body[data-ready=true]');
        assert.equal(await other.evaluate(() => window.eyrie!.run.about.hash), await other.$eval('.last', (last) => last.getAttribute('data-hash')));
        assert.deepEqual(complaints, []);
      } finally {
        await other.close();
      }
    });

    test('on the ways back and forward the editor has what the address says', async () => {
      const { page: other, complaints } = await open(browser);
      const shows = (words: string, shown: boolean) => other.waitForFunction(([wanted, is_there]) =>
        [...document.querySelector('.editor')!.shadowRoot!.querySelectorAll('.cm-line')].some((one) => one.textContent!.includes(wanted)) === is_there, [words, shown] as const);
      try {
        await other.evaluate((hash) => { location.hash = hash; }, link({ v: 1, scenario: kSweep, edits: { [kSweep]: 'eyrie: 1  # of the link\n' } }));
        await shows('of the link', true);
        await other.evaluate(() => history.back());
        await shows('of the link', false);
        assert.equal(await other.evaluate(() => location.hash), '');
        await other.evaluate(() => history.forward());
        await shows('of the link', true);
        assert.deepEqual(complaints, []);
      } finally {
        await other.close();
      }
    });

    test('edits are dropped, and had again by the button or by undoing', async () => {
      const press = (label: string) => page.$$eval('.top button', (all, wanted) => all.find((one) => one.textContent === wanted)!.click(), label);
      const until = (edited: boolean) => page.waitForFunction((wanted) => wanted === [...document.querySelector('.editor')!.shadowRoot!.querySelectorAll('.cm-line')].some((one) => one.textContent!.includes('fuel: 4000 kg')), edited);
      await press('as shipped');
      await until(false);
      await press('my changes again');
      await until(true);
      await press('as shipped');
      await until(false);
      await page.$eval('.editor', (editor) => editor.shadowRoot!.querySelector<HTMLElement>('.cm-content')!.focus());
      await page.keyboard.down('Control');
      await page.keyboard.press('z');
      await page.keyboard.up('Control');
      await until(true);
    });

    test('a mistake in another file leads to its line', async () => {
      await page.click('[data-file="scenarios/packages/veteran.yaml"]');
      await page.waitForFunction(() => document.querySelector('.editor')!.shadowRoot!.textContent!.includes('high_yo_yo'));
      await type_behind(page, '- high_yo_yo: {vote: 52}', 'x');
      await page.click(`[data-file="${kSweep}"]`);
      await page.waitForSelector('.problem');
      await page.click('.problem');
      await page.waitForSelector('[data-file="scenarios/packages/veteran.yaml"][aria-pressed=true]');
      assert.match(await page.$eval('.editor', (editor) => editor.shadowRoot!.querySelector('.cm-activeLine')!.textContent!), /high_yo_yo|low_yo_yo/);
    });

    test('dark or light is remembered', async () => {
      const theme = (of: UserPage) => of.evaluate(() => document.documentElement.dataset['theme']);
      const before = await theme(page);
      await page.click('[aria-label=Dark], [aria-label=Light]');
      await page.waitForFunction((old) => document.documentElement.dataset['theme'] !== old, before);
      const other = await open(browser);
      assert.equal(await theme(other.page), await theme(page));
      await other.page.close();
    });

    test('nothing was complained of, and nobody was asked for anything', () => assert.deepEqual(opened.complaints, []));
  });
