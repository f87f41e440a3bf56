// SPDX-License-Identifier: MIT
/** The key moments of a run, each of which leads to the decision it comes of: the first shot, why somebody was lost, who took the lead,
 * which phase began. */
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Run } from '../run/run.ts';
import { clock_text, reworded } from '../words/text.ts';
import { show_cause } from './actions.ts';
import { Glyph } from './icon.tsx';
import { mark_of } from './marks.ts';
import { use_page } from './page.ts';
import { use_paced, use_rove } from './use.ts';

export interface Moment {
  line: number;  // Index into Run.story.
  title: string;
  text: string;
}

const kMost = 12;
/** s: before it phases begin because the run does. */
const kBegun = 1;

/** In order of time; of many those that matter most. */
export function moments_of({ story, players }: Run): Moment[] {
  const lines = (...kinds: string[]): number[] => story.flatMap(({ kind, t }, i) => (kinds.includes(kind) && (kind !== 'phase' || t > kBegun) ? [i] : []));
  const told = (title: (line: number) => string) => (line: number): Moment => ({ line, title: title(line), text: `${story[line]!.name} ${story[line]!.text}` });
  const victim = (line: number): string => players[story[line]!.decider]?.name ?? story[line]!.name;
  const all = [
    ...lines('launch', 'gun_burst').slice(0, 1).map(told(() => 'First shot')),
    ...lines('kill', 'crash', 'loss').map(told((line) => `Why did ${victim(line)} die?`)),
    ...lines('lead_change').map(told(() => 'The lead changes')),
    ...lines('phase').map((line): Moment => ({ line, title: 'A phase begins', text: story[line]!.text })),
  ];
  return all.slice(0, kMost).sort((a, b) => a.line - b.line);
}

/** Where the page opens: at the first shot, or else what was lost, or whatever comes first; -1: nothing happened. */
export function first_moment(run: Run): number {
  const moments = moments_of(run);
  const first = (all: Moment[]): Moment | undefined => {
    const of = (...kinds: string[]): Moment | undefined => all.find(({ line }) => kinds.includes(run.story[line]!.kind));
    return of('launch', 'gun_burst') ?? of('kill', 'crash', 'loss') ?? all[0];
  };
  // whom another program flies decides nothing here
  const ours = moments.filter(({ line }) => !run.players[run.story[line]!.decider]?.remote);
  return (first(ours) ?? first(moments))?.line ?? -1;
}

export function Moments() {
  const page = use_page();
  const { run, store } = page;
  const moments = useMemo(() => moments_of(run), [run]);
  const list = useRef<HTMLOListElement>(null);
  use_rove(list, 'ArrowLeft', 'ArrowRight');
  const now = use_paced(store, ({ time }) => moments.findLast(({ line }) => run.story[line]!.decided <= time + 0.01)?.line ?? -1);
  useEffect(() => {
    const [row, one] = [list.current, list.current?.querySelector<HTMLElement>('[aria-current=true]')];
    if (row && one) row.scrollLeft = one.offsetLeft - row.offsetLeft - (row.clientWidth - one.clientWidth) / 2;
  }, [now, moments]);
  if (!moments.length) return null;
  return (
    <nav class="moments" aria-label="Key moments">
      <ol ref={list}>
        {moments.map(({ line, title, text }) => {
          const { t } = run.story[line]!;
          const mark = mark_of(run, line)!;
          return (
            <li key={line}>
              <button type="button" class="moment" data-moment={mark.kind} aria-current={line === now} title={`${reworded(text)}: shows the decision it comes of`}
                onClick={() => show_cause(page, line)}>
                <b><Glyph kind={mark.kind} side={mark.side} />{title}</b>
                <span><time>{clock_text(t)}</time> {reworded(text)}</span>
              </button>
            </li>
          );
        })}
      </ol>
    </nav>
  );
}
