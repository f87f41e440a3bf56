// SPDX-License-Identifier: MIT
/** The browsers in which the pages are tested, without a network, and what a person does in them. */
import { createRequire } from 'node:module';
import { join } from 'node:path';
import type { Browser, BoundingBox, ElementHandle, LaunchOptions, Page } from 'puppeteer-core';

const { env } = process;

export const kBrowsers = {
  chromium: { browser: 'chrome', executablePath: env['EYRIE_CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-dev-shm-usage', '--force-color-profile=srgb', '--hide-scrollbars', '--font-render-hinting=none'] },
  firefox: { browser: 'firefox', executablePath: env['EYRIE_FIREFOX'] ?? '/usr/bin/firefox-esr', args: [] },
} satisfies Record<string, LaunchOptions>;
export type Where = keyof typeof kBrowsers;

/** ms: what a page is allowed, as machines differ. */
export const kPatience = 150_000;

export async function launch(where: Where): Promise<Browser> {
  // the tests are bundled elsewhere
  const require = createRequire(join(env['EYRIE_VIEWER_FOLDER']!, 'package.json'));
  const { default: puppeteer } = (await import(require.resolve('puppeteer-core'))) as typeof import('puppeteer-core');
  return puppeteer.launch({ headless: true, protocolTimeout: 600_000, defaultViewport: null, ...kBrowsers[where] });
}

/** What a browser says when its document becomes another one while it is asked. */
const kLeft = /context was destroyed|no such (handle|node)|is detached/i;

/** Asks again and again: what waits in the page fails in Firefox 140 unless it holds at once. */
async function until<T>(ask: () => Promise<T>, problem: string, { polling = 30, timeout = kPatience } = {}): Promise<NonNullable<T>> {
  for (const end = Date.now() + timeout; Date.now() < end; await new Promise((done) => setTimeout(done, polling))) {
    const answer = await ask().catch((error: unknown) => {
      if (!kLeft.test(String(error))) throw error;
    });
    if (answer) return answer;
  }
  throw new Error(`${problem}, for ${timeout} ms`);
}

/** A page with what a person does on it; an element that is worked or read is waited for. */
export class UserPage {
  readonly keyboard: Page['keyboard'];
  readonly mouse: Page['mouse'];
  readonly touch: Page['touchscreen'];
  readonly evaluate: Page['evaluate'];
  readonly evaluateHandle: Page['evaluateHandle'];
  readonly $: Page['$'];
  readonly $$: Page['$$'];
  readonly $eval: Page['$eval'];
  readonly $$eval: Page['$$eval'];

  constructor(private readonly page: Page) {
    [this.keyboard, this.mouse, this.touch] = [page.keyboard, page.mouse, page.touchscreen];
    this.evaluateHandle = page.evaluateHandle.bind(page);
    [this.evaluate, this.$, this.$$, this.$$eval] = [page.evaluate.bind(page), page.$.bind(page), page.$$.bind(page), page.$$eval.bind(page)];
    const eval_now = page.$eval.bind(page) as (selector: string, ...rest: unknown[]) => Promise<unknown>;
    this.$eval = (async (selector: string, ...rest: unknown[]) => {
      await this.find(selector);
      return eval_now(selector, ...rest);
    }) as Page['$eval'];
  }

