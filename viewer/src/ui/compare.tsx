// SPDX-License-Identifier: MIT
/** Two runs on one page: who led in both, one above the other, and where they part: the first decision of a player that is
 * another one, the first story line that only one has. */
import { useMemo } from 'preact/hooks';
import { source_of, type Player, type Run } from '../run/run.ts';
import type { View } from '../store.ts';
import { value_text, clock_text, reworded } from '../words/text.ts';
import { jump, select } from './actions.ts';
import { LeaderRow } from './leaders.tsx';
import { namesake, use_page, view_in, type Page } from './page.ts';
import { label_of, path_of } from './spans.ts';

/** What both views have in common; the other half of it is players of the same name. */
const kShared = ['time', 'playing', 'rate', 'camera', 'layers', 'zoom', 'theme', 'units', 'trail'] as const;

/** What `to` must change because `from` did. */
function passed_on(from: Page, to: Page, now: View, before: View): Partial<View> {
  const patch: Partial<View> = {};
  for (const key of kShared) if (now[key] !== before[key]) Object.assign(patch, { [key]: now[key] });
  const { ruler = null } = view_in(to.run, from.run, now);
  if (now.ruler !== before.ruler) patch.ruler = ruler;
  const selected = namesake(to, from.run.players[now.selected]);
  if (now.selected !== before.selected && selected >= 0) patch.selected = selected;
  return patch;
}

/** Makes both runs show the same: time, zoom, camera, and players of the same name. */
export function link_pages(a: Page, b: Page): void {
  let passing_on = false;
  const follow = (from: Page, to: Page): void => {
    from.store.subscribe((now, before) => {
      const patch = passing_on ? {} : passed_on(from, to, now, before);
      if (!Object.keys(patch).length) return;
      passing_on = true;
      to.store.set(patch);
      passing_on = false;
    });
  };
  follow(a, b);
  follow(b, a);
}

/** The first story line that only one run has. */
function OtherLine({ pages }: { pages: Page[] }) {
  const page = use_page();
  const [a, b] = [pages[0]!, pages[1]!];
  const other = useMemo(() => first_other_line(a.run, b.run), [a, b]);
  if (!other) return <span class="dim" data-story-t="">Both have the same story.</span>;
  const of = pages[other.of]!;
  const { t, name, text, who } = of.run.story[other.line]!;
  const go = (): void => {
    const here = namesake(page, of.run.players[who]);
    if (here >= 0) select(page, here);
    jump(page, t);
  };
  return <button type="button" data-story-t={t} onClick={go}>the stories part at {clock_text(t)}, only in {of.letter}: {name} {reworded(text)}</button>;
}

function Parting({ pages, player, both, decision }: { pages: Page[]; player: Player; both: boolean; decision: Divergence | null }) {
  const page = use_page();
  if (pages.some(({ run }) => run.is_part)) return <div class="row parting"><div class="row-label" /><div class="row-plot dim">The runs are being flown again …</div></div>;
  return (
    <div class="row parting" data-divergence-step={decision?.step ?? ''} data-divergence-t={decision?.t ?? ''}>
      <div class="row-label" />
      <div class="row-plot">
        {decision
          ? <button type="button" title={decision.words} onClick={() => jump(page, decision.t)}>
              {player.name} parts at {clock_text(decision.t)}: {decision.words}
            </button>
          : <span class="dim">{both ? `${player.name} decides alike in both.` : `${player.name} is only in one of the runs.`}</span>}
        <OtherLine pages={pages} />
      </div>
    </div>
  );
}

export function CompareRows({ pages, player }: { pages: Page[]; player: Player }) {
  const there = pages.flatMap((page) => {
    const who = page.run.players[namesake(page, player)];
    return who ? [{ letter: page.letter, run: page.run, player: who }] : [];
  });
  const [a, b] = there;
  const decision = useMemo(() => (a && b ? first_difference(a, b) : null), [...pages, player.name]);
  return (
    <>
      {there.map(({ letter, run, player: who }) => (
        <LeaderRow key={letter} player={who} run={run} label={`${letter} ${who.name}`} cut={decision?.t} />
      ))}
      <Parting pages={pages} player={player} both={b !== undefined} decision={decision} />
    </>
  );
}

/** A player of a run. */
export interface Of {
  run: Run;
  player: Player;
}

export interface Divergence {
  t: number;
  step: number;
  words: string;  // "pursue led with 40, in B release_weapon with 60"
}

