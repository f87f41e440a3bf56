// SPDX-License-Identifier: MIT
// What connections cost a mission that is flown by the clock: `eyrie serve` with aircraft that fly to and fro for an hour,
// DIS told to a group, and Chromiums that fly along and draw. One row for each; the program's own words are the figures.
// usage: node bench/exercise.mjs PROGRAM [AIRCRAFT,dis|alone,BROWSERS ...]   EYRIE_BENCH_SECONDS=60; CHROMIUM=/usr/bin/chromium
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const [named, ...asked] = process.argv.slice(2);
const program = resolve(named);  // it is started in another folder
const { default: puppeteer } = await import(createRequire(join(root, 'viewer/package.json')).resolve('puppeteer-core'));
const seconds = Number(process.env['EYRIE_BENCH_SECONDS'] ?? 60);
const rows = asked.length ? asked : ['6,alone,0', '100,alone,0', '100,dis,0', '100,dis,1', '100,dis,3', '1000,dis,3'];
const rest = (ms) => new Promise((done) => setTimeout(done, ms));

/** Half against half, 6000 ft apart, each side at its own altitude, so that nobody meets. */
function scene(aircraft) {
  const side = (name, count, east, heading, altitude) => {
    const flights = [];
    for (let first = 0; first < count; first += 4) {
      const letter = (i) => (i >= 26 ? letter(Math.floor(i / 26) - 1) : '') + 'abcdefghijklmnopqrstuvwxyz'[i % 26];
      const flight = `${name}_${letter(first / 4)}`;
      const north = (i) => ((i - (count - 1) / 2) * 6000).toFixed(1);
      const route = [0, 1, 2, 3, 4].map((leg) =>
        `        - {north: ${north(first)} ft, east: ${(leg % 2 ? 4 : -4) * east} nmi, altitude: ${altitude} ft, speed: 480 kt}`);
      const players = [0, 1, 2, 3].filter((k) => first + k < count).map((k) =>
        `        - ${flight}${k + 1}: {start: {north: ${north(first + k)} ft, east: ${east} nmi}}`);
      flights.push(`    ${flight}:\n      aircraft: paper_fighter\n      tree: pilot
      start: {altitude: ${altitude} ft, heading: ${heading} deg, speed: 480 kt}
      route:\n${route.join('\n')}\n      players:\n${players.join('\n')}`);
    }
    return `${name}:\n  flights:\n${flights.join('\n')}\n`;
  };
  return `eyrie: 1\nname: line_abreast\nreference: {latitude: 33 deg, longitude: -68 deg}\nends: time\nuntil: ${seconds} s
trees:\n  pilot:\n    winner_takes_all:\n      - avoid_ground: {vote: 100}\n      - break_turn: {vote: 70}
      - egress: {vote: 1}\n      - follow_lead: {vote: 5}\n      - navigate: {vote: 10}\n` +
    side('blue', Math.ceil(aircraft / 2), -20, 90, 20000) + side('red', Math.floor(aircraft / 2), 20, 270, 22000);
}

/** A Chromium of its own with the page of the mission. */
async function look(address) {
  const browser = await puppeteer.launch({ headless: true, executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage'], defaultViewport: { width: 1280, height: 800 }, protocolTimeout: 0 });
  const page = await browser.newPage();
  await page.goto(address, { waitUntil: 'domcontentloaded' });
  await page.waitForSelector('body[data-ready=true]', { timeout: 120_000 });
  return { browser, page };
}

/** How far it has flown, and whether its world is that of the program. */
const seen = ({ page }) => page.evaluate(() =>
  ({ time: window.eyrie.run.about.duration, same: document.querySelector('.pace .verified') !== null && document.querySelector('.big.bad') === null }));

async function row(words, folder) {
  const [aircraft, dis, browsers] = words.split(',');
  const file = join(folder, 'line_abreast.yaml');
  writeFileSync(file, scene(Number(aircraft)));
  const options = ['--port', '0', ...(Number(browsers) ? ['--paused'] : []), ...(dis === 'dis' ? ['--dis=239.1.2.3'] : [])];
  const mission = spawn(program, ['serve', file, ...options], { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  for (const stream of [mission.stdout, mission.stderr]) stream.on('data', (more) => { said += more; });
  const ended = new Promise((done) => mission.on('close', done));
  const stop = () => mission.kill('SIGKILL');
  process.on('exit', stop);
  while (!/http:\/\/[^ ]*/.test(said)) await rest(50);
  const [address] = /http:\/\/[^ ]*/.exec(said);
  const lookers = [];
  for (let i = 0; i < Number(browsers); ++i) lookers.push(await look(address));
  let behind = 0, differ = 0;
  const begun = performance.now();
  const flown = () => (performance.now() - begun) / 1000;
  if (lookers.length) await lookers[0].page.keyboard.press(' ');
  for (let look = 1; flown() < seconds - 1; ++look) {
    await rest(1000 * Math.min(60, seconds - 1 - flown()));
    for (const looker of lookers) {
      const { time, same } = await seen(looker);
      behind = Math.max(behind, flown() - time);
      differ += !same;
    }
    if (look % 5 === 0) console.error(`  ${words}: ${flown().toFixed(0)} of ${seconds} s`);
  }
  await rest(3000);
  for (const looker of lookers) {
    const { time, same } = await seen(looker);
    differ += !same || time < seconds - 0.05;
    await looker.browser.close();
  }
  mission.kill('SIGINT');  // what is over is shown until somebody ends it
  const code = await ended;
  process.off('exit', stop);
  const line = (what) => said.split('\n').find((one) => one.includes(what))?.replace(/^eyrie: /, '') ?? '';
  console.log(`${words.padEnd(12)} ${line('by the clock')}${dis === 'dis' ? `\n${' '.repeat(13)}${line('DIS: ')}` : ''}
${' '.repeat(13)}${line(' to them, ')}${lookers.length ? `\n${' '.repeat(13)}${differ ? `THE PAGES DIFFER ${differ} times` : 'every page had the same world'}, ${behind.toFixed(1)} s behind at most` : ''}`);
  if (code !== 130 || differ) process.exitCode = 1;  // 128 + SIGINT
}

const folder = mkdtempSync(join(tmpdir(), 'eyrie-bench-'));
try {
  for (const words of rows) await row(words, folder);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
