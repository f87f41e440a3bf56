// SPDX-License-Identifier: MIT
/** Who was in charge in a player's tree over time, as flown and as it would have been. */
import { useEffect, useMemo } from 'preact/hooks';
import type { Player, Run } from '../run/run.ts';
import { kFlownOn } from '../scene/other.ts';
import { clock_text } from '../words/text.ts';
import { color, fitted, on_axis, use_canvas, type Sheet } from './canvas.ts';
import { namesake, use_page } from './page.ts';
import { fill_of, label_of, leader_spans, spans_of, type Span } from './spans.ts';
import { Row } from './stack.tsx';
import { use_cell, use_range, use_view } from './use.ts';
import { use_answer, would_lead } from './what_if_answer.ts';

/** CSS pixels: a single decision can be seen in a run of half an hour. */
const kNarrowest = 1.5;

/** With the words of the spans, which leave room for the line at `cut` (s), or without. */
function draw_spans({ pen, width, rem }: Sheet, spans: Span[], range: [number, number], top: number, height: number, words: boolean, cut?: number): void {
  const [from, to] = range;
  pen.font = `${0.85 * rem}px system-ui, sans-serif`;
  pen.textBaseline = 'middle';
  const x_of = on_axis(range, width);
  const short: Span[] = [];
  for (const span of spans) {
    if (span.to < from || span.from > to) continue;
    const x = Math.max(x_of(span.from), 0);
    const room = Math.min(x_of(span.to), width) - x;
    if (room < 3) {
      short.push(span);
      continue;
    }
    pen.fillStyle = fill_of(span.label);
    pen.fillRect(x, top, room - 0.5, height);
    if (!words || room < 1.6 * rem) continue;
    pen.fillStyle = '#10161c';
    const [begin, end, line] = [x + 0.3 * rem, x + room - 0.3 * rem, cut === undefined ? NaN : x_of(cut)];
    const is_cut = line > begin - kNotch * rem && line < begin + pen.measureText(fitted(pen, span.label, end - begin)).width + kNotch * rem;
    const left = is_cut ? Math.max(begin, line + 1.5 * kNotch * rem) : begin;
    pen.fillText(fitted(pen, span.label, end - left), left, top + height / 2 + 0.5);
  }
  // on top, or they would drown between the long ones
  for (const span of short) {
    pen.fillStyle = fill_of(span.label);
    pen.fillRect(Math.min(x_of(span.from), width - kNarrowest), top, Math.max(x_of(span.to) - x_of(span.from), kNarrowest), height);
  }
}

/** rem: half as wide as the notch above a line. */
const kNotch = 0.4;

/** A line through a strip with a notch above it. */
function draw_cut({ pen, height, rem }: Sheet, x: number): void {
  const notch = kNotch * rem;
  pen.fillStyle = color('ink');
  pen.fillRect(x - 1, 0, 2, height);
  pen.fill(new Path2D(`M${x - notch} 0H${x + notch}L${x} ${notch}Z`));
}

/** A strip of spans; `marked` stretches (s) get a bar above them, and `cut` (s) a line through them. */
function SpanStrip({ spans, marked, cut, label }: { spans: Span[]; marked?: [number, number][]; cut?: number | undefined; label: string }) {
  const range = use_range();
  const canvas = use_canvas((sheet) => {
    const bar = marked ? Math.round(0.28 * sheet.rem) : 0;
    const x_of = on_axis(range, sheet.width);
    draw_spans(sheet, spans, range, bar, sheet.height - bar, true, cut);
    sheet.pen.fillStyle = color('accent');
    for (const [x, end] of (marked ?? []).map((ends) => ends.map(x_of) as [number, number]))
      if (end >= 0 && x <= sheet.width) sheet.pen.fillRect(x, 0, Math.max(end - x, 2), bar - 1);
    if (cut !== undefined) draw_cut(sheet, x_of(cut));
  }, [spans, marked, cut, range]);
  return <canvas class="fill" ref={canvas} role="img" aria-label={label} />;
}

/** Says under the pointer whose span it is. */
function use_tip(row: string, name: string, spans: Span[] | null): void {
  const { tips } = use_page();
  useEffect(() => {
    tips.set(row, (t) => {
      const span = spans?.find((one) => one.from <= t && t < one.to);
      return span ? `${name}: ${span.label}, ${clock_text(span.from)} to ${clock_text(span.to)}` : '';
    });
    return () => void tips.delete(row);
  }, [tips, row, name, spans]);
}

