// SPDX-License-Identifier: MIT
// How fast the debrief page opens and plays, in headless Chromium without a graphics card: ./eyrie bench page.
// usage: node bench/page.mjs PROGRAM   a program that has its page beside it; CHROMIUM=/usr/bin/chromium
import { execFileSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const [program] = process.argv.slice(2);
const { default: puppeteer } = await import(createRequire(join(root, 'viewer/package.json')).resolve('puppeteer-core'));
const executablePath = process.env['CHROMIUM'] ?? '/usr/bin/chromium';
const args = ['--no-sandbox', '--disable-dev-shm-usage'];
/** ms that are played, and how often a page is opened. */
const [kPlayed, kOpened] = [5000, 5];

/** A hundred against a hundred, flight by flight, for ten minutes. */
function war() {
  const letters = [...'abcdefghijklmnopqrstuvwxy'];
  const flight = (side, letter, k) => {
    const [aircraft, east, to, heading] = side === 'e' ? ['f15c', -60, 20, 90] : ['mig29', 60, -20, 270];
    const north = -48 + 4 * k;
    return `    ${side}_${letter}:
      {aircraft: ${aircraft}, tree: sweep, players: [${[1, 2, 3, 4].map((i) => `${side}_${letter}${i}`)}], bingo: 1500 kg,
       start: {north: ${north} nmi, east: ${east} nmi, altitude: ${24000 + 300 * k} ft, heading: ${heading} deg, speed: 480 kt},
       formation: {abreast: 6000 ft, behind: 1000 ft, below: 500 ft},
       route: [{north: ${north} nmi, east: ${to} nmi, altitude: 25000 ft, speed: 480 kt}, {north: ${north} nmi, east: ${east} nmi}]}`;
  };
  const side = (name, letter, home) => `${name}:
  home: {north: 0 nmi, east: ${home} nmi}
  flights:\n${letters.map((l, k) => flight(letter, l, k)).join('\n')}`;
  return `eyrie: 1\nname: war\nhelp: 100 against 100\ninclude: packages/pilots.yaml\nreference: {latitude: 33 deg, longitude: -68 deg}
seed: 1\nuntil: 10 min\nends: time\n${side('blue', 'e', -130)}\n${side('red', 'b', 130)}\n`;
}

const rest = (ms) => new Promise((done) => setTimeout(done, ms));
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const shown = (ms) => `${(ms / 1000).toFixed(2)} s`;

async function with_page(url, size, use) {
  const browser = await puppeteer.launch({ headless: true, executablePath, args, defaultViewport: size });
  try {
    const page = await browser.newPage();
    await page.goto(url, { waitUntil: 'domcontentloaded' });
    await page.waitForSelector('body[data-ready=true]', { timeout: 120_000 });
    return await use(page, browser);
  } finally {
    await browser.close();
  }
}

/** MB that the process of the page keeps, with its worker and what it shares with nobody. */
async function memory(browser) {
  const session = await browser.target().createCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const kept = processInfo.filter(({ type }) => type === 'renderer')
    .map(({ id }) => Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${id}/smaps_rollup`, 'utf8'))[1]) / 1000);
  return Math.max(...kept);
}

/** From the beginning of the navigation: until the first picture is there, and until the whole run has been flown. */
async function opening(name, url) {
  const [pictures, wholes, sizes] = [[], [], []];
  for (let i = 0; i < kOpened; ++i)
    await with_page(url, { width: 1280, height: 720 }, async (page, browser) => {
      const after = (what) => page.evaluate((one) => performance.getEntriesByName(one)[0].duration, what);
      pictures.push(await after('eyrie-picture'));
      wholes.push(await after('eyrie-open'));
      sizes.push(await memory(browser));
    });
  console.log(`opens/${name.padEnd(28)} first picture median ${shown(median(pictures))} best ${shown(Math.min(...pictures))}   ` +
    `whole run median ${shown(median(wholes))} best ${shown(Math.min(...wholes))}   memory ${median(sizes).toFixed(0)} MB   ` +
    `page ${(statSync(fileURLToPath(url)).size / 1e6).toFixed(2)} MB`);
}

/** Pictures that the browser's trace says were drawn while the page played from `t`. */
async function playing(name, url, t, size = { width: 1280, height: 720 }) {
  await with_page(`${url}#t=${t}`, size, async (page) => {
    await rest(2000);
    const session = await page.createCDPSession();
    const events = [];
    session.on('Tracing.dataCollected', ({ value }) => events.push(...value));
    await session.send('Tracing.start', {
      transferMode: 'ReportEvents', traceConfig: { includedCategories: ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline.frame', 'devtools.timeline.frame'] },
    });
    await page.evaluate(() => window.eyrie.store.set({ playing: true }));
    await rest(kPlayed);
    await page.evaluate(() => window.eyrie.store.set({ playing: false }));
    const complete = new Promise((done) => session.once('Tracing.tracingComplete', done));
    await session.send('Tracing.end');
    await complete;
    const main = events.find((e) => e.name === 'thread_name' && e.args.name === 'CrRendererMain');
    const mine = (e) => e.pid === main.pid && e.tid === main.tid;
    const busy = events.filter((e) => mine(e) && e.name.endsWith('RunTask') && e.dur && e.tdur).reduce((sum, e) => sum + e.tdur / 1000, 0);
    const drawn = events.filter((e) => e.pid === main.pid && e.name === 'DrawFrame').map((e) => e.ts / 1000).sort((a, b) => a - b);
    const waits = drawn.slice(1).map((t, i) => t - drawn[i]);
    console.log(`plays/${name.padEnd(28)} ${((1000 * drawn.length) / kPlayed).toFixed(1).padStart(5)} pictures/s   ` +
      `${(busy / drawn.length).toFixed(1)} ms processor time each   longest wait ${Math.max(...waits).toFixed(0)} ms`);
  });
}

const folder = mkdtempSync(join(tmpdir(), 'eyrie-bench-'));
try {
  const fly = (scenario, out) => {
    execFileSync(program, ['fly', scenario, '--quiet', '--out', join(folder, out)], { cwd: root, stdio: ['ignore', 'ignore', 'inherit'] });
    return pathToFileURL(join(folder, out, 'debrief.html')).href;
  };
  const sweep = fly('sweep', 'sweep');
  await opening('sweep', sweep);
  await playing('sweep', sweep, 560);
  await playing('sweep/4k', sweep, 560, { width: 3840, height: 2160 });
  cpSync(join(root, 'scenarios/packages'), join(folder, 'packages'), { recursive: true });
  writeFileSync(join(folder, 'war.yaml'), war());
  const many = fly(join(folder, 'war.yaml'), 'war');
  await opening('200 aircraft', many);
  await playing('200 aircraft/ingress', many, 100);
  await playing('200 aircraft/fight', many, 460);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
