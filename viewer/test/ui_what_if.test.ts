// SPDX-License-Identifier: MIT
/** What if, without an engine: its command for the terminal. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { shell_path } from '../src/ui/what_if_answer.ts';

test('a shell finds the folder of the page, whatever its name is', () => {
  assert.equal(shell_path('/runs/sweep-1'), '/runs/sweep-1');
  for (const [path, bytes] of [
    ['/a%23b%20c\'d', Buffer.from('/a#b c\'d')], ['/Fl%C3%BCge', Buffer.from('/Flüge')], ['/it\'s%20Fl%FCge%5C', Buffer.from('/it\'s Fl\xfcge\\', 'latin1')],
  ] as const)
    assert.deepEqual(execFileSync('bash', ['-c', `printf %s ${shell_path(path)}`]), bytes, path);
});
