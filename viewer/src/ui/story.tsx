// SPDX-License-Identifier: MIT
/** What happened, in words; the present is marked, a click goes there. */
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Run, StoryLine } from '../run/run.ts';
import { jump, select } from './actions.ts';
import { clock_text } from './format.ts';
import { Glyph } from './icon.tsx';
import { mark_of } from './marks.ts';
import { memo_by } from './memo.ts';
import { use_page } from './page.ts';
import { use_paced } from './use.ts';

export interface Filter {
  /** Index into Run.players; -1: everybody. */
  who: number;
  /** "" is every kind. */
  kind: string;
  text: string;
}

/** Indices of the lines that pass. */
export function filtered(run: Run, { who, kind, text }: Filter): number[] {
  const wanted = text.trim().toLowerCase();
  const name = run.players[who]?.name;
  const passes = (line: StoryLine): boolean =>
    (!name || line.who === who || line.text.includes(name)) && (!kind || line.kind === kind) &&
    (!wanted || `${line.name} ${line.text}`.toLowerCase().includes(wanted));
  return run.story.flatMap((line, i) => (passes(line) ? [i] : []));
}

/** The position in `lines` of the last one at or before `t`; -1: none. */
function current(run: Run, lines: number[], t: number): number {
  let at = -1;
  while (at + 1 < lines.length && run.story[lines[at + 1]!]!.t <= t + 0.011) ++at;
  return at;
}

function Filters({ filter, onChange }: { filter: Filter; onChange: (filter: Filter) => void }) {
  const { run } = use_page();
  const kinds = useMemo(() => [...new Set(run.story.map((line) => line.kind))].sort(), [run]);
  return (
    <div class="filters">
      <input type="search" placeholder="filter" aria-label="Filter the story by text" value={filter.text}
        onInput={(event) => onChange({ ...filter, text: event.currentTarget.value })} />
      <select aria-label="Story of whom" value={filter.who}
        onChange={(event) => onChange({ ...filter, who: Number(event.currentTarget.value) })}>
        <option value={-1}>everybody</option>
        {run.players.map(({ name, index }) => <option key={name} value={index}>{name}</option>)}
      </select>
      <select aria-label="Kind of events" value={filter.kind}
        onChange={(event) => onChange({ ...filter, kind: event.currentTarget.value })}>
        <option value="">all kinds</option>
        {kinds.map((kind) => <option key={kind} value={kind}>{kind.replaceAll('_', ' ')}</option>)}
      </select>
    </div>
  );
}

function Told({ line, is_now, passed }: { line: number; is_now: boolean; passed: boolean }) {
  const page = use_page();
  const { t, who, name, text, tone, kind } = page.run.story[line]!;
  const mark = mark_of(page.run, line);
  const go = (): void => {
    if (who >= 0) select(page, who);
    jump(page, t);
  };
  return (
    <li>
      <button type="button" class={`told tone-${tone} ${passed ? 'passed' : ''}`} aria-current={is_now ? 'true' : undefined}
        data-t={t} data-kind={kind} onClick={go}>
        <time>{clock_text(t)}</time>
        <Glyph kind={mark?.kind ?? null} side={mark?.side ?? ''} />
        <span><b class={page.run.players[who]?.side ?? 'none'}>{name}</b> {text}</span>
      </button>
    </li>
  );
}

/** Drawn anew only when it passes: a big fight has thousands of lines. */
const Line = memo_by(Told);

export function Story() {
  const page = use_page();
  const { run, store } = page;
  const list = useRef<HTMLOListElement>(null);
  const [filter, set_filter] = useState<Filter>({ who: -1, kind: '', text: '' });
  const lines = useMemo(() => filtered(run, filter), [run, filter]);
  const at = use_paced(store, ({ time }) => current(run, lines, time));
  const still = useRef(false);
  useEffect(() => {
    // whoever reads in it is not pulled away
    if (still.current) return;
    const line = list.current!.children[Math.max(at, 0)] as HTMLElement | undefined;
    if (line) list.current!.scrollTop = line.offsetTop - list.current!.clientHeight / 2;
  }, [at, lines]);
  return (
    <section class="story" aria-label="Story">
      <Filters filter={filter} onChange={set_filter} />
      <ol ref={list} onPointerEnter={() => (still.current = true)} onPointerLeave={() => (still.current = false)}>
        {lines.map((line, i) => <Line key={line} line={line} is_now={i === at} passed={i <= at} />)}
      </ol>
      {!lines.length && <p class="dim small">Nothing of that kind happened.</p>}
    </section>
  );
}
