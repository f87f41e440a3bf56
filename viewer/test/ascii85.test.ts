// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { test } from 'node:test';
import { ascii85, from_ascii85 } from '../ascii85.mjs';
import { kNoPage, kPageFile } from './page_kit.ts';

test('is that of Adobe, but that v stands for <', () => {
  assert.equal(ascii85(Buffer.from('Man sure.')), '9jqo^F*2M7/c');
  assert.equal(ascii85(Uint8Array.of(0, 0, 0, 0)), '!!!!!');
  assert.equal(ascii85(Uint8Array.of(255, 255, 255, 255)), 's8W-!');
  assert.equal(ascii85(Uint8Array.of(0, 0, 0, 27)), '!!!!v');
});

test('gives back what it was given, whatever its length', () => {
  for (let length = 0; length < 600; ++length) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 2654435761) >>> 24);
    const text = ascii85(bytes);
    assert.match(text, /^[!-;=-v]*$/);
    assert.deepEqual(from_ascii85(text), bytes);
  }
});

test('keeps a page below 1.6 MB', { skip: kNoPage }, () => assert.ok(statSync(kPageFile).size <= 1.6e6, `${statSync(kPageFile).size} bytes`));
