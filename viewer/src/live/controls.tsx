// SPDX-License-Identifier: MIT
/** Of a mission that goes on: play, pause, a second on, rate, and back to the present; how well the program keeps to the clock, who looks
 * on, and whether the world here is the same. */
import { Icon } from '../ui/icon.tsx';
import { use_page } from '../ui/page.ts';
import { use_cell, use_paced } from '../ui/use.ts';
import { clock_text, count_text, number_text } from '../words/text.ts';
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
      {pacing && <span>{pacing.missed ? <b class="bad">{count_text(pacing.missed)} missed</b> : '0 missed'}, {ms(pacing.p99)} ms, {number_text(100 * pacing.load, 1)} %</span>}
    </span>
  );
}

export function LiveControls({ live }: { live: Live }) {
  const { store } = use_page();
  const status = use_cell(live.status);
  const following = use_cell(live.present!.following);
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
        onClick={() => live.present!.now()}>
        <i class="dot" />{over ? status.outcome.replace('_', ' ') : following ? 'now' : behind > 0 ? `now, ${clock_text(behind).replace(/\.0$/, '')} on` : 'now'}
      </button>
      {over && live.home && <a class="tool words" href="/home" title="Choose what is flown next, or look at earlier runs">home page</a>}
    </>
  );
}
