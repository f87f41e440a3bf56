// SPDX-License-Identifier: MIT
/** `eyrie serve` in a browser: the page by the address that was printed, and nothing for a page of another site. */
import assert from 'node:assert/strict';
import type { ChildProcess } from 'node:child_process';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { dirname } from 'node:path';
import { after, before, test } from 'node:test';
import type { Browser } from 'puppeteer-core';
import { open_url } from './browsers.ts';
import { kNoProgram, kPageFile, launch, serve } from './page_kit.ts';

let browser: Browser, program: ChildProcess, other: Server;
/** As printed, for this machine. */
let address = '';

before(async () => {
  if (kNoProgram) return;
  browser = await launch();
  const served = await serve([dirname(kPageFile), '--address', '0.0.0.0'], '.');
  ({ program } = served);
  address = served.address.replace(/\/\/[^:]*:/, '//127.0.0.1:');
  other = createServer((_, answer) => answer.setHeader('Content-Type', 'text/html').end('<p>another site'));
  await new Promise<void>((done) => other.listen(0, '127.0.0.1', done));
});
after(async () => {
  await browser?.close();
  program?.kill();
  other?.close();
});

test('opens by the address that was printed, which has the token no longer', { skip: kNoProgram }, async () => {
  const { page, complaints } = await open_url(browser, address);
  await page.waitForSelector('body[data-ready=true]');
  assert.equal(await page.evaluate(() => location.search), '');
  // Firefox looks for an icon, which the page forbids; the page is asked for with the token, and then with the cookie
  const others = complaints.filter((c) => !c.includes('/favicon.ico'));
  assert.deepEqual(others, [`network: ${address}`, `network: ${new URL('/', address)}`]);
  await page.close();
});

test('is closed to a page of another site, though the browser has the cookie', { skip: kNoProgram }, async () => {
  const { page } = await open_url(browser, `http://127.0.0.1:${(other.address() as AddressInfo).port}/`);
  const at = new URL(address).host;
  const got = await page.evaluate(async (host) => {
    const live = new Promise<string>((done) => {
      const socket = new WebSocket(`ws://${host}/live`);
      socket.onopen = () => done('open');
      socket.onerror = () => done('refused');
    });
    const read = fetch(`http://${host}/`, { credentials: 'include' }).then((answer) => answer.text(), () => 'refused');
    return [await live, await read];
  }, at);
  assert.deepEqual(got, ['refused', 'refused']);
  await page.close();
});
