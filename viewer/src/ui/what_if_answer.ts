// SPDX-License-Identifier: MIT
/** What the changed trees would have decided, computed once for all panels that show it. */
import { useMemo } from 'preact/hooks';
import { what_if, type Change, type WhatIfResult } from '../decide/what_if.ts';
import { use_page, type Page } from './page.ts';
import { use_cell, use_view } from './use.ts';

interface Answer {
  changes: readonly Change[];
  player: number;
  result: WhatIfResult;
}

const kLast = new WeakMap<Page, Answer>();

function answer_to(page: Page, player: number, changes: readonly Change[]): WhatIfResult {
  const last = kLast.get(page);
  if (last && last.changes === changes && last.player === player) return last.result;
  const result = what_if(page.run, player, changes);
  kLast.set(page, { changes, player, result });
  return result;
}

/** For the selected player; null while nothing is asked. */
export function use_answer(): WhatIfResult | null {
  const page = use_page();
  const changes = use_cell(page.changes);
  const player = use_view(page.store, (v) => v.selected);
  return useMemo(() => (changes.length ? answer_to(page, player, changes) : null), [page, player, changes]);
}

function same_node(a: Change, b: Pick<Change, 'tree' | 'node'>): boolean {
  return a.tree === b.tree && a.node === b.node;
}

export function change_of(changes: readonly Change[], tree: number, node: number): Change | undefined {
  return changes.find((change) => same_node(change, { tree, node }));
}

/** Asks `patch` of a node besides all that is asked already; what is undefined in it is as flown again. */
export function ask(page: Page, tree: number, node: number, patch: Omit<Change, 'tree' | 'node'>): void {
  const changes = page.changes.get();
  const merged: Change = { ...change_of(changes, tree, node), tree, node };
  for (const key of ['type', 'vote', 'params'] as const) {
    if (!(key in patch)) continue;
    if (patch[key] === undefined) delete merged[key];
    else Object.assign(merged, { [key]: patch[key] });
  }
  const others = changes.filter((change) => !same_node(change, merged));
  const asks = merged.type !== undefined || merged.vote !== undefined || Object.keys(merged.params ?? {}).length > 0;
  page.changes.set(asks ? [...others, merged] : others);
}