/** Numbers closer than this are what rounding left. */
const kSame = 1e-6;

function keys_of(run: Run): string[] {
  return run.shapes.map((shape) => {
    const tree = run.trees[shape.tree]!;
    const winners = shape.supplier[0] ? Array.from(shape.supplier[0], (node) => path_of(run, shape.tree, node)) : [];
    return [tree.name, path_of(run, shape.tree, shape.leader), shape.status.join(), shape.vote.join(), winners.join()].join('|');
  });
}

/** What went up for `field` at a decision, as words can be compared between runs. */
function root_value({ run, player }: Of, index: number, field: number): number | string | null {
  const shape = run.shapes[player.decisions.shape[index]!]!;
  const node = source_of(shape, 0, field);
  const value = node < 0 ? NaN : (player.decisions.value(node, field)?.[index] ?? NaN);
  if (Number.isNaN(value)) return null;
  return run.platforms[player.kind].action[field]!.kind === 'text' ? run.texts[value]! : value;
}

function other_field(a: Of, b: Of, index: number): number {
  return a.run.platforms[a.player.kind].action.findIndex((_, field) => {
    const [one, two] = [root_value(a, index, field), root_value(b, index, field)];
    return typeof one === 'number' && typeof two === 'number' ? Math.abs(one - two) > kSame : one !== two;
  });
}

function leader_words({ run, player }: Of, index: number): string {
  const shape = run.shapes[player.decisions.shape[index]!]!;
  return `${label_of(run, shape.tree, shape.leader)} with ${Number(shape.vote[0]!.toFixed(2))}`;
}

function words_of(a: Of, b: Of, index: number, field: number): string {
  const [one, two] = [leader_words(a, index), leader_words(b, index)];
  if (one !== two) return `${one} leads, in B ${two}`;
  if (field < 0) return 'another answer in the tree, the same action';
  const said = (of: Of): string => {
    const value = root_value(of, index, field);
    const about = of.run.platforms[of.player.kind].action[field]!;
    return value === null ? 'nothing' : typeof value === 'string' ? reworded(value) : value_text(of.run, about, value);
  };
  const { name } = a.run.platforms[a.player.kind].action[field]!;
  const [mine, its] = [said(a), said(b)];
  return mine === its ? `${name} ${mine} in both, but not to the last digit` : `${name} ${mine}, in B ${its}`;
}

/** Null: as long as both decide, they decide alike. */
export function first_difference(a: Of, b: Of): Divergence | null {
  const [da, db] = [a.player.decisions, b.player.decisions];
  const [ka, kb] = [keys_of(a.run), keys_of(b.run)];
  const count = Math.min(da.t.length, db.t.length);
  for (let i = 0; i < count; ++i) {
    const at = { t: Math.min(da.t[i]!, db.t[i]!), step: Math.min(da.step[i]!, db.step[i]!) };
    if (da.step[i] !== db.step[i]) return { ...at, words: 'from here on they decide at other times' };
    const field = other_field(a, b, i);
    if (ka[da.shape[i]!] !== kb[db.shape[i]!] || field >= 0) return { ...at, words: words_of(a, b, i, field) };
  }
  if (da.t.length === db.t.length) return null;
  const longer = da.t.length > db.t.length ? da : db;
  return { t: longer.t[count]!, step: longer.step[count]!, words: `only in ${longer === da ? 'A' : 'B'} does it go on deciding` };
}

/** The first story line that only one of the runs has: of the first (0) or of the second (1). */
export function first_other_line(a: Run, b: Run): { of: 0 | 1; line: number } | null {
  const key = (run: Run, line: number): string => {
    const { t, name, text } = run.story[line]!;
    return `${t.toFixed(1)}|${name}|${text}`;
  };
  // lines of one moment may stand in another order
  const lines = (run: Run): Set<string> => new Set(run.story.map((_, line) => key(run, line)));
  const [all_a, all_b] = [lines(a), lines(b)];
  const only = [a.story.findIndex((_, line) => !all_b.has(key(a, line))), b.story.findIndex((_, line) => !all_a.has(key(b, line)))] as const;
  const [t_a, t_b] = [a.story[only[0]]?.t ?? Infinity, b.story[only[1]]?.t ?? Infinity];
  if (t_a === t_b && t_a === Infinity) return null;
  const of = t_a <= t_b ? 0 : 1;
  return { of, line: only[of] };
}
