// SPDX-License-Identifier: MIT
/** Play, pause, speed and steps, and the time. */
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { subscribe_paced } from '../clock.ts';
import { LiveControls } from '../live/controls.tsx';
import { clock_text, read_clock } from '../words/text.ts';
import { fight_of, jump, kRates, step_decision, step_mark, toggle_play, toggle_zoom, zoom_by, zoom_to } from './actions.ts';
import { Glyph, Icon, IconButton } from './icon.tsx';
import { kMarkKinds, kMarks, neighbor, type MarkKind } from './marks.ts';
import { use_page } from './page.ts';
import { StripMenu } from './strips.tsx';
import { use_view } from './use.ts';

/** Written at the pace of panels: nobody reads faster, and each time the line is laid out anew. */
function Time() {
  const page = use_page();
  const { store } = page;
  const end = use_view(store, (v) => v.end);
  const text = useRef<HTMLInputElement>(null);
  const [problem, say] = useState('');
  useEffect(() => {
    const write = (): void => {
      // who types in it is not disturbed
      if (text.current && document.activeElement !== text.current) text.current.value = clock_text(store.get().time);
    };
    write();
    return subscribe_paced(store, write);
  }, [store]);
  const go = (input: HTMLInputElement): void => {
    const time = read_clock(input.value, end);
    if (typeof time === 'string') return say(time);
    jump(page, time);
    input.blur();
  };
  const leave = ({ currentTarget: input }: { currentTarget: HTMLInputElement }): void => {
    input.value = clock_text(store.get().time);
    say('');
  };
  return (
    <span class="time">
      <input type="text" ref={text} aria-label="Time" title="Type a time, such as 8:20.5, and press enter" inputMode="decimal" size={7}
        onFocus={(event) => event.currentTarget.select()} onInput={() => say('')} onBlur={leave}
        onKeyDown={(event) => event.key === 'Enter' && go(event.currentTarget)} /><span class="dim"> / {clock_text(end)}</span>
      {problem && <span class="bad small" role="alert"> {problem}</span>}
    </span>
  );
}

export function Transport({ children }: { children?: ComponentChildren }) {
  const page = use_page();
  const { store } = page;
  const playing = use_view(store, (v) => v.playing);
  const rate = use_view(store, (v) => v.rate);
  const fight = fight_of(page);
  const zoomed = use_view(store, (v) => v.zoom !== null);
  return (
    <div class="transport" role="toolbar" aria-label="Time">
      <IconButton icon="back_to" label="Previous event" keys="[" onClick={() => step_mark(page, -1)} />
      <IconButton icon="back" label="Previous decision" keys="←" onClick={() => step_decision(page, -1)} />
      {!page.live && (
        <button type="button" class="tool play" aria-label={playing ? 'Pause' : 'Play'} title="Play or pause (space)"
          onClick={() => toggle_play(page)}>
          <Icon name={playing ? 'pause' : 'play'} />
        </button>
      )}
      <IconButton icon="on" label="Next decision" keys="→" onClick={() => step_decision(page, 1)} />
      <IconButton icon="on_to" label="Next event" keys="]" onClick={() => step_mark(page, 1)} />
      {page.live ? <LiveControls live={page.live} /> : (
        <select aria-label="Speed" title="Speed (− +)" value={rate}
          onChange={(event) => store.set({ rate: Number(event.currentTarget.value) })}>
          {kRates.map((r) => <option key={r} value={r}>{r}×</option>)}
        </select>
      )}
      <Time />
      <MarkLegend />
      <span class="spring" />
      {children}
      <IconButton icon="closer" label="Zoom in around now" onClick={() => zoom_by(page, 0.5, store.get().time)} />
      <button type="button" class="tool words" title={zoomed ? 'Show the whole run (z)' : 'Show half a minute around now (z)'}
        onClick={() => toggle_zoom(page)}>{zoomed ? 'whole run' : '30 s'}</button>
      {fight && <button type="button" class="tool words" title="From the first shot to the last" onClick={() => zoom_to(page, ...fight)}>fight</button>}
      <StripMenu />
    </div>
  );
}

function MarkLegend() {
  const page = use_page();
  /** To the next event of the kind, or the first one after the last. */
  const first_of = (kind: MarkKind): void => {
    const times = page.marks.filter((m) => m.kind === kind).map((m) => m.t);
    const next = neighbor(times, page.store.get().time, 1) ?? times[0];
    if (next !== undefined) jump(page, next);
  };
  return (
    <details class="menu up glyphs">
      <summary aria-label="What the glyphs mean">glyphs</summary>
      <div class="menu-body">
        {kMarkKinds.map((kind) => (
          <button type="button" key={kind} onClick={() => first_of(kind)}>
            <Glyph kind={kind} />{kMarks[kind].word}
          </button>
        ))}
      </div>
    </details>
  );
}
