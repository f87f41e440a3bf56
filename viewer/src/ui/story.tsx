// SPDX-License-Identifier: MIT
/** What happened, in words, where the present is marked and a click goes there; and the key moments of it, each of which leads to the
 * decision it comes of: the first shot, why somebody was lost, who took the lead, which phase began. */
import { options } from 'preact';
import { useEffect, useLayoutEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import type { Run, StoryLine } from '../run/run.ts';
import { clock_text, reworded } from '../words/text.ts';
import { show_cause } from './actions.ts';
import { Glyph } from './icon.tsx';
import { mark_of } from './marks.ts';
import { type Page, use_page } from './page.ts';
import { use_paced, use_rove } from './use.ts';

export interface Filter {
  who: number;  // Index into Run.players; -1: everybody.
  kind: string;  // "" is every kind.
  text: string;
}

/** Indices of the lines that pass. */
export function filtered(run: Run, { who, kind, text }: Filter): number[] {
  const wanted = text.trim().toLowerCase();
  const name = run.players[who]?.name;
  const named = new RegExp(`(?<!\\w)${name}(?!\\w)`);
  const passes = (line: StoryLine): boolean =>
    (!name || line.who === who || named.test(line.text)) && (!kind || line.kind === kind) &&
    (!wanted || `${line.name} ${line.text}`.toLowerCase().includes(wanted));
  return run.story.flatMap((line, i) => (passes(line) ? [i] : []));
}

/** The position in `lines` of the last one that has happened, or has been decided, by `t`; -1: none. */
function current(run: Run, lines: number[], t: number): number {
  const next = lines.findIndex((line) => Math.min(run.story[line]!.t, run.story[line]!.decided) > t + 0.011);
  return (next < 0 ? lines.length : next) - 1;
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

function Told({ page, line }: { page: Page; line: number }) {
  const { t, who, name, text, tone, kind } = page.run.story[line]!;
  const mark = mark_of(page.run, line);
  return (
    <li>
      <button type="button" class={`told tone-${tone}`} data-t={t} data-kind={kind}
        onClick={() => show_cause(page, line)}>
        <time>{clock_text(t)}</time>
        <Glyph kind={mark?.kind ?? null} side={mark?.side ?? ''} />
        <span><b class={page.run.players[who]?.side ?? 'none'}>{name}</b> {reworded(text)}</span>
      </button>
    </li>
  );
}

/** A big fight has thousands of lines: so many around the present stand in the list, and move on before it reaches their end. */
const kStretch = 240;
const kMargin = 40;

interface Stretch {
  first: number;
  last: number;
}

/** What of so many lines is shown when the present is at `at`; the same object as long as nothing need change. */
export function stretch_of(at: number, total: number, now: Stretch): Stretch {
  const last = Math.min(now.last, total);
  const inside = at >= (now.first > 0 ? now.first + kMargin : -1) && at < (last < total ? last - kMargin : total);
  if (inside && (last === total || last - now.first >= kStretch)) return last === now.last ? now : { first: now.first, last };
  const first = Math.max(0, Math.min(at - kStretch / 2, total - kStretch));
  return { first, last: Math.min(total, first + kStretch) };
}

/** Writes on the lines in the list, of which the first is number `first`, which have passed and which is now. */
function write_present(list: HTMLElement, first: number, now: number): void {
  const lines = list.querySelectorAll('.told');
  lines.forEach((told, i) => {
    told.classList.toggle('passed', first + i <= now);
    if (first + i === now) told.setAttribute('aria-current', 'true');
    else told.removeAttribute('aria-current');
  });
}

function More({ count, where, onClick }: { count: number; where: 'earlier' | 'later'; onClick: () => void }) {
  return count > 0 ? <li><button type="button" class="more" onClick={onClick}>{`${count} ${where}`}</button></li> : null;
}

export function Story() {
  const page = use_page();
  const { run, store } = page;
  const list = useRef<HTMLOListElement>(null);
  const [filter, set_filter] = useState<Filter>({ who: -1, kind: '', text: '' });
  const lines = useMemo(() => filtered(run, filter), [run, filter]);
  const at = use_paced(store, ({ time }) => current(run, lines, time));
  const still = useRef(false);
  use_rove(list);
  const stretch = useRef<Stretch>({ first: 0, last: kStretch });
  const [, redraw] = useReducer((n: number) => n + 1, 0);
  // on paper all of it stands, and at once: the browser does not wait
  const printed = useRef(false);
  useEffect(() => {
    const draw = (is_printed: boolean) => (): void => {
      const { debounceRendering } = options;
      options.debounceRendering = (render) => render();
      printed.current = is_printed;
      redraw(undefined);
      options.debounceRendering = debounceRendering;
    };
    return listen(window, { beforeprint: draw(true), afterprint: draw(false) });
  }, []);
  // whoever reads in it is not pulled away
  if (!still.current || stretch.current.last > lines.length) stretch.current = stretch_of(at, lines.length, stretch.current);
  const { first, last } = printed.current ? { first: 0, last: lines.length } : stretch.current;
  // drawn once; where the present is in them is written on them afterwards
  const shown = useMemo(() => lines.slice(first, last).map((line) => <Told key={line} page={page} line={line} />),
    [page, lines, first, last]);
  const widen = (earlier: number, later: number): void => {
    stretch.current = { first: Math.max(0, first - earlier), last: Math.min(lines.length, last + later) };
    redraw(undefined);
  };
  useLayoutEffect(() => write_present(list.current!, first, at), [at, first, shown]);
  useEffect(() => {
    if (still.current) return;
    const line = list.current!.querySelectorAll<HTMLElement>('.told')[Math.max(at - first, 0)];
    const place = line?.parentElement;
    if (place) list.current!.scrollTop = place.offsetTop - list.current!.clientHeight / 2;
  }, [at, shown]);
  return (
    <section class="story" aria-label="Story">
      <Filters filter={filter} onChange={set_filter} />
      <ol ref={list} onPointerEnter={() => (still.current = true)} onPointerLeave={() => (still.current = false)}>
        <More count={first} where="earlier" onClick={() => widen(kStretch, 0)} />
        {shown}
        <More count={lines.length - last} where="later" onClick={() => widen(0, kStretch)} />
      </ol>
      {!lines.length && <p class="dim small">Nothing of that kind happened.</p>}
    </section>
  );
}

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
