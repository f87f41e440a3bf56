// SPDX-License-Identifier: MIT
/** The answer to what is asked of the trees: how many decisions would have been others, and the first one. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { words_of } from '../engine/module.ts';
import type { FirstOther, Outcome, WhatIf as Answer } from '../engine/questions.ts';
import { last_at, type Player } from '../run/run.ts';
import { kFlownOn, type Other } from '../scene/other.ts';
import { clock_text, count_text, outcome_text, reworded } from '../words/text.ts';
import { jump } from './actions.ts';
import { Chip } from './leaders.tsx';
import { use_page, type Page } from './page.ts';
import { use_cell } from './use.ts';
import {
  command_of, branch, stop_asking, use_answer, use_question, type Change, type FlownOn,
} from './what_if_answer.ts';

/** Where the clipboard is closed to a file, the words are at least marked. */
export async function copy_text(text: string, shown: HTMLElement | null): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    if (shown) getSelection()?.selectAllChildren(shown);
    return false;
  }
}

function Command({ command }: { command: string }) {
  const text = useRef<HTMLElement>(null);
  const [said, say] = useState('copy');
  const copy = async (): Promise<void> => {
    say((await copy_text(command, text.current)) ? 'copied' : 'marked');
    setTimeout(() => say('copy'), 1500);
  };
  return (
    <div class="command">
      <code ref={text}>{command}</code>
      <button type="button" aria-label="Copy the command for the terminal" onClick={() => void copy()}>{said}</button>
    </div>
  );
}

function Asked({ change, here }: { change: Change; here: boolean }) {
  const page = use_page();
  const undo = (): void => page.changes.set(page.changes.get().filter((other) => other !== change));
  const { label, type } = page.run.trees[change.tree]!.nodes[change.node]!;
  const words = [...(change.type ? [`${type} → ${change.type}`] : []), ...Object.entries(change.params).map(([name, value]) => `${name} ${value}`)];
  return (
    <li>
      {here ? <button type="button" class="link" onClick={() => page.node.set(change.node)}>{label}</button> : label} {words.join(', ')}
      <button type="button" class="quiet" aria-label={`${label} as flown`} onClick={undo}>✕</button>
    </li>
  );
}

