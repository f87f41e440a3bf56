// SPDX-License-Identifier: MIT
/** The browsers in which the pages are tested, without a network. */
import { createRequire } from 'node:module';
import { join } from 'node:path';
import type { Browser, LaunchOptions, Page } from 'puppeteer-core';

const { env } = process;

export const kBrowsers = {
  chromium: { browser: 'chrome', executablePath: env['EYRIE_CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-dev-shm-usage'] },
  firefox: { browser: 'firefox', executablePath: env['EYRIE_FIREFOX'] ?? '/usr/bin/firefox-esr', args: [] },
} satisfies Record<string, LaunchOptions>;
export type Where = keyof typeof kBrowsers;

/** ms: what a page is allowed, as machines differ. */
export const kPatience = 60_000;

export async function launch(where: Where): Promise<Browser> {
  // the tests are bundled elsewhere
  const require = createRequire(join(env['EYRIE_VIEWER_FOLDER']!, 'package.json'));
  const { default: puppeteer } = (await import(require.resolve('puppeteer-core'))) as typeof import('puppeteer-core');
  return puppeteer.launch({ headless: true, protocolTimeout: 600_000, defaultViewport: { width: 1440, height: 900 }, ...kBrowsers[where] });
}

export interface Opened {
  page: Page;
  /** What it said on the console as a warning or worse, and what it asked the network for. */
  complaints: string[];
}

/** What a browser says of drawing by software is no fault of the page. */
function is_of_the_machine(text: string): boolean {
  return /GPU stall|software WebGL|swiftshader|GL Driver Message|WebGL warning|WEBGL_debug_renderer_info/i.test(text);
}

/** Opens an address without waiting for what is in it. */
export async function open_url(browser: Browser, url: string): Promise<Opened> {
  const complaints: string[] = [];
  const page = await browser.newPage();
  page.setDefaultTimeout(kPatience);
  page.on('pageerror', (error) => complaints.push(`error: ${(error as Error).message}`));
  page.on('console', (message) => {
    const [type, text] = [message.type(), message.text()];
    if (['error', 'warn'].includes(type) && !is_of_the_machine(text)) complaints.push(`${type}: ${text}`);
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob|about):/.test(request.url())) complaints.push(`network: ${request.url()}`);
  });
  await page.goto(url);
  return { page, complaints };
}
