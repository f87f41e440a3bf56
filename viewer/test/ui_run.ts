// SPDX-License-Identifier: MIT
/** A small run with a story for the tests of the panels, and a page that shows it. */
import type { Player, Run, StoryLine } from '../src/run/run.ts';
import { View, Store } from '../src/store.ts';
import { Page } from '../src/ui/page.ts';
import { leaf, node, run_of, type Said } from './words_run.ts';

export const kTree = node('root', 'winner_takes_all', [leaf('break'), leaf('pursue'), leaf('navigate')]);
export const kPursues: Record<string, Said> = {
  break: { status: 'failure' }, pursue: { vote: 40, heading: 1 }, navigate: { vote: 10, heading: 2 },
};
export const kBreaks: Record<string, Said> = { ...kPursues, break: { vote: 70, heading: 3 } };

function line(t: number, kind: string, who: number, text: string): StoryLine {
  return { t, kind, tone: who === 1 ? 'red' : 'blue', who, name: ['eagle2', 'bogey1'][who]!, text, decider: who, decided: t };
}
export const kStory = [
  line(0.1, 'contact', 0, 'contact, 40 nmi'), line(0.2, 'launch', 0, 'fox 3 on bogey1'),
  line(0.25, 'seeker_active', 0, 'pitbull on bogey1'),
  line(0.3, 'defend', 1, 'defending: breaks, nose low'), line(0.4, 'kill', 0, 'splash bogey1 (AIM-120)'),
];

/** eagle2 decides as it is said, every 0.1 s; bogey1 is there and does nothing. */
export function told_run(decisions: Record<string, Said>[], story: StoryLine[] = kStory): Run {
  const run = run_of(kTree, decisions);
  const none = new Float64Array(0);
  const gone = decisions.length / 10;
  const one = { ...run.players[0]!, side: 'blue', born: 0, gone, end: 'home', sights: { t: none } } as Player;
  const silent = { t: none, step: none, shape: new Int32Array(0), why_not: new Int32Array(0), value: () => null };
  const two: Player = { ...one, index: 1, name: 'bogey1', side: 'red', decisions: silent };
  return { ...run, players: [one, two], story, about: { duration: gone } } as unknown as Run;
}

export function page_of(run: Run, view: Partial<View> = {}): Page {
  return new Page(run, new Store({ ...new View(), end: run.about.duration, ...view }), '');
}