function First({ first }: { first: FirstOther }) {
  const page = use_page();
  const time = first.time ?? 0;
  return (
    <>
      <p>
        The first: <button type="button" class="link" onClick={() => jump(page, time)}>{clock_text(time)}</button>,{' '}
        <Chip label={first.flown} />{first.flown}{first.flown === first.other
          ? ' leads as it did, with'
          : <> led, <Chip label={first.other} /><b>{first.other}</b> would have, with</>}
      </p>
      <table class="changed">
        <tbody>
          {first.fields.map(({ name, flown, other }) => (
            <tr key={name}><th scope="row">{name}</th><td class="dim">{reworded(flown)}</td><td>→</td><td>{reworded(other)}</td></tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

function Verdict({ player, answer, is_old }: { player: Player; answer: Answer; is_old: boolean }) {
  const share = (answer.different / Math.max(answer.decisions, 1)) * 100;
  const up_to = use_page().live && ` up to ${clock_text(answer.until ?? 0)}`;
  return (
    <div class={is_old ? 'old' : ''} aria-hidden={is_old}>
      <p class="verdict">
        <b>{count_text(answer.different)}</b> of {count_text(answer.decisions)} decisions of {player.name}{up_to} would have been others.
      </p>
      <div class="share" aria-hidden="true"><i style={{ width: `${share}%` }} /></div>
      {answer.fault && <p class="caution">⚠ With this change a run ends there, so nothing was asked after it: {answer.fault}</p>}
      {answer.first && <First first={answer.first} />}
    </div>
  );
}

function tally(of: Outcome): string {
  const side = (name: 'blue' | 'red'): string => `${name} lost ${of[name].losses}, shot ${of[name].shots}`;
  const how = of.outcome === 'running' ? 'not over' : outcome_text(of.outcome);
  return `${how} at ${clock_text(of.time ?? 0)}; ${side('blue')}; ${side('red')}`;
}

function show(page: Page, other: Other | null): void {
  page.other.set(other);
  const { time, zoom } = page.store.get();
  const end = Math.max(...[page.run, page.twin?.run, other?.run].map((run) => run?.about.duration ?? 0));
  page.store.set({ end, time: Math.min(time, end), zoom: zoom && zoom[1] > end ? null : zoom });
}

/** As if nothing had been flown on. */
export function forget(page: Page): void {
  const run = page.future.get()?.value?.run;
  page.future.set(null);  // whoever answers is too late
  // who comes after this one may have its own by then
  if (run && page.other.get()?.run === run) show(page, null);
}

/** Forgets what was flown on when something else is asked, whichever panels are shown. */
export function ForgetFuture() {
  const page = use_page();
  const changes = use_cell(page.changes);
  // while a mission is flown, the page is another object at each drawing
  useEffect(() => () => forget(page), [changes]);
  return null;
}

/** Of what takes long; where others fly the mission, too, its engine goes on with them. */
function Stop({ stop }: { stop: () => void }) {
  return use_page().live ? null : <button type="button" class="late" onClick={stop}>stop</button>;
}

function FlyingOn({ from }: { from: number }) {
  const page = use_page();
  const reached = use_cell(page.run.engine!.reached);
  const stop = (): void => {
    forget(page);
    page.run.engine!.stop('branch');
  };
  return <p class="dim">Flying on from {clock_text(from)}{reached > from && <span aria-hidden="true">, at {clock_text(reached)}</span>} … <Stop stop={stop} /></p>;
}

/** The other future from now on: how it ends, and in the air picture where everybody would be. It stays for whoever is selected. */
function FlyOn({ player, is_answered }: { player: Player; is_answered: boolean }) {
  const page = use_page();
  const changes = use_cell(page.changes);
  const future = use_cell(page.future);
  const fly = (): void => {
    const { time } = page.store.get();
    const { dt, steps } = page.run.about;
    // from the decision that is shown, as the terminal does
    const shown = time < player.gone ? player.decisions.step[last_at(player.decisions.t, time)] : undefined;
    const step = shown ?? Math.min(Math.round(time / dt), steps);
    forget(page);
    const mine: FlownOn = { from: step * dt };
    page.future.set(mine);
    branch(page.run, player.index, changes, step).then(
      (value) => {
        if (page.future.get() !== mine) return;
        page.future.set({ ...mine, value });
        show(page, { from: mine.from, run: value.run, label: kFlownOn });
      },
      (error: unknown) => page.future.get() === mine && page.future.set({ ...mine, problem: words_of(error) }),
    );
  };
  if (!future && !is_answered) return null;
  return (
    <div class="future" aria-live="polite">
      <button type="button" disabled={!is_answered} onClick={fly}>fly on from here with it</button>
      {future && !future.value && !future.problem && <FlyingOn from={future.from} />}
      {future?.problem && <p class="caution">⚠ {future.problem}</p>}
      {future?.value && (
        <>
          <dl data-outcome={future.value.other.outcome}>
            <dt>as flown</dt><dd>{tally(future.value.flown)}</dd>
            <dt>with it from {clock_text(future.from)}, hollow and broken in the air picture</dt><dd>{tally(future.value.other)}</dd>
          </dl>
          <button type="button" onClick={() => forget(page)}>only as flown</button>
        </>
      )}
    </div>
  );
}

interface Props {
  player: Player;
  tree: number;  // Index of the tree that is shown.
}

function Answered({ player, tree, asked }: Props & { asked: ReturnType<typeof use_answer> }) {
  const page = use_page();
  const changes = use_cell(page.changes);
  return (
    <>
      <header>
        <h3>What if</h3>
        <button type="button" onClick={() => page.changes.set([])}>reset</button>
      </header>
      <ul class="asked-list">
        {changes.map((change) => <Asked key={`${change.tree}/${change.node}`} change={change} here={change.tree === tree} />)}
      </ul>
      {asked?.is_old && <p class="dim">asking … <Stop stop={() => stop_asking(page)} /></p>}
      {asked?.problem && !asked.is_old && <p class="caution">⚠ {asked.problem}</p>}
      {asked?.value && <Verdict player={player} answer={asked.value} is_old={asked.is_old} />}
      <FlyOn player={player} is_answered={asked?.value !== undefined && !asked.is_old} />
      <p class="dim small">The states stay those that were flown. The same question for the terminal:</p>
      <Command command={command_of(page.run, player.index, changes)} />
    </>
  );
}

export function WhatIf({ player, tree }: Props) {
  const page = use_page();
  const changes = use_cell(page.changes);
  const asked = use_answer();
  const answer = asked?.value;
  const question = use_question();
  return (
    <section class={`what-if ${changes.length ? 'asked' : ''}`} aria-label="What if" aria-live="polite"
      data-asked={question?.key ?? ''} data-answered={asked?.key ?? ''} data-decisions={answer?.decisions ?? ''} data-different={answer?.different ?? ''}
      data-first-step={answer?.first?.step ?? ''} data-first-flown={answer?.first?.flown ?? ''}
      data-first-other={answer?.first?.other ?? ''}>
      {changes.length
        ? <Answered player={player} tree={tree} asked={asked} />
        : <p class="dim small">{page.run.engine
            ? 'Choose a node of the tree to give it another arbiter, vote or parameter, and see who would have led.'
            : 'This page carries what was recorded, without the engine: ask the terminal what if.'}</p>}
    </section>
  );
}
