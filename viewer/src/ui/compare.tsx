// SPDX-License-Identifier: MIT
/** Two runs on one page: who led in both, one above the other, and where they part. */
import { useMemo } from 'preact/hooks';
import type { Player } from '../run/run.ts';
import type { View } from '../store.ts';
import { jump, select } from './actions.ts';
import { first_difference, first_other_line, type Divergence } from './divergence.ts';
import { clock_text } from './format.ts';
import { LeaderRow } from './leaders.tsx';
import { PageContext, use_page, type Page } from './page.ts';

/** The player of the same name; -1: there is none. */
function namesake(page: Page, player: Player | undefined): number {
  return page.run.players.findIndex((p) => p.name === player?.name);
}

/** What both views have in common; the other half of it is players of the same name. */
const kShared = ['time', 'playing', 'rate', 'camera', 'layers', 'zoom', 'theme'] as const;

/** What `to` must change because `from` did. */
function passed_on(from: Page, to: Page, now: View, before: View): Partial<View> {
  const patch: Partial<View> = {};
  for (const key of kShared) if (now[key] !== before[key]) Object.assign(patch, { [key]: now[key] });
  const named = (index: number): number => namesake(to, from.run.players[index]);
  if (now.selected !== before.selected && named(now.selected) >= 0) patch.selected = named(now.selected);
  if (now.ruler !== before.ruler) {
    const [one, two] = now.ruler ? now.ruler.map(named) : [];
    patch.ruler = one !== undefined && two !== undefined && one >= 0 && two >= 0 ? [one, two] : null;
  }
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

/** Where the decisions of `player` part; null: nowhere, or it is not in both. */
function use_divergence(pages: Page[], player: Player): { both: boolean; decision: Divergence | null } {
  const [a, b] = [pages[0]!, pages[1]!];
  return useMemo(() => {
    const [one, two] = [a, b].map((page) => page.run.players[namesake(page, player)]);
    const both = one !== undefined && two !== undefined;
    return { both, decision: both ? first_difference({ run: a.run, player: one }, { run: b.run, player: two }) : null };
  }, [a, b, player.name]);
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
  return <button type="button" data-story-t={t} onClick={go}>only in {of.letter} at {clock_text(t)}: {name} {text}</button>;
}

function Parting({ pages, player, both, decision }: { pages: Page[]; player: Player; both: boolean; decision: Divergence | null }) {
  const page = use_page();
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

/** The strip of either run, with the axis and the colours of this page. */
function OtherRow({ of, player, cut }: { of: Page; player: Player; cut: number | undefined }) {
  const page = use_page();
  const mixed = useMemo((): Page => ({ ...page, run: of.run }), [page, of]);
  return (
    <PageContext.Provider value={mixed}>
      <LeaderRow player={player} label={`${of.letter} ${player.name}`} cut={cut} />
    </PageContext.Provider>
  );
}

export function CompareRows({ pages, player }: { pages: Page[]; player: Player }) {
  const { both, decision } = use_divergence(pages, player);
  return (
    <>
      {pages.map((one) => {
        const who = one.run.players[namesake(one, player)];
        return who && <OtherRow key={one.letter} of={one} player={who} cut={decision?.t} />;
      })}
      <Parting pages={pages} player={player} both={both} decision={decision} />
    </>
  );
}
