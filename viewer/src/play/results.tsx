// SPDX-License-Identifier: MIT
/** What became of the flights: the one that is flying or the last one with its story, and all of them in a table. */
import { useEffect, useRef } from 'preact/hooks';
import type { Outcome } from '../engine/questions.ts';
import { clock_text, count_text, outcome_text } from '../words/text.ts';
import type { Flight } from './flights.ts';

const kSides = ['blue', 'red'] as const;
const kCounts = ['kills', 'losses', 'shots', 'home'] as const;

function Tally({ outcome }: { outcome: Outcome }) {
  return (
    <table class="tally">
      <thead><tr><td />{kCounts.map((name) => <th key={name} scope="col">{name}</th>)}</tr></thead>
      <tbody>
        {kSides.map((side) => (
          <tr key={side} data-side={side}><th scope="row" class={side}>{side}</th>{kCounts.map((name) => <td key={name}>{outcome[side][name]}</td>)}</tr>
        ))}
      </tbody>
    </table>
  );
}

function Progress({ flight: { time, until } }: { flight: Flight }) {
  return (
    <div class="progress" role="progressbar" aria-valuemin={0} aria-valuemax={Math.round(until)} aria-valuenow={Math.round(time)}>
      <div class="share"><i style={{ width: `${(100 * time) / Math.max(until, 1)}%` }} /></div>
      <span class="dim">{clock_text(time)} of at most {clock_text(until)}</span>
    </div>
  );
}

function StoryLines({ flight }: { flight: Flight }) {
  const list = useRef<HTMLOListElement>(null);
  const flies = !flight.result;
  const side = new Map(flight.players.map((player) => [player.name, player.side]));
  useEffect(() => {
    if (list.current) list.current.scrollTop = flies ? list.current.scrollHeight : 0;
  }, [flight.number, flies, flies && flight.story.length]);
  return (
    <section class="story" aria-label="Story" style={{ '--clock': clock_text(flight.until).length }}>
      <ol ref={list} tabIndex={0}>
        {flight.story.map(({ time, who, text }, i) => (
          <li key={i} class={`told passed ${/^splash /.test(text) ? 'tone-kill' : ''}`}>
            <time>{clock_text(time ?? 0)}</time><span /><span><b class={side.get(who) ?? 'none'}>{who}</b> {text}</span>
          </li>
        ))}
      </ol>
    </section>
  );
}

function Last({ flight, before, busy, onDebrief }: { flight: Flight; before: Flight | undefined; busy: boolean; onDebrief: (runs: Flight[]) => void }) {
  const { result: outcome, hash, took, time, fault } = flight;
  return (
    <section class="last" aria-label="Outcome" data-hash={outcome ? hash : ''} data-outcome={outcome?.outcome ?? ''}>
      <h2>{flight.name}, seed {flight.seed} <span class="dim">flight {flight.number}</span></h2>
      {!outcome && <Progress flight={flight} />}
      {outcome && (
        <>
          <p><b>{outcome_text(outcome.outcome)}</b> at {clock_text(outcome.time ?? 0)}{' '}
            <span class="dim">{count_text(Math.round(time / Math.max(took / 1000, 1e-3) / 10) * 10)} times real time</span></p>
          {fault && <p class="caution">⚠ {fault}</p>}
          <Tally outcome={outcome} />
          <p class="small"><span class="dim">world hash</span> <code title="What ./eyrie fly prints for this text and seed">{hash}</code></p>
          <p class="does">
            <button type="button" class="fly" disabled={busy} onClick={() => onDebrief([flight])}>Debrief</button>
            {before && <button type="button" disabled={busy} onClick={() => onDebrief([before, flight])}>Compare with flight {before.number}</button>}
          </p>
        </>
      )}
    </section>
  );
}

function All({ flights, busy, onDebrief }: { flights: Flight[]; busy: boolean; onDebrief: (runs: Flight[]) => void }) {
  const first = flights.at(-1)!.number;
  return (
    <section class="flights" aria-label="Flights">
      <table>
        <thead>
          <tr>{['#', 'scenario', 'seed', 'ended', 'blue lost', 'red lost', 'hash'].map((name) => <th key={name} scope="col">{name}</th>)}<td /></tr>
        </thead>
        <tbody>
          {flights.map((flight) => (
            <tr key={flight.number} data-flight={flight.number} data-hash={flight.hash}>
              <td>{flight.number}</td>
              <td>{flight.name}{flight.is_edited ? <span title="edited"> •</span> : ''}</td>
              <td>{flight.seed}</td>
              <td>{outcome_text(flight.result!.outcome)} {clock_text(flight.result!.time ?? 0)}</td>
              <td>{flight.result!.blue.losses}</td>
              <td>{flight.result!.red.losses}</td>
              <td><code title={flight.hash}>{flight.hash.slice(2, 8)}</code></td>
              <td><button type="button" class="link" disabled={busy} onClick={() => onDebrief([flight])}>debrief</button></td>
            </tr>
          ))}
        </tbody>
      </table>
      {first > 1 && <p class="dim small">Only the last {flights.length} are kept: {first === 2 ? 'flight 1 is' : `flights 1 to ${first - 1} are`} gone.</p>}
    </section>
  );
}

function Welcome({ help }: { help: string }) {
  return (
    <section class="welcome">
      {help && <p class="help-text">{help}</p>}
      <ol>
        <li><b>Fly</b> it, a thousand times faster than real time, or <b>Watch</b> it from the start.</li>
        <li><b>Debrief</b> it: every decision of every agent, and why; ask what if, and fly on from there.</li>
        <li><b>Change</b> the text: a vote, an arbiter, a missile, the weather. The loader reads along, Ctrl Space proposes, and
          a key explains itself under the pointer; Tab indents, Esc and then Tab leaves the text. Fly again and compare.</li>
        <li><b>Share</b> a link that holds what you changed.</li>
      </ol>
      <p class="dim">Everything runs in this page: the same program, and for a text and a seed the same bits, as <code>./eyrie fly</code>. Nothing is sent anywhere.</p>
    </section>
  );
}

export function Results({ flying, flights, help, busy, onDebrief }: {
  flying: Flight | null; flights: Flight[]; help: string; busy: boolean; onDebrief: (runs: Flight[]) => void;
}) {
  const shown = flying ?? flights[0];
  if (!shown) return <Welcome help={help} />;
  return (
    <div class="results">
      <Last flight={shown} before={flying ? undefined : flights[1]} busy={busy} onDebrief={onDebrief} />
      {flights.length > 1 && <All flights={flights} busy={busy || flying !== null} onDebrief={onDebrief} />}
      <StoryLines flight={shown} />
    </div>
  );
}
