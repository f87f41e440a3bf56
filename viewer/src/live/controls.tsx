// SPDX-License-Identifier: MIT
/** What a mission that goes on is told: play, pause, a second on, rate, and back to the present; orders for the chosen player, or for his
 * flight, each of which is kept in the run. And how well the program keeps to the clock, who looks on, and whether the world here is the
 * same. */
import { useEffect, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import { select } from '../ui/actions.ts';
import { Icon } from '../ui/icon.tsx';
import { use_page } from '../ui/page.ts';
import { use_cell, use_paced, use_view } from '../ui/use.ts';
import { clock_text, count_text, number_text, outcome_text, read_vote } from '../words/text.ts';
import { kRates, type Live } from './live.ts';

/** How it goes. */
export function Pace({ live }: { live: Live }) {
  const { viewers } = use_cell(live.status);
  const pacing = use_cell(live.pacing);
  const checked = use_cell(live.checked);
  const ms = (s: number): string => number_text(1000 * s, 2);
  const title = [
    `${viewers} ${viewers === 1 ? 'browser looks' : 'browsers look'} on`,
    pacing && `frames ${count_text(pacing.frames)}, missed ${count_text(pacing.missed)}; begun late by ${ms(pacing.p50)} ms (p50), ${ms(pacing.p99)} (p99), ${ms(pacing.p999)} (p99.9), ${ms(pacing.max)} at most; load ${number_text(100 * pacing.load, 1)} %`,
    checked >= 0 && `the world here is the one of the program, to the bit, after step ${count_text(checked)}`,
  ].filter(Boolean).join('\n');
  return (
    <span class="pace dim small" title={title}>
      {checked >= 0 && !use_cell(live.disagreement) && <span class="verified">✓ same bits</span>}
      <span aria-label="viewers">{viewers} ◉</span>
      {pacing && <>
        <span class={pacing.missed ? 'bad strong' : ''}>{count_text(pacing.missed)} missed</span><span>{ms(pacing.p99)} ms</span><span>{number_text(100 * pacing.load, 1)} %</span>
      </>}
    </span>
  );
}

export function LiveControls({ live }: { live: Live }) {
  const { store } = use_page();
  const status = use_cell(live.status);
  const following = use_cell(live.following);
  const behind = use_paced(store, ({ time }) => (following ? 0 : Math.round(live.flown - time)));
  const over = live.is_over();
  const waits = !status.shared && !over;
  const why = status.shared ? 'Other programs take part, by the clock: they do not wait' : undefined;
  return (
    <>
      <button type="button" class="tool play" aria-label={status.paused ? 'Play the mission' : 'Pause the mission'} title={why ?? 'Play or pause the mission, for everybody who looks on (space)'}
        disabled={!waits && !(status.paused && !over)} onClick={() => live.ask({ do: status.paused ? 'play' : 'pause' })}>
        <Icon name={status.paused || over ? 'play' : 'pause'} />
      </button>
      <button type="button" class="tool words" title={why ?? 'Fly a second, and pause'} disabled={!waits} onClick={() => live.ask({ do: 'step', steps: Math.round(1 / live.page!.run.about.dt) })}>+1 s</button>
      <select aria-label="Rate of the mission" title={why ?? 'Times real time (− +)'} value={String(status.rate)} disabled={!waits}
        onChange={(event) => live.set_rate(Number(event.currentTarget.value))}>
        {(kRates.includes(status.rate) ? kRates : [...kRates, status.rate].sort((a, b) => a - b))
          .map((rate) => <option key={rate} value={String(rate)}>{rate === Infinity ? 'max' : `${rate}×`}</option>)}
      </select>
      <button type="button" class={`tool words to-now ${following ? 'on' : ''}`} aria-pressed={following} title="To the present, and on with it (end)"
        onClick={() => live.to_present()}>
        <i class="dot" />{over ? outcome_text(status.outcome) : following ? 'now' : behind > 0 ? `now, ${clock_text(behind).replace(/\.0$/, '')} on` : 'now'}
      </button>
      {over && live.home && <a class="tool words" href="/home" title="Choose what is flown next, or look at earlier runs">home page</a>}
    </>
  );
}

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
  const gone = player.end !== '' || player.remote || live.is_over();
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
  const [problem, say] = useState('');
  const write = (words: string): void => {
    set_text(words);
    say('');
  };
  useEffect(() => write(''), [player, node]);
  const order = (event: Event): void => {
    event.preventDefault();
    const read = read_vote(text);
    if (typeof read === 'string') return say(read);
    live.order('vote', { player, tree, node, vote: read });
    write('');
  };
  return (
    <form class="vote-order" onSubmit={order}>
      <label>vote from now on <input type="text" inputMode="decimal" size={4} value={text} placeholder={number_text(vote)} aria-label={`Vote of ${node} from now on`}
        onInput={(event) => write(event.currentTarget.value)} /></label>
      <button type="submit" disabled={live.is_over() || text.trim() === ''}>order</button>
      {problem && <span class="bad small" role="alert">{problem}</span>}
    </form>
  );
}