  async find(selector: string): Promise<ElementHandle> {
    return until(() => this.page.$(selector), `there is no ${selector}`);
  }
  async waitForSelector(selector: string): Promise<void> {
    await this.find(selector);
  }
  async waitForFunction<A>(holds: (argument: A) => unknown, argument?: A, options: { polling?: number; timeout?: number } = {}): Promise<void> {
    await until(() => this.page.evaluate(holds as (argument: unknown) => unknown, argument), `never: ${holds}`, options);
  }
  waitForTimeout(ms: number): Promise<void> {
    return new Promise((done) => setTimeout(done, ms));
  }
  async click(selector: string): Promise<void> {
    await (await this.find(selector)).click();
  }
  async hover(selector: string): Promise<void> {
    await (await this.find(selector)).hover();
  }
  /** Types a value over what is there. */
  async fill(selector: string, value: string): Promise<void> {
    await (await this.find(selector)).focus();
    await this.$eval(selector, (field) => (field as HTMLInputElement).select());
    if (value) await this.keyboard.type(value);
    else await this.keyboard.press('Backspace');
  }
  async press(selector: string, key: Parameters<Page['keyboard']['press']>[0]): Promise<void> {
    await (await this.find(selector)).focus();
    await this.keyboard.press(key);
  }
  async selectOption(selector: string, wanted: string | { index?: number; label?: string }): Promise<void> {
    await this.find(selector);
    await this.$eval(selector, (element, by) => {
      const list = element as HTMLSelectElement;
      const option = [...list.options].find((one, i) => (typeof by === 'string' ? one.value === by : i === by.index || one.label === by.label));
      if (!option) throw new Error(`there is no ${JSON.stringify(by)} to choose`);
      list.value = option.value;
      list.dispatchEvent(new Event('input', { bubbles: true }));
      list.dispatchEvent(new Event('change', { bubbles: true }));
    }, wanted);
  }
  textContent(selector: string): Promise<string> {
    return this.$eval(selector, (element) => element.textContent ?? '');
  }
  async box(selector: string): Promise<BoundingBox> {
    return (await (await this.find(selector)).boundingBox())!;
  }
  async screenshot(of?: string | BoundingBox): Promise<Buffer> {
    // else Chromium makes the window as small as what is asked for, and a narrow page is another one
    const as_it_is = { captureBeyondViewport: false };
    if (typeof of === 'string') return Buffer.from(await (await this.find(of)).screenshot(as_it_is));
    return Buffer.from(await this.page.screenshot(of ? { clip: of, ...as_it_is } : as_it_is));
  }
  /** When nothing moves any more. */
  async at_rest(selector: string): Promise<Buffer> {
    for (let last = await this.screenshot(selector);;) {
      await this.waitForTimeout(300);
      const now = await this.screenshot(selector);
      if (now.equals(last)) return now;
      last = now;
    }
  }
  /** Chromium only: as on paper, or as on a screen. */
  print_media(type: 'print' | 'screen'): Promise<void> {
    return this.page.emulateMediaType(type);
  }
  title(): Promise<string> {
    return this.page.title();
  }
  close(): Promise<void> {
    return this.page.close();
  }
}

export interface Look {
  width?: number;
  height?: number;
  theme?: 'light' | 'dark';
}
export interface Opened {
  page: UserPage;
  /** What it said on the console as a warning or worse, and what it asked the network for. */
  complaints: string[];
}

/** What a browser says of drawing by software is no fault of the page. */
function is_of_the_machine(text: string): boolean {
  return /GPU stall|software WebGL|swiftshader|GL Driver Message|WebGL warning|WEBGL_debug_renderer_info/i.test(text);
}

/** Opens an address without waiting for what is in it. */
export async function open_url(browser: Browser, url: string, { width = 1280, height = 720, theme = 'light' }: Look = {}): Promise<Opened> {
  const complaints: string[] = [];
  const page = await browser.newPage();
  page.setDefaultTimeout(kPatience);
  // Firefox 140 knows the size and not the orientation, which is sent with it
  await page.setViewport({ width, height }).catch((error: unknown) => {
    if (!/unknown command emulation/.test(String(error))) throw error;
  });
  await until(() => page.evaluate((wanted) => innerWidth === wanted, width), 'the window has not its size');
  // Firefox has no such wish, and takes the light one
  if (theme === 'dark') await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]).catch(() => {});
  page.on('pageerror', (error) => complaints.push(`error: ${(error as Error).message}`));
  page.on('console', (message) => {
    const [type, text] = [message.type(), message.text()];
    if (['error', 'warn'].includes(type) && !is_of_the_machine(text)) complaints.push(`${type}: ${text}`);
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob|about):/.test(request.url())) complaints.push(`network: ${request.url()}`);
  });
  await page.goto(url, { waitUntil: 'domcontentloaded' });
  return { page: new UserPage(page), complaints };
}
