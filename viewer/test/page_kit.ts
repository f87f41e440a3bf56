// SPDX-License-Identifier: MIT
/** A real browser without a network, and the program itself: what the tests of the page need. */
import assert from 'node:assert/strict';
import { execFile, spawn, type ChildProcess } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import type { Browser } from 'puppeteer-core';
import { launch as launch_in, open_url, type Look, type Opened, type UserPage, type Where } from './browsers.ts';
import { words_of, type WhatIfJson } from './terminal.ts';

const { env } = process;
/** A debrief.html of scenarios/sweep_phases.yaml. */
export const kPageFile = env['EYRIE_PAGE_FILE'] ?? '';
export const kProgram = env['EYRIE_PROGRAM'] ?? '';
const kRunFolder = env['EYRIE_RUN'] ?? '';
const kShots = env['EYRIE_SHOTS'] ?? '';

/** For `skip`: false, or why. */
export const kNoPage = kPageFile ? false : 'EYRIE_PAGE_FILE is not set: no page to open';
export const kNoProgram = kNoPage || (kProgram && kRunFolder ? false : 'EYRIE_PROGRAM or EYRIE_RUN is not set: nothing to compare with');

/** Where this script runs: EYRIE_BROWSER, else Chromium. */
export const kWhere = (env['EYRIE_BROWSER'] ?? 'chromium') as Where;
export const launch = (): Promise<Browser> => launch_in(kWhere);

interface PageLook extends Look {
  fragment?: string;
  /** Instead of what suits the machine, which has no graphics card. */
  draw?: 'webgl' | 'canvas';
}

/** Opens a file without waiting for the run in it. */
export function open_file(browser: Browser, file: string, { fragment = '', draw, ...look }: PageLook = {}): Promise<Opened> {
  return open_url(browser, pathToFileURL(file).href + (draw ? `?draw=${draw}` : '') + fragment, look);
}

/** Opens the page and waits until it says that it is ready. */
export async function open_page(browser: Browser, look: PageLook = {}): Promise<Opened> {
  const opened = await open_file(browser, kPageFile, look);
  await opened.page.waitForSelector('body[data-ready=true]');
  return opened;
}

/** Uses another page and closes it whatever happens: what it hides gets no pictures, and whoever waits for those waits for ever. */
export async function on_page(opening: Promise<Opened>, use: (page: UserPage, complaints: string[]) => Promise<void>): Promise<void> {
  const { page, complaints } = await opening;
  try {
    await page.waitForSelector('body[data-ready=true]');
    await use(page, complaints);
  } finally {
    await page.close();
  }
}

/** A browser with the page for all tests of a file; `take` is called before the first of them. */
export function with_page(look: PageLook, take: (opened: Opened, browser: Browser) => void): void {
  let browser: Browser | undefined;
  before(async () => {
    if (kNoPage) return;
    browser = await launch();
    take(await open_page(browser, look), browser);
  });
  after(async () => browser?.close());
}

/** A folder for the tests of a suite, which is gone after them. */
export function scratch_folder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'eyrie-page-'));
  after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** `eyrie serve` with these words, at an address that is free. */
export async function serve(words: string[], cwd: string): Promise<{ program: ChildProcess; address: string }> {
  const program = spawn(kProgram, ['serve', ...words, '--port', '0'], { cwd, stdio: ['ignore', 'ignore', 'pipe'] });
  let said = '';
  const address = await new Promise<string>((done, fail) => {
    program.stderr!.on('data', (more: Buffer) => {
      said += more.toString();
      const found = /http:\/\/[^ ]*/.exec(said);
      if (found) done(found[0]);
    });
    program.on('exit', (code, signal) => fail(new Error(`${said} ended with ${code ?? signal}`)));
  });
  return { program, address };
}

/** A page made by the program of the run and of another flight of it, with changes; with what it says of where they part. */
export async function two_runs(folder: string, sets: string[]): Promise<{ file: string; parting: PartingJson }> {
  const run = (args: string[]) => promisify(execFile)(kProgram, args, { cwd: folder, maxBuffer: 1 << 28 });
  const other = join(folder, 'other');
  await run(['fly', 'sweep_phases', '--quiet', '--no-debrief', '--out', other, ...sets.flatMap((set) => ['--set', set])]);
  const file = join(folder, 'two.html');
  await run(['debrief', kRunFolder, other, '--out', file]);
  // it ends with 1 for runs that part
  const said = await run(['diff', kRunFolder, other, '--json']).catch((e: { stdout: string }) => e);
  return { file, parting: (JSON.parse(said.stdout) as { action: PartingJson }).action };
}

/** Labels go where there was room when they came; a picture without them is the same whatever was seen before. */
export function without_labels(page: UserPage): Promise<void> {
  return page.evaluate(() => {
    const { store } = window.eyrie!;
    store.set({ layers: { ...store.get().layers, labels: false, zones: false } });
  });
}

export async function shoot(page: UserPage, name: string): Promise<void> {
  if (!kShots) return;
  mkdirSync(kShots, { recursive: true });
  writeFileSync(join(kShots, `${name}.png`), await page.screenshot());
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
  assert.deepEqual(words.slice(0, 3), ['eyrie', 'whatif', dirname(kPageFile)]);
  return ask<WhatIfJson>('whatif', words.slice(3));
}
