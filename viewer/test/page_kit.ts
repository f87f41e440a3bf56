// SPDX-License-Identifier: MIT
/** A real browser without a network, and the program itself: what the tests of the page need. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { words_of, type WhatIfJson } from './terminal.ts';

const { env } = process;
/** A debrief.html of the sweep. */
export const kPageFile = env['EYRIE_PAGE_FILE'] ?? '';
export const kProgram = env['EYRIE_PROGRAM'] ?? '';
const kRunFolder = env['EYRIE_RUN'] ?? '';
const kShots = env['EYRIE_SHOTS'] ?? '';

/** For `skip`: false, or why. */
export const kNoPage = kPageFile ? false : 'EYRIE_PAGE_FILE is not set: no page to open';
export const kNoProgram = kNoPage || (kProgram && kRunFolder ? false : 'EYRIE_PROGRAM or EYRIE_RUN is not set: nothing to compare with');

/** ms: what the page is allowed, as machines differ. */
export const kPatience = 30_000;

export interface Opened {
  page: Page;
  /** What it said on the console as a warning or worse, and what it asked the network for. */
  complaints: string[];
  /** ms from the navigation to data-ready. */
  opened_in: number;
}

export async function launch(): Promise<Browser> {
  // the tests are bundled elsewhere
  const require = createRequire(join(env['EYRIE_VIEWER_FOLDER']!, 'package.json'));
  const { chromium } = require('playwright-core') as typeof import('playwright-core');
  return chromium.launch({
    executablePath: env['EYRIE_CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage'],
  });
}

/** Whether a page that stands in one file may ask for it. */
function is_own(url: string): boolean {
  return /^(file|data|blob|about):/.test(url);
}

/** What chromium says of drawing by software is no fault of the page. */
function is_of_the_machine(text: string): boolean {
  return /GPU stall|software WebGL|swiftshader|GL Driver Message/i.test(text);
}

function listen(page: Page, complaints: string[]): void {
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  page.on('console', (message) => {
    const [type, text] = [message.type(), message.text()];
    if (['error', 'warning'].includes(type) && !is_of_the_machine(text)) complaints.push(`${type}: ${text}`);
  });
}

export interface Look {
  width?: number;
  height?: number;
  theme?: 'light' | 'dark';
  fragment?: string;
  /** Instead of what suits the machine, which has no graphics card. */
  draw?: 'webgl' | 'canvas';
}

async function shut_off(context: BrowserContext, complaints: string[]): Promise<void> {
  await context.route('**/*', (route) => {
    const url = route.request().url();
    if (is_own(url)) return route.continue();
    complaints.push(`network: ${url}`);
    return route.abort();
  });
}

/** Opens a file without waiting for the run in it. */
export async function open_file(browser: Browser, file: string, look: Look = {}): Promise<Opened> {
  const { width = 1280, height = 720, theme = 'light', fragment = '', draw } = look;
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme });
  const complaints: string[] = [];
  await shut_off(context, complaints);
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  listen(page, complaints);
  const began = performance.now();
  await page.goto(pathToFileURL(file).href + (draw ? `?draw=${draw}` : '') + fragment, { waitUntil: 'commit' });
  return { page, complaints, opened_in: performance.now() - began };
}

/** Opens the page and waits until it says that it is ready. */
export async function open_page(browser: Browser, look: Look = {}): Promise<Opened> {
  const began = performance.now();
  const opened = await open_file(browser, kPageFile, look);
  await opened.page.waitForSelector('body[data-ready=true]', { state: 'attached' });
  return { ...opened, opened_in: performance.now() - began };
}

/** A page made by the program of the run and of another flight of it, with changes; with what it says of where they part. */
export async function two_runs(folder: string, sets: string[]): Promise<{ file: string; parting: PartingJson }> {
  const run = (args: string[]) => promisify(execFile)(kProgram, args, { cwd: folder, maxBuffer: 1 << 28 });
  const other = join(folder, 'other');
  await run(['fly', 'sweep', '--quiet', '--no-debrief', '--out', other, ...sets.flatMap((set) => ['--set', set])]);
  const file = join(folder, 'two.html');
  await run(['debrief', kRunFolder, other, '--out', file]);
  // it ends with 1 for runs that part
  const said = await run(['diff', kRunFolder, other, '--json']).catch((e: { stdout: string }) => e);
  return { file, parting: (JSON.parse(said.stdout) as { action: PartingJson }).action };
}

export async function shoot(page: Page, name: string): Promise<void> {
  if (!kShots) return;
  mkdirSync(kShots, { recursive: true });
  await page.screenshot({ path: join(kShots, `${name}.png`) });
}

export interface PartingJson { time_s: number; step: number; text: string }
interface ValueJson { name: string; text: string; value?: number }
export interface DecisionJson {
  time_s: number;
  step: number;
  status: string;
  vote: number;
  leader: string | null;
  action: (ValueJson & { winner: string; reason: string; rivals: { node: string; value: ValueJson; vote: number }[] })[];
  nodes: { path: string; asked: boolean; status?: string; vote?: number }[];
}

async function ask<T>(command: string, args: string[]): Promise<T> {
  const { stdout } = await promisify(execFile)(kProgram, [command, kRunFolder, ...args, '--json'], { maxBuffer: 1 << 28 });
  return JSON.parse(stdout) as T;
}

/** The first decision of a player that is not before `time` (s). */
export async function explain(player: string, time: number): Promise<DecisionJson> {
  const [decision] = await ask<DecisionJson[]>('explain', ['--player', player, '--at', String(time)]);
  assert.ok(decision, `${player} decides nothing at ${time}`);
  return decision;
}

/** Asks what stands in the page as a command for the terminal. */
export async function ask_command(command: string): Promise<WhatIfJson> {
  const words = words_of(command);
  assert.deepEqual(words.slice(0, 3), ['eyrie', 'whatif', 'RUN']);
  return ask<WhatIfJson>('whatif', words.slice(3));
}
