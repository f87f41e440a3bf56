// SPDX-License-Identifier: MIT
// Pictures of the debrief page at ten moments, of runs that it flies itself: node test/shots.mjs PROGRAM FOLDER [WORD...] makes
// FOLDER/MOMENT-WIDTH-THEME.png of all whose names hold a WORD; node test/shots.mjs PROGRAM --docs those of docs/images (with pngquant).
import { build } from 'esbuild';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [program, out, ...words] = process.argv.slice(2);
if (!out) {
  console.error('usage: node test/shots.mjs PROGRAM FOLDER [WORD...], or PROGRAM --docs');
  process.exit(2);
}

const kHeights = { 390: 844, 800: 1100, 1280: 800, 1920: 1080, 3840: 2160 };
const kRuns = {
  sweep: [['sweep_phases']], merge: [['merge']], convoy: [['convoy']], lead: [['lead_succession']], two: [['sweep_phases'], ['sweep_phases', '--seed', '7']],
};

/** To the decision that the first such line of the story comes of. */
const at_line = (kind, end = '') => (page) => page.evaluate(([k, e]) => {
  const { run, store } = window.eyrie;
  const { decided, decider } = run.story.find((line) => line.kind === k && line.text.endsWith(e) && line.t > 1);
  store.set({ time: decided, ...(decider >= 0 && { selected: decider }) });
}, [kind, end]);
const with_view = (view) => (page) => page.evaluate((patch) => window.eyrie.store.set(patch), view);
/** In a narrow window it is a sheet of its own. */
const decision = async (page) => {
  const closed = await page.$('button[aria-label="Show: Decision"]');
  if (closed) await closed.click();
};
const into_view = (selector) => (page) => page.$eval(selector, (e) => e.scrollIntoView({ block: 'start' }));
/** When everybody is nearest to everybody of the other side. */
const densest = (page) => page.evaluate(() => {
  const { run, store } = window.eyrie;
  let best = [Infinity, 0];
  for (let t = 0; t < run.about.duration; t += 0.5) {
    const there = run.players.filter((p) => p.born <= t && t < p.gone).map(({ side, motion }) => {
      const i = motion.t.findLastIndex((one) => one <= t);
      return { side, e: motion.east[i], n: motion.north[i] };
    });
    const apart = there.flatMap((a) => there.filter((b) => b.side > a.side).map((b) => Math.hypot(a.e - b.e, a.n - b.n)));
    const mean = apart.reduce((a, b) => a + b, 0) / apart.length;
    if (mean < best[0]) best = [mean, t];
  }
  store.set({ time: best[1] });
});

const what_if = async (page) => {
  await page.evaluate(() => window.eyrie.store.set({ time: 480, selected: window.eyrie.run.players.findIndex((p) => p.name === 'eagle2') }));
  await decision(page);
  await page.click('[data-path="root/bvr"]');
  await page.selectOption('select[aria-label="Arbiter of bvr"]', 'fusion');
  await page.waitForSelector('.verdict');
  await page.at_rest('.inspector');
  await into_view('.what-if')(page);
};

const kMoments = {
  opening: ['sweep'],
  'first-shot': ['sweep', at_line('launch'), with_view({ camera: 'follow' })],
  break: ['sweep', at_line('defend'), with_view({ camera: 'follow' }), decision],
  'lead-change': ['lead', at_line('lead_change')],
  merge: ['merge', densest],
  loss: ['sweep', at_line('kill'), with_view({ camera: 'top' })],
  'what-if': ['sweep', what_if],
  'two-runs': ['two', with_view({ time: 560 })],
  'state-machine': ['sweep', at_line('phase', 'wvr'), decision],
  end: ['sweep', (page) => page.keyboard.press('End')],
  convoy: ['convoy', with_view({ time: 330, selected: 0 })],
};
/** In docs/images: the moment, its size and theme, and what of it is shown. */
const kDocs = {
  'first-shot': { moment: 'first-shot', width: 1280, height: 800, theme: 'light' },
  'loss': { moment: 'loss', width: 1280, height: 800, theme: 'light' },
  'state-machine': { moment: 'state-machine', width: 1280, height: 800, theme: 'light' },
  'what-if': { moment: 'what-if', width: 1280, height: 800, theme: 'dark' },
  'two-runs': { moment: 'two-runs', width: 1280, height: 800, theme: 'dark' },
  'narrow': { moment: 'loss', width: 390, height: 844, theme: 'light' },
};

const scratch = mkdtempSync(join(tmpdir(), 'eyrie-shots-'));
process.env.EYRIE_VIEWER_FOLDER = dirname(here);
const code = join(scratch, 'browsers.mjs');
await build({ entryPoints: [join(here, 'browsers.ts')], outfile: code, bundle: true, platform: 'node', format: 'esm', external: ['puppeteer-core'], logLevel: 'warning' });
const { launch, open_url } = await import(pathToFileURL(code).href);

const pages = new Map();
function page_of(name) {
  if (!pages.has(name)) {
    const folders = kRuns[name].map((args, i) => {
      const folder = join(scratch, `${name}${i}`);
      execFileSync(resolve(program), ['fly', ...args, '--quiet', '--no-debrief', '--out', folder], { cwd: dirname(dirname(here)) });
      return folder;
    });
    const file = join(scratch, `${name}.html`);
    execFileSync(resolve(program), ['debrief', ...folders, '--out', file]);
    pages.set(name, file);
  }
  return pages.get(name);
}

async function shoot(browser, moment, width, height, theme) {
  const [run, ...steps] = kMoments[moment];
  const { page, complaints } = await open_url(browser, pathToFileURL(page_of(run)).href, { width, height, theme });
  await page.waitForSelector('body[data-ready=true]');
  for (const step of steps) await step(page);
  await page.waitForTimeout(300);
  await page.at_rest('.page');
  const picture = await page.screenshot();
  await page.close();
  if (complaints.length) throw new Error(`${moment}: ${complaints.join('\n')}`);
  return picture;
}

const browser = await launch('chromium');
try {
  if (out === '--docs') {
    for (const [name, { moment, width, height, theme }] of Object.entries(kDocs)) {
      const picture = await shoot(browser, moment, width, height, theme);
      const file = join(here, '../../docs/images', `${name}.png`);
      writeFileSync(file, execFileSync('pngquant', ['--speed', '1', '--strip', '128', '-'], { input: picture, maxBuffer: 1 << 26 }));
    }
  } else {
    mkdirSync(out, { recursive: true });
    for (const moment of Object.keys(kMoments))
      for (const [width, height] of Object.entries(kHeights))
        for (const theme of ['light', 'dark']) {
          const name = `${moment}-${width}-${theme}`;
          if (words.length && !words.some((word) => name.includes(word))) continue;
          writeFileSync(join(out, `${name}.png`), await shoot(browser, moment, Number(width), height, theme));
        }
  }
} finally {
  await browser.close();
  rmSync(scratch, { recursive: true, force: true });
}
