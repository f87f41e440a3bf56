// SPDX-License-Identifier: MIT
/** Over the air picture of a mission that goes on: big words if the world here is another one or the line is broken, and, for who has
 * taken an aircraft over, what he does beside what its tree proposes, and how to fly it. */
import type { ComponentChildren } from 'preact';
import { useReducer, useEffect } from 'preact/hooks';
import type { TrackSeen } from '../run/run.ts';
import { subscribe_paced } from '../clock.ts';
import { convergence } from '../scene/geo.ts';
import { turn } from '../scene/motion.ts';
import { use_page } from '../ui/page.ts';
import { use_cell } from '../ui/use.ts';
import { count_text, heading_text, height_text, quantity_text } from '../words/text.ts';
import { kKeys, proposed, type Wanted } from './hands.ts';
import type { Live } from './live.ts';

function Big({ live }: { live: Live }) {
  const wrong = use_cell(live.disagreement);
  const { broken } = use_cell(live.status);
  const said = use_cell(live.said);
  return (
    <>
      {wrong && (
        <div class="big bad" role="alert">
          <h2>This is not what is flown</h2>
          <p>After step {count_text(wrong.step)} the world is {wrong.there} there and {wrong.here} here. That must never be: please tell the makers of Eyrie, with the run.</p>
          <button type="button" onClick={() => location.reload()}>Join the mission anew</button>
        </div>
      )}
      {broken && <div class="big" role="status"><h2>No line to the program</h2><p>{broken}; it is tried again …</p></div>}
      {said && <div class="said" role="alert">{said}</div>}
    </>
  );
}

function Card({ live }: { live: Live }) {
  return (
    <div class="card" role="note" aria-label="How to fly">
      <header><h2>How to fly</h2><button type="button" class="quiet" aria-label="Close the card" onClick={() => live.hands.toggle_help()}>✕</button></header>
      <dl>{kKeys.map(({ shown, words }) => <div key={shown}><dt><kbd>{shown}</kbd></dt><dd>{words}</dd></div>)}</dl>
      <p class="dim small">You say where to, and the autopilot flies there. A gamepad: left stick, triggers for the speed, A shoots, X gun, Y target,
        B chaff and flares, bumpers radar and stick and throttle, start hands back.</p>
    </div>
  );
}

function Row({ name, flown, mine, tree }: { name: string; flown: string; mine: string; tree: { text: string; by: string; other: boolean } | null }) {
  return (
    <tr>
      <th scope="row">{name}</th><td>{flown}</td><td><b>{mine}</b></td>
      <td class={tree?.other ? 'other' : ''} title={tree ? `proposed by ${tree.by}` : ''}>{tree ? tree.text : '–'}</td>
    </tr>
  );
}

const kAlike = { heading: 0.09, altitude: 150, speed: 10 };

function target_words(tracks: TrackSeen[], id: number, names: (truth: number) => string): string {
  const track = tracks.find((one) => one.id === id);
  return !id ? 'nobody' : track ? names(track.truth) : `track ${id}`;
}

/** What he flies, what he asks for, and what the tree would. */
function Table({ live, wanted }: { live: Live; wanted: Wanted }) {
  const { store } = use_page();
  const [, redraw] = useReducer((n: number) => n + 1, 0);
  useEffect(() => subscribe_paced(store, () => redraw(undefined)), [store]);
  const { run } = live.page!;
  const player = run.players[wanted.player]!;
  const tree = proposed(live);
  const tracks = live.hands.tracks(wanted.player);
  const last = (values: Float64Array): number => values.at(-1) ?? NaN;
  const name_of = (truth: number): string => run.players[truth]?.name ?? 'unknown';
  const told = (name: 'heading' | 'altitude' | 'speed', text: (value: number) => string): { text: string; by: string; other: boolean } | null => {
    const found = tree.get(name);
    if (!found || Number.isNaN(found.value)) return null;
    const off = Math.abs(name === 'heading' ? turn(wanted.heading, found.value) : found.value - wanted[name]);
    return { text: text(found.value), by: found.by, other: off > kAlike[name] };
  };
  const north = convergence(run.origin, { east: last(player.motion.east), north: last(player.motion.north) });
  const speed = (value: number): string => quantity_text(value, 'm/s');
  const aim = tree.get('target');
  const shoots = tree.get('release') ?? tree.get('store');
  return (
    <section class="seat" aria-label={`You fly ${player.name}`}>
      <header><b class={player.side}>{player.name}</b> is yours
        <span class="spring" />
        <button type="button" onClick={() => live.hands.toggle_help()}>keys (?)</button>
        <button type="button" onClick={() => live.hands.hand_back()}>hand back (H)</button>
      </header>
      <table>
        <thead><tr><td /><th scope="col">flown</th><th scope="col">you</th><th scope="col">its tree</th></tr></thead>
        <tbody>
          <Row name="heading" flown={heading_text(last(player.motion.heading) + north)} mine={heading_text(wanted.heading)} tree={told('heading', heading_text)} />
          <Row name="altitude" flown={height_text(last(player.motion.up))} mine={wanted.climb === null ? height_text(wanted.altitude) : `climb ${Math.round((wanted.climb * 180) / Math.PI)}°`} tree={told('altitude', height_text)} />
          <Row name="speed" flown={speed(last(player.gauges.speed))} mine={speed(wanted.speed)} tree={told('speed', speed)} />
          <Row name="target" flown={target_words(tracks, tracks.find(({ is_target }) => is_target)?.id ?? 0, name_of)} mine={target_words(tracks, wanted.target, name_of)}
            tree={aim ? { text: target_words(tracks, aim.value, name_of), by: aim.by, other: aim.value !== wanted.target } : null} />
        </tbody>
      </table>
      <p class="acts">
        <button type="button" onClick={() => live.hands.act('next')}>target (T)</button>
        <button type="button" disabled={!wanted.target} onClick={() => live.hands.act('shoot')}>shoot (space)</button>
        <button type="button" aria-pressed={wanted.gun} onClick={() => live.hands.act('gun')}>gun (G)</button>
        <button type="button" aria-pressed={wanted.radar} onClick={() => live.hands.act('radar')}>radar (R)</button>
        <button type="button" onClick={() => live.hands.act('dispense')}>chaff (C)</button>
        <button type="button" aria-pressed={wanted.pointer} onClick={() => live.hands.act('pointer')}>pointer (M)</button>
        <button type="button" aria-pressed={wanted.stick} onClick={() => live.hands.act('stick')}>stick (S)</button>
        {shoots && shoots.value !== 0 && <span class="other small">its tree would shoot</span>}
      </p>
    </section>
  );
}

export function LiveOver({ live }: { live: Live }): ComponentChildren {
  const wanted = use_cell(live.hands.wanted);
  const help = use_cell(live.hands.help);
  const pointing = use_cell(live.pointing);
  return (
    <div class="live-over">
      <Big live={live} />
      {pointing && <div class="said" role="status">Click where {live.page!.run.players[live.page!.store.get().selected]!.name} is to fly; esc leaves it</div>}
      {help && <Card live={live} />}
      {wanted && <Table live={live} wanted={wanted} />}
    </div>
  );
}
