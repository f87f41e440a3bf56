// SPDX-License-Identifier: MIT
/** Everybody in the run: side, type, what became of them, and who leads in their tree now. */
import { useEffect, useRef } from 'preact/hooks';
import { last_at, type Flight, type Player, type Run, type Side } from '../run/run.ts';
import { clock_text } from '../words/text.ts';
import { measure, select } from './actions.ts';
import { Chip, Name } from './leaders.tsx';
import { use_page } from './page.ts';
import { label_of } from './spans.ts';
import { use_paced, use_rove, use_view } from './use.ts';

export type Fate = 'not yet' | 'alive' | 'home' | 'lost' | 'unheard';
const kFates = { lost: '✕ lost', home: '⌂ home', unheard: 'silent' };

export function fate_at(player: Player, t: number): Fate {
  if (t < player.born - 1e-6) return 'not yet';
  return player.end && t >= player.gone - 1e-6 ? player.end : 'alive';
}

function leader_at(run: Run, player: Player, t: number): string {
  const shape = run.shapes[player.decisions.shape[last_at(player.decisions.t, t)]!];
  return shape ? label_of(run, shape.tree, shape.leader) : '';
}

/** "2 × F-15C, 1 × Su-27SM": the most first. */
export function types_text({ players }: Pick<Run, 'players'>, { members }: Pick<Flight, 'members'>): string {
  const counts = new Map<string, number>();
  for (const member of members) counts.set(players[member]!.type, (counts.get(players[member]!.type) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a).map(([type, count]) => `${count} × ${type}`).join(', ');
}

/** Round: blue; square: red; upright: neither. As in the air picture. */
export function SideMark({ side }: { side: Side }) {
  return <i class={`side-mark ${side}`} role="img" aria-label={side === 'none' ? 'no side' : side} />;
}

export function fate_words(fate: Fate, gone: number): string {
  return fate === 'not yet' || fate === 'alive' ? fate : `${kFates[fate]} ${clock_text(gone)}`;
}

function Line({ player }: { player: Player }) {
  const page = use_page();
  const { run, store } = page;
  const { name, index, side, type } = player;
  const selected = use_view(store, (v) => v.selected === index);
  const measured = use_view(store, (v) => v.ruler !== null && v.ruler.includes(index) && v.selected !== index);
  const fate = use_paced(store, ({ time }) => fate_at(player, time));
  const leader = use_paced(store, ({ time }) => leader_at(run, player, time));
  const key = index < 9 ? String(index + 1) : '';
  return (
    <li>
      <button type="button" class={`player ${fate} ${measured ? 'measured' : ''}`} aria-pressed={selected}
        data-player={name} data-state={fate} data-leader={leader}
        title={`${name}, ${type}: click selects; shift and click, the right button or a long touch shows range and bearing from the selected one`}
        onClick={(event) => (event.shiftKey ? measure(page, index) : select(page, index))}
        onContextMenu={(event) => { event.preventDefault(); measure(page, index); }}>
        <kbd>{key}</kbd><SideMark side={side} /><Name name={name} class={`name ${side}`} />
        {fate === 'alive'
          ? <span class="leads">{leader && <Chip label={leader} />}{leader}</span>
          : <span class={`fate ${fate}`}>{fate_words(fate, player.gone)}</span>}
      </button>
    </li>
  );
}

export function Players() {
  const { run, store } = use_page();
  const list = useRef<HTMLElement>(null);
  const selected = use_view(store, (v) => v.selected);
  use_rove(list);
  // the list itself moves, not the page around it
  useEffect(() => {
    const [box, line] = [list.current, list.current?.querySelector('[aria-pressed=true]')?.getBoundingClientRect()];
    if (!box || !line) return;
    const { top, bottom } = box.getBoundingClientRect();
    box.scrollTop += Math.max(0, line.bottom - bottom) - Math.max(0, top - line.top);
  }, [selected]);
  return (
    <section class="players" aria-label="Players" ref={list}>
      {run.flights.map((flight) => (
        <div key={flight.name}>
          <h2>
            <SideMark side={flight.side} /><span class="cut" title={flight.name}>{flight.name}</span>
            <span class="dim cut" title={types_text(run, flight)}>{types_text(run, flight)}</span>
          </h2>
          <ul>
            {flight.members.map((member) => <Line key={member} player={run.players[member]!} />)}
          </ul>
        </div>
      ))}
    </section>
  );
}
