// SPDX-License-Identifier: MIT
/** What if, without an engine: its sliders, and its command for the terminal. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { step_of } from '../src/ui/node_details.tsx';
import { shell_path } from '../src/ui/what_if_answer.ts';

test('a shell finds the folder of the page, whatever its name is', () => {
  assert.equal(shell_path('/runs/sweep-1'), '/runs/sweep-1');
  for (const [path, bytes] of [
    ['/a%23b%20c\'d', Buffer.from('/a#b c\'d')], ['/Fl%C3%BCge', Buffer.from('/Flüge')], ['/it\'s%20Fl%FCge%5C', Buffer.from('/it\'s Fl\xfcge\\', 'latin1')],
  ] as const)
    assert.deepEqual(execFileSync('bash', ['-c', `printf %s ${shell_path(path)}`]), bytes, path);
});

test('a slider goes in steps of its span, and can stand where the value is', () => {
  assert.deepEqual([step_of(0, 100, [40]), step_of(0, 100, [40, 12.5]), step_of(0.1, 2, [1.15]), step_of(0, 1, [0.3]), step_of(0, 20, [1 / 3])], [1, 0.1, 0.01, 0.01, 1e-6]);
});
