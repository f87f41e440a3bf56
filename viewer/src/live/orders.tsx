// SPDX-License-Identifier: MIT
/** Orders for the chosen player, or for his flight, while the mission goes on; each is kept in the run. */
import { useEffect, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import { select } from '../ui/actions.ts';
import { use_page } from '../ui/page.ts';
import { use_cell, use_view } from '../ui/use.ts';
import type { Live } from './live.ts';

export function Orders({ live }: { live: Live }) {
  const page = use_page();
  const { run, store } = page;
  const player = run.players[use_view(store, (v) => v.selected)]!;
  const flight = run.flights[player.flight]!;
  const [whole, set_whole] = useState(false);
  const [sure, set_sure] = useState('');
  const wanted = use_cell(live.hands.wanted);
  const pointing = use_cell(live.pointing);
  use_cell(live.status);
  const gone = player.end !== '' || live.is_over();
  const aircraft = player.kind === 'aircraft';
  const whom = whole ? { flight: flight.name } : { player: player.name };
  const now = run.shapes[player.decisions.shape.at(-1) ?? -1]?.tree;
  const trees = run.trees.filter(({ kind }) => kind === player.kind);

  useEffect(() => {
    if (!pointing || !live.scene) return;
    const { scene } = live;
    scene.point = (place) => {
      live.pointing.set(false);
      live.order('point', { ...whom, east: Math.round(place.east), north: Math.round(place.north), altitude: Math.round(player.motion.up.at(-1)!) });
    };
    const stop = listen(window, { keydown: (event) => event.key === 'Escape' && live.pointing.set(false) });
    return () => {
      scene.point = null;
      stop();
    };
  }, [pointing, player.name, whole]);

  return (
    <section class="orders" aria-label={`Orders for ${whole ? flight.name : player.name}`}>
      {wanted && wanted.player === player.index
        ? <button type="button" class="take on" onClick={() => live.hands.hand_back()}>Hand back</button>
        : <button type="button" class="take" disabled={gone || !aircraft} title="Fly it yourself: arrows, + −, space; the tree goes on proposing"
            onClick={() => { if (wanted) live.hands.hand_back(); select(page, player.index); live.hands.take(); }}>Take over</button>}
      <select aria-label="Another tree" title="From now on by another tree" value="" disabled={gone}
        onChange={(event) => { live.order('tree', { ...whom, tree: event.currentTarget.value }); event.currentTarget.value = ''; }}>
        <option value="">tree …</option>
        {trees.map(({ name }, i) => <option key={name} value={name} disabled={run.trees.indexOf(trees[i]!) === now}>{name}</option>)}
      </select>
      {aircraft && <>
        <button type="button" disabled={gone} aria-pressed={pointing} title="Fly to a point instead of the route: click in the air picture" onClick={() => live.pointing.set(!pointing)}>point</button>
        <button type="button" disabled={gone} title="Its route again" onClick={() => live.order('route', whom)}>route</button>
        <button type="button" disabled={gone} title="Weapons tight: nothing is shot" onClick={() => live.order('weapons', { ...whom, free: false })}>tight</button>
        <button type="button" disabled={gone} title="Weapons free" onClick={() => live.order('weapons', { ...whom, free: true })}>free</button>
      </>}
      {sure === (whole ? flight.name : player.name)
        ? <><button type="button" class="bad" onClick={() => { live.order('lose', whom); set_sure(''); }}>kill {sure}</button><button type="button" onClick={() => set_sure('')}>no</button></>
        : <button type="button" disabled={gone} title="Lost, to something that is not simulated" onClick={() => set_sure(whole ? flight.name : player.name)}>kill …</button>}
      {flight.members.length > 1 && (
        <label class="small"><input type="checkbox" checked={whole} onChange={() => set_whole(!whole)} />all of {flight.name}</label>
      )}
    </section>
  );
}

/** Another vote for a node of the tree that is flown now. */
export function VoteOrder({ live, player, tree, node, vote }: { live: Live; player: string; tree: string; node: string; vote: number }) {
  const [text, set_text] = useState('');
  useEffect(() => set_text(''), [player, node]);
  const value = Number(text);
  return (
    <form class="vote-order" onSubmit={(event) => { event.preventDefault(); live.order('vote', { player, tree, node, vote: value }); set_text(''); }}>
      <label>vote from now on <input type="text" inputMode="decimal" size={4} value={text} placeholder={String(vote)} aria-label={`Vote of ${node} from now on`}
        onInput={(event) => set_text(event.currentTarget.value)} /></label>
      <button type="submit" disabled={live.is_over() || text.trim() === '' || !(value >= 0)}>order</button>
    </form>
  );
}
