// SPDX-License-Identifier: MIT
/** Timeline and strips above each other over one axis of time, with one line for now and one for the pointer:
 * a click jumps, a drag scrubs or zooms, the wheel zooms or moves. */
import type { ComponentChildren, RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import { clock_text, reworded } from '../words/text.ts';
import { jump, pan_by, show_cause, zoom_by, zoom_to } from './actions.ts';
import { on_axis, rem_size } from './canvas.ts';
import { clusters_of, kMarks, lanes_of, pick_cluster, type Mark } from './marks.ts';
import { range_of, use_page, type Hover, type Page } from './page.ts';
import { use_cell, use_range, use_size } from './use.ts';

/** So many events under the pointer are told. */
const kMostTold = 8;

/** Below the rows, above their canvases: lines and the marked stretch; moved every frame without a redraw of anything else. */
function Overlay({ plot, brush }: { plot: RefObject<HTMLDivElement | null>; brush: [number, number] | null }) {
  const page = use_page();
  const now = useRef<HTMLDivElement>(null);
  const [width] = use_size(plot);
  const hover = use_cell(page.hover);
  const [from, to] = use_range();
  const x = on_axis([from, to], width);
  useEffect(() => {
    const line = now.current!;
    const move = (): void => {
      const at = x(page.store.get().time);
      line.style.transform = `translateX(${at.toFixed(1)}px)`;
      line.hidden = at < -1 || at > width + 1;
    };
    move();
    return page.store.subscribe((view, before) => {
      if (view.time !== before.time) move();
    });
  }, [page, width, from, to]);
  return (
    <div class="stack-plot" ref={plot} aria-hidden="true" data-from={from} data-to={to}>
      {brush && <div class="brush" style={{ left: `${x(brush[0])}px`, width: `${x(brush[1]) - x(brush[0])}px` }} />}
      {hover && <div class="hover-line" style={{ transform: `translateX(${x(hover.t).toFixed(1)}px)` }} />}
      {hover && <Tip page={page} hover={hover} x={x(hover.t)} width={width} plot={plot} />}
      <div class="now-line" ref={now} />
    </div>
  );
}

/** The events whose glyph is at a place in their row. */
function marks_at({ marks, store }: Page, { t, row, part }: Hover, width: number): Mark[] {
  if (row !== 'events') return [];
  const [range, rem] = [range_of(store.get()), rem_size()];
  return pick_cluster(clusters_of(marks, range, width, rem), lanes_of(marks).length, on_axis(range, width)(t), part, rem)?.marks ?? [];
}

function tip_words(page: Page, hover: Hover, width: number): string {
  const marks = marks_at(page, hover, width);
  const lines = marks.slice(0, kMostTold).map(({ line, kind }) => {
    const told = page.run.story[line]!;
    return `${kMarks[kind].word} at ${clock_text(told.t)}: ${told.name} ${reworded(told.text)}`;
  });
  if (!marks.length) return page.tips.get(hover.row)?.(hover.t) ?? '';
  return [...lines, ...(marks.length > kMostTold ? [`and ${marks.length - kMostTold} more`] : [])].join('\n');
}

/** Beside the pointer, above all else and inside of the window. */
function Tip({ page, hover, x, width, plot }: { page: Page; hover: Hover; x: number; width: number; plot: RefObject<HTMLElement | null> }) {
  const { t, y } = hover;
  const words = tip_words(page, hover, width);
  const box = plot.current?.getBoundingClientRect();
  const around = plot.current?.closest('.bottom')?.getBoundingClientRect();
  if (!box || !around) return null;
  const [left, top] = [box.left - around.left + x, box.top - around.top + y];
  const place = x < width / 2 ? { left: `${left + 12}px` } : { right: `${around.width - left + 12}px` };
  return (
    <div class="tip" style={{ ...place, top: `${Math.min(top + 16, around.height - 26 - 20 * (words.split('\n').length - 1))}px` }}>
      <b>{clock_text(t)}</b>{words && <span>{words}</span>}
    </div>
  );
}

export function Stack({ children }: { children: ComponentChildren }) {
  const page = use_page();
  const stack = useRef<HTMLDivElement>(null);
  const plot = useRef<HTMLDivElement>(null);
  const [brush, set_brush] = useState<[number, number] | null>(null);
  const now = useRef(page);  // while a mission goes on it is another one every second
  now.current = page;
  useEffect(() => watch_pointer(stack.current!, plot.current!, now, {
    brushed: (range) => {
      const [from, to] = range_of(now.current.store.get());
      set_brush(range && [Math.max(range[0], from), Math.min(range[1], to)]);
    },
    clicked: (where, width) => {
      const [mark] = marks_at(now.current, where, width);
      if (!mark) return false;
      show_cause(now.current, mark.line);
      return true;
    },
  }), []);
  return (
    <div class="stack" ref={stack} tabIndex={0} role="group" aria-label="Rows over time">
      <div class="stack-rows">
        {children}
        <Overlay plot={plot} brush={brush} />
      </div>
    </div>
  );
}

/** A row of the stack: a label, then the axis of time. Without a name of its own it is nothing to the pointer. */
export function Row({ row, label = '', class: name = '', height, scrub, children }: {
  row?: string; label?: ComponentChildren; class?: string; height?: string; scrub?: boolean; children: ComponentChildren;
}) {
  return (
    <div class={`row ${name}`} data-row={row} data-scrub={scrub ? '' : undefined} style={{ height }}>
      <div class="row-label">{label}</div>
      <div class="row-plot">{children}</div>
    </div>
  );
}

/** CSS pixels: less is a click. */
const kClick = 4;
const kWheel = 0.0015;

interface Drag {
  id: number;
  begin: number;
  row: HTMLElement;
  scrubs: boolean;
  moved: boolean;
}

interface StackPointer {
  /** A click in a row of so many CSS pixels: whether it has been dealt with. */
  clicked(where: Hover, width: number): boolean;
  /** The stretch that a drag has marked; null: none. */
  brushed(range: [number, number] | null): void;
}

/** Rows of the page that it is `of` now are elements with data-row, those with data-scrub move the time; `plot` is where the time axis lies. */
function watch_pointer(stack: HTMLElement, plot: HTMLElement, of: { current: Page }, then: StackPointer): () => void {
  let drag: Drag | null = null;

  const place = (event: MouseEvent): { t: number; inside: boolean; per_pixel: number } => {
    const { left, width } = plot.getBoundingClientRect();
    const [from, to] = range_of(of.current.store.get());
    const part = (event.clientX - left) / width;
    return { t: from + part * (to - from), inside: part >= 0 && part <= 1, per_pixel: (to - from) / width };
  };
  const row_of = (event: Event): HTMLElement | null => (event.target as Element).closest<HTMLElement>('[data-row]');
  const hover_of = (event: MouseEvent, row: HTMLElement): Hover => {
    const { top, height } = row.getBoundingClientRect();
    return { t: place(event).t, row: row.dataset.row!, y: event.clientY - plot.getBoundingClientRect().top, part: (event.clientY - top) / height };
  };

  const down = (event: PointerEvent): void => {
    const row = row_of(event);
    const { t, inside } = place(event);
    if (event.button !== 0 || !row || !inside || (event.target as Element).closest('button, input, label, summary')) return;
    drag = { id: event.pointerId, begin: t, row, scrubs: row.dataset.scrub !== undefined, moved: false };
    stack.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent): void => {
    const { t, inside, per_pixel } = place(event);
    if (!drag) {
      const row = row_of(event);
      of.current.hover.set(inside && row ? hover_of(event, row) : null);
      return;
    }
    if (event.pointerId !== drag.id) return;
    drag.moved ||= Math.abs(t - drag.begin) > kClick * per_pixel;
    if (!drag.moved) return;
    of.current.hover.set(hover_of(event, drag.row));
    if (drag.scrubs) jump(of.current, t);
    else then.brushed([Math.min(t, drag.begin), Math.max(t, drag.begin)]);
  };
  const up = (event: PointerEvent): void => {
    if (!drag || event.pointerId !== drag.id) return;
    const { t } = place(event);
    const { begin, row, scrubs, moved } = drag;
    drag = null;
    then.brushed(null);
    if (!moved) {
      if (!then.clicked(hover_of(event, row), plot.clientWidth)) jump(of.current, t);
    } else if (!scrubs) {
      zoom_to(of.current, Math.min(t, begin), Math.max(t, begin));
    }
  };
  const cancel = (): void => {
    drag = null;
    then.brushed(null);
  };
  const wheel = (event: WheelEvent): void => {
    const { t, inside, per_pixel } = place(event);
    if (!inside || !row_of(event)) return;
    event.preventDefault();
    const sideways = event.shiftKey ? event.deltaX + event.deltaY : event.deltaX;
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) pan_by(of.current, sideways * per_pixel);
    else zoom_by(of.current, Math.exp(event.deltaY * kWheel), t);
  };
  const whole = (event: MouseEvent): void => {
    if (row_of(event) && place(event).inside) of.current.store.set({ zoom: null });
  };
  return listen(stack, {
    pointerdown: down, pointermove: move, pointerup: up, pointercancel: cancel, pointerleave: () => of.current.hover.set(null), wheel,
    dblclick: whole,
  }, { passive: false });
}
