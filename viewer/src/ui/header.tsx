// SPDX-License-Identifier: MIT
/** Which run this is, and what concerns the whole page. */
import { useEffect, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import { Pace } from '../live/controls.tsx';
import type { Run } from '../run/run.ts';
import type { Cell } from '../store.ts';
import { clock_text, count_text, number_text, outcome_text } from '../words/text.ts';
import { toggle_theme } from './actions.ts';
import { IconButton } from './icon.tsx';
import { link_text, not_understood } from './link.ts';
import { use_page, type Page } from './page.ts';
import { use_view } from './use.ts';
import { copy_text } from './what_if.tsx';

/** "release_weapon.zone=1.8" of an override: where it is cut, its end says more than its beginning. */
const end_of = (set: string): string => /(?:[^.=]+\.)?[^.=]*=.*/s.exec(set)?.[0] ?? set;

function About({ page: { run, letter, live, twin } }: { page: Page }) {
  const { about } = run;
  const other = twin?.run.about;
  const is_namesake = about.scenario === other?.scenario;
  const own = is_namesake ? about.sets.filter((set) => !other?.sets.includes(set)) : [];
  const decisions = run.players.reduce((sum, player) => sum + player.decisions.t.length, 0);
  const verified = run.engine && !run.is_part && !live ? `✓ same bits${run.verified ? ' as in the results' : ''}` : '';
  const why = `Flown again in this page: ${run.verified ?? 'every hash is the one that was recorded'}`;
  const facts: [string, string][] = [
    ['file', about.file], ['seed', about.seed], ...(about.sets.length ? [['set', about.sets.join(', ')] as [string, string]] : []),
    ['outcome', outcome_text(about.outcome)], ['duration', clock_text(about.duration)],
    ['steps', `${count_text(about.steps)} of ${number_text(about.dt, 4)} s`],
    ['decisions', `${count_text(decisions)}, one each ${number_text(about.decision_period, 3)} s${about.thinned ? ', thinned' : ''}`],
    ['hash', about.hash], ['program', about.build], ...(verified ? [['bits', `${verified}. ${why}`] as [string, string]] : []),
  ];
  return (
    <details class="menu about">
      <summary title="About the run">
        {letter && <b class="letter">{letter}</b>}<b>{about.scenario}</b>{is_namesake && <span>seed {about.seed}</span>}{own.length > 0 && <span class="own" title={own.join('\n')}>{own.map(end_of).join(', ')}</span>}<span class="dim">{outcome_text(about.outcome)}</span>
        {run.is_part && <span class="verified" role="status">flying it again …</span>}
        {verified && <span class="verified" title={why}>{verified}</span>}
      </summary>
      <div class="menu-body">
        <p>{about.help}</p>
        <dl>{facts.map(([name, value]) => <div key={name}><dt>{name}</dt><dd>{value}</dd></div>)}</dl>
      </div>
    </details>
  );
}

/** What of the address was not understood, until somebody has read it. */
function LinkNote({ run }: { run: Run }) {
  const [left_out, put] = useState(() => not_understood(run, location.hash));
  useEffect(() => listen(window, { hashchange: () => put(not_understood(run, location.hash)) }), [run]);
  if (!left_out.length) return null;
  return (
    <span class="link-note small" role="alert">
      The link says {left_out.join(', ').slice(0, 60)}, which is not understood
      <button type="button" class="quiet" aria-label="Close what is said of the link" onClick={() => put([])}>✕</button>
    </span>
  );
}

function ShareLink() {
  const { run, store } = use_page();
  const [said, say] = useState('');
  const share = async (): Promise<void> => {
    const moment = new URL(link_text(run, store.get(), location.hash), location.href);
    say((await copy_text(moment.href, null)) ? 'link copied' : 'the address bar has the link');
    setTimeout(() => say(''), 1800);
  };
  return (
    <>
      <span class="dim small" role="status">{said}</span>
      <IconButton icon="link" label="Copy a link to this moment" onClick={() => void share()} />
    </>
  );
}

export function Logo() {
  return (
    <svg class="logo" viewBox="0 0 24 16" aria-hidden="true">
      <path d="M1 3C6 3 9 5 12 10C15 5 18 3 23 3C18.5 5 16.5 8 14.5 12L12 14.5L9.5 12C7.5 8 5.5 5 1 3Z" />
    </svg>
  );
}

/** Where the page was opened from, and how to go back there. */
export interface Back {
  label: string;
  go: () => void;
}

export function Header({ pages, active, back, help, panels, onSwitch, ghosts, onGhosts }: {
  pages: Page[]; active: Page; back: Back | undefined; help: Cell<boolean>; onSwitch: (page: Page) => void;
  ghosts: boolean; onGhosts: (wanted: boolean) => void;
  panels: { panel: 'left' | 'bottom' | 'right'; label: string; shown: boolean; flip: () => void }[];
}) {
  const theme = use_view(active.store, (v) => v.theme);
  return (
    <header class="top">
      <h1><Logo />Eyrie</h1>
      {back && <button type="button" class="back" onClick={back.go}>← {back.label}</button>}
      {pages.map((page) => <About key={page.letter} page={page} />)}
      {active.live && <Pace live={active.live} />}
      <span class="spring" />
      <LinkNote run={pages[0]!.run} />
      {pages.length > 1 && (
        <div class="segments" role="group" aria-label="Whose panels are shown">
          {pages.map((page) => (
            <button type="button" key={page.letter} aria-pressed={page === active} aria-label={`Panels of run ${page.letter}`}
              onClick={() => onSwitch(page)}>{page.letter}</button>
          ))}
          <button type="button" aria-pressed={ghosts} title="One picture, with the other run hollow and broken in it" onClick={() => onGhosts(!ghosts)}>ghosts</button>
        </div>
      )}
      {panels.map(({ panel, label, shown, flip }) => (
        <IconButton key={panel} icon={panel} label={shown ? `Hide: ${label}` : `Show: ${label}`} pressed={shown} onClick={flip} />
      ))}
      <ShareLink />
      <IconButton icon={theme === 'dark' ? 'sun' : 'moon'} label={theme === 'dark' ? 'Light' : 'Dark'} keys="t"
        onClick={() => toggle_theme(active)} />
      <IconButton icon="help" label="Keyboard and pointer" keys="?" onClick={() => help.set(true)} />
    </header>
  );
}
