// SPDX-License-Identifier: MIT
/** What a page says, in a real browser, whose run or engine is damaged or of another Eyrie. */
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { deflateSync, inflateSync } from 'node:zlib';
import type { Browser } from 'puppeteer-core';
import { ascii85, from_ascii85 } from '../ascii85.mjs';
import { kNoPage, kPageFile, launch, open_file, scratch_folder, shoot } from './page_kit.ts';

describe('a page that cannot show its run says so in words', { skip: kNoPage }, () => {
  const folder = scratch_folder();
  let browser: Browser;
  before(async () => (browser = await launch()));
  after(async () => browser?.close());
  const part = (type: string) => new RegExp(`(<script type="application/x-eyrie-${type}">)([^<]*)(</script>)`);
  const kRun = part('run-file');
  const packed = (change: (bytes: Buffer) => Buffer) => (data: string) => ascii85(deflateSync(change(inflateSync(from_ascii85(data)))));

  async function words_of(change: (data: string) => string, where: RegExp): Promise<string> {
    const file = join(folder, 'page.html');
    writeFileSync(file, readFileSync(kPageFile, 'utf8').replace(where, (_, a: string, data: string, b: string) => a + change(data) + b));
    const broken = await open_file(browser, file);
    await broken.page.waitForSelector('[role=alert]');
    const words = await broken.page.textContent('[role=alert]');
    assert.ok(!broken.complaints.some((c) => c.startsWith('network')), broken.complaints.join('\n'));
    await shoot(broken.page, 'broken');
    await broken.page.close();
    return words;
  }
  const kDamaged = /damaged or incomplete/;
  const kCases: [name: string, says: RegExp, change: (data: string) => string, where?: RegExp][] = [
    ['cut off', kDamaged, (data) => data.slice(0, data.length / 2)],
    ['with other bytes', kDamaged, (data) => `${data.slice(0, 1000)}${'A'.repeat(1000)}${data.slice(2000)}`],
    ['that is no such text', kDamaged, () => '*** no run ***'],
    ['empty', kDamaged, () => ''],
    // behind the magic
    ['of a newer Eyrie', /format version 99, and this Eyrie reads version \d+: open it with the one that recorded it/, packed((bytes) => (bytes.writeUInt32LE(99, 8), bytes))],
    ['with the engine of another Eyrie', /engine in this page is of another Eyrie/, () => ascii85(deflateSync(Buffer.from('\0asm\x01\0\0\0'))), part('engine')],
  ];
  for (const [name, says, change, where = kRun] of kCases)
    test(name, async () => assert.match(await words_of(change, where), says));
});