/** `cut` is where it parts from another run; `run` is the player's if that is not the page's. */
export function LeaderRow({ player, run, label, cut }: { player: Player; run?: Run; label?: string; cut?: number | undefined }) {
  const page = use_page();
  const spans = leader_spans(run ?? page.run, player);
  const row = `leader ${label ?? player.name}`;
  use_tip(row, label ?? player.name, spans);
  return (
    <Row row={row} label={<Name name={label ?? player.name} />} class="leader">
      <SpanStrip spans={spans} cut={cut} label={`Which behavior led ${player.name}`} />
    </Row>
  );
}

/** Who would have led, below who did; nothing if nothing is asked. */
export function WhatIfRow({ player }: { player: Player }) {
  const page = use_page();
  const changes = use_cell(page.changes);
  const asked = use_answer();
  const answer = asked?.value;
  const spans = useMemo(() => answer && spans_of(page.run, player, would_lead(player, answer)), [page, player, answer]) ?? null;
  use_tip('what if', 'would be', spans);
  if (!changes.length || !answer || !spans) return null;
  return (
    <Row row="what if" label={<span class="accent">what if</span>} class={`leader what-if-row ${asked!.is_old ? 'old' : ''}`}>
      <SpanStrip spans={spans} marked={answer.spans} label={`Which behavior would have led ${player.name}`} />
    </Row>
  );
}

/** Who led in the other future. */
export function OtherRow({ player }: { player: Player }) {
  const other = use_cell(use_page().other);
  return other && other.label === kFlownOn && <LeaderRow player={other.run.players[player.index]!} run={other.run} label={kFlownOn} />;
}

/** What the colours mean, for one player. */
export function Legend({ player }: { player: Player }) {
  const page = use_page();
  const answer = use_answer()?.value;
  const other = use_cell(page.other);
  const labels = useMemo(() => {
    const led_in = (run: Run | undefined, who: number): string[] => {
      const one = run?.players[who];
      return one ? leader_spans(run!, one).map((span) => span.label) : [];
    };
    const led = [...led_in(page.run, player.index), ...led_in(page.twin?.run, page.twin ? namesake(page.twin, player) : -1), ...led_in(other?.run, player.index)];
    const shape = player.decisions.shape;
    const node_at = answer && would_lead(player, answer);
    const would = node_at ? Array.from(shape, (s, i) => label_of(page.run, page.run.shapes[s]!.tree, node_at(i))) : [];
    return [...new Set([...led, ...would])];
  }, [page, player, answer, other]);
  return (
    <Row class="legend-row">
      <ul class="legend" aria-label="Colours of behaviors">{labels.map((label) => <li key={label}><Chip label={label} />{label}</li>)}</ul>
    </Row>
  );
}

/** Of a player: where there is no room, its end is what stays, which is the rank. */
export function Name({ name, class: more = '' }: { name: string; class?: string }) {
  return <span class={`cut front ${more}`} title={name}><bdi dir="ltr">{name}</bdi></span>;
}

export function Chip({ label }: { label: string }) {
  return <i class="chip" style={{ background: fill_of(label) }} aria-hidden="true" />;
}

/** A thin lane for every player, to see who did what at the same time. */
export function EveryoneRow() {
  const page = use_page();
  const range = use_range();
  const selected = use_view(page.store, (v) => v.selected);
  const { players } = page.run;
  const canvas = use_canvas((sheet) => {
    const lane = sheet.height / players.length;
    players.forEach((player, i) => {
      const twin = page.twin?.run.players[namesake(page.twin, player)];
      const height = (lane - 1.5) / (twin ? 2 : 1);
      draw_spans(sheet, leader_spans(page.run, player), range, i * lane, height, false);
      if (twin) draw_spans(sheet, leader_spans(page.twin!.run, twin), range, i * lane + height, height, false);
    });
  }, [page, range]);
  return (
    <Row row="everyone" class="everyone" height={`${players.length * (page.twin ? 1.3 : 0.95)}rem`} label={players.map((player) => (
      <Name key={player.name} name={player.name} class={`lane-name ${player.side} ${player.index === selected ? 'strong' : ''}`} />
    ))}>
      <canvas class="fill" ref={canvas} role="img" aria-label="Which behavior led every player" />
    </Row>
  );
}
