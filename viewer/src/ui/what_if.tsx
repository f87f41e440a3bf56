// SPDX-License-Identifier: MIT
/** The answer to what is asked of the trees: how many decisions would have been others, and the first one. */
import { useRef, useState } from 'preact/hooks';
import { command_of, type Change, type WhatIfResult } from '../decide/what_if.ts';
import type { Player } from '../run/run.ts';
import { jump } from './actions.ts';
import { clock_text, count_text } from './format.ts';
import { Chip } from './leaders.tsx';
import { use_page } from './page.ts';
import { use_cell } from './use.ts';
import { use_answer } from './what_if_answer.ts';

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
  const words = [
    ...(change.type ? [`${type} → ${change.type}`] : []),
    ...(change.vote !== undefined ? [`votes ${change.vote}`] : []),
    ...Object.entries(change.params ?? {}).map(([name, value]) => `${name} ${value}`),
  ];
  return (
    <li>
      {here ? <button type="button" class="link" onClick={() => page.node.set(change.node)}>{label}</button> : label} {words.join(', ')}
      <button type="button" class="quiet" aria-label={`${label} as flown`} onClick={undo}>✕</button>
    </li>
  );
}

function First({ first }: { first: NonNullable<WhatIfResult['first']> }) {
  const page = use_page();
  return (
    <>
      <p>
        The first: <button type="button" class="link" onClick={() => jump(page, first.t)}>{clock_text(first.t)}</button>,{' '}
        <Chip label={first.flown} />{first.flown}{first.flown === first.other
          ? ' leads as it did, with'
          : <> led, <Chip label={first.other} /><b>{first.other}</b> would have, with</>}
      </p>
      <table class="changed">
        <tbody>
          {first.fields.map(({ name, flown, other }) => (
            <tr key={name}><th scope="row">{name}</th><td class="dim">{flown}</td><td>→</td><td>{other}</td></tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

interface Props {
  player: Player;
  /** Index of the tree that is shown. */
  tree: number;
}

function Answered({ player, tree, answer }: Props & { answer: WhatIfResult }) {
  const page = use_page();
  const changes = use_cell(page.changes);
  const share = (answer.different / Math.max(answer.decisions, 1)) * 100;
  return (
    <>
      <header>
        <h3>What if</h3>
        <button type="button" onClick={() => page.changes.set([])}>reset</button>
      </header>
      <ul class="asked-list">
        {changes.map((change) => <Asked key={`${change.tree}/${change.node}`} change={change} here={change.tree === tree} />)}
      </ul>
      <p class="verdict">
        <b>{count_text(answer.different)}</b> of {count_text(answer.decisions)} decisions of {player.name} would have been others.
      </p>
      <div class="share" aria-hidden="true"><i style={{ width: `${share}%` }} /></div>
      {answer.first && <First first={answer.first} />}
      {answer.unknown > 0 && <p class="caution">⚠ {count_text(answer.unknown)} cannot be said here: {answer.why_unknown}</p>}
      {answer.caution && <p class="caution">⚠ {answer.caution}</p>}
      <p class="dim small">The states stay those that were flown. The same question for the terminal:</p>
      <Command command={command_of(page.run, player.index, changes)} />
    </>
  );
}

export function WhatIf({ player, tree }: Props) {
  const answer = use_answer();
  const first = answer?.first;
  return (
    <section class={`what-if ${answer ? 'asked' : ''}`} aria-label="What if" aria-live="polite"
      data-decisions={answer?.decisions ?? ''} data-different={answer?.different ?? ''} data-unknown={answer?.unknown ?? ''}
      data-first-step={first ? player.decisions.step[first.index] : ''} data-first-flown={first?.flown ?? ''}
      data-first-other={first?.other ?? ''}>
      {answer
        ? <Answered player={player} tree={tree} answer={answer} />
        : <p class="dim small">Choose a node of the tree to give it another arbiter or another vote, and see who would have led.</p>}
    </section>
  );
}
