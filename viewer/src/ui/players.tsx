// SPDX-License-Identifier: MIT
/** Everybody in the run: side, type, what became of them, and who leads in their tree now. */
import { memo_by } from './memo.ts';
import { last_at, type Player, type Run, type Side } from '../run/run.ts';
import { measure, select } from './actions.ts';
import { clock_text } from './format.ts';
import { Chip } from './leaders.tsx';
import { use_page, type Page } from './page.ts';
import { label_of } from './spans.ts';
import { use_paced, use_view } from './use.ts';

export type Fate = 'not yet' | 'alive' | 'home' | 'lost';

export function fate_at(player: Player, t: number): Fate {
  if (t < player.born - 1e-6) return 'not yet';
  return player.end && t >= player.gone - 1e-6 ? player.end : 'alive';
}

function leader_at(run: Run, player: Player, t: number): string {
  const shape = run.shapes[player.decisions.shape[last_at(player.decisions.t, t)]!];
  return shape ? label_of(run, shape.tree, shape.leader) : '';
}

/** Round: blue; square: red; upright: neither. As in the air picture. */
export function SideMark({ side }: { side: Side }) {
  return <i class={`side-mark ${side}`} role="img" aria-label={side === 'none' ? 'no side' : side} />;
}

export function fate_words(fate: Fate, gone: number): string {
  return fate === 'not yet' ? fate : `${fate === 'lost' ? '✕ lost' : '⌂ home'} ${clock_text(gone)}`;
}

interface Entry {
  page: Page;
  player: Player;
  selected: boolean;
  measured: boolean;
  fate: Fate;
  leader: string;
}

/** Most stay as they are from one redraw to the next. */
const Line = memo_by(function Line({ page, player, selected, measured, fate, leader }: Entry) {
  const { name, index, side, type } = player;
  const key = index < 9 ? String(index + 1) : '';
  return (
    <li>
      <button type="button" class={`player ${fate} ${measured ? 'measured' : ''}`} aria-pressed={selected}
        data-player={name} data-state={fate} data-leader={leader}
        aria-label={`${name}, ${side}, ${type}, ${fate}${fate === 'alive' && leader ? `, ${leader} leads` : ''}`}
        title={`${name}: click selects, shift and click shows range and bearing from the selected one`}
        onClick={(event) => (event.shiftKey ? measure(page, index) : select(page, index))}>
        <kbd>{key}</kbd><SideMark side={side} /><span class={`name ${side}`}>{name}</span>
        {fate === 'alive'
          ? <span class="leads">{leader && <Chip label={leader} />}{leader}</span>
          : <span class={`fate ${fate}`}>{fate_words(fate, player.gone)}</span>}
      </button>
    </li>
  );
});

export function Players() {
  const page = use_page();
  const { run, store } = page;
  const selected = use_view(store, (v) => v.selected);
  const ruler = use_view(store, (v) => v.ruler);
  // one text for all that is shown, so that the list is redrawn only if something in it changed
  const state = use_paced(store, ({ time }) => run.players.map((p) => `${fate_at(p, time)}|${leader_at(run, p, time)}`).join('\n'));
  const lines = state.split('\n').map((line) => line.split('|') as [Fate, string]);
  return (
    <section class="players" aria-label="Players">
      {run.flights.map((flight) => (
        <div key={flight.name}>
          <h3>
            <SideMark side={flight.side} />{flight.name}
            <span class="dim">{flight.members.length} × {run.players[flight.members[0]!]?.type}</span>
          </h3>
          <ul>
            {flight.members.map((member) => {
              const [fate, leader] = lines[member]!;
              return <Line key={member} page={page} player={run.players[member]!} selected={member === selected} fate={fate} leader={leader}
                measured={ruler !== null && ruler.includes(member) && member !== selected} />;
            })}
          </ul>
        </div>
      ))}
    </section>
  );
}
