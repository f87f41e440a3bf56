// SPDX-License-Identifier: MIT
/** Timeline and strips above each other over one axis of time, with one line for now and one for the pointer:
 * a click jumps, a drag scrubs or zooms, the wheel zooms or moves. */
import type { ComponentChildren, RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import { clock_text, reworded } from '../words/text.ts';
import { jump, pan_by, show_cause, zoom_by, zoom_to } from './actions.ts';
import { kMarks, pick_mark } from './marks.ts';
import { range_of, use_page, type Page } from './page.ts';
import { use_cell, use_range, use_size } from './use.ts';

/** CSS pixels: a glyph this near is meant. */
const kReach = 9;

/** Below the rows, above their canvases: lines and the marked stretch; moved every frame without a redraw of anything else. */
function Overlay({ plot, brush }: { plot: RefObject<HTMLDivElement | null>; brush: [number, number] | null }) {
  const page = use_page();
  const now = useRef<HTMLDivElement>(null);
  const [width] = use_size(plot);
  const hover = use_cell(page.hover);
  const [from, to] = use_range();
  const x = (t: number): number => ((t - from) / (to - from)) * width;
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
      {hover && <Tip page={page} x={x(hover.t)} width={width} per_pixel={(to - from) / Math.max(width, 1)} plot={plot} />}
      <div class="now-line" ref={now} />
    </div>
  );
}

function tip_words(page: Page, t: number, row: string, per_pixel: number): string {
  if (row === 'events') {
    const mark = pick_mark(page.marks, t, kReach * per_pixel);
    if (!mark) return '';
    const told = page.run.story[mark.line]!;
    return `${kMarks[mark.kind].word} at ${clock_text(told.t)}: ${told.name} ${reworded(told.text)}`;
  }
  return page.tips.get(row)?.(t) ?? '';
}

/** Beside the pointer, above all else and inside of the window. */
function Tip({ page, x, width, per_pixel, plot }: { page: Page; x: number; width: number; per_pixel: number; plot: RefObject<HTMLElement | null> }) {
  const { t, row, y } = page.hover.get() ?? { t: 0, row: '', y: 0 };
  const words = tip_words(page, t, row, per_pixel);
  const box = plot.current?.getBoundingClientRect();
  const around = plot.current?.closest('.bottom')?.getBoundingClientRect();
  if (!box || !around) return null;
  const [left, top] = [box.left - around.left + x, box.top - around.top + y];
  const place = x < width / 2 ? { left: `${left + 12}px` } : { right: `${around.width - left + 12}px` };
  return (
    <div class="tip" style={{ ...place, top: `${Math.min(top + 16, around.height - 26)}px` }}>
      <b>{clock_text(t)}</b>{words && <span>{words}</span>}
    </div>
  );
}

export function Stack({ children }: { children: ComponentChildren }) {
  const page = use_page();
  const stack = useRef<HTMLDivElement>(null);
  const plot = useRef<HTMLDivElement>(null);
  const [brush, set_brush] = useState<[number, number] | null>(null);
  useEffect(() => watch_pointer(stack.current!, plot.current!, page, {
    brushed: (range) => set_brush(range && clipped(range, range_of(page.store.get()))),
    clicked: (row, t, per_pixel) => {
      const mark = row === 'events' ? pick_mark(page.marks, t, kReach * per_pixel) : null;
      if (!mark) return false;
      show_cause(page, mark.line);
      return true;
    },
  }), [page]);
  return (
    <div class="stack" ref={stack} tabIndex={0} role="group" aria-label="Rows over time">
      <div class="stack-rows">
        {children}
        <Overlay plot={plot} brush={brush} />
      </div>
    </div>
  );
}

function clipped([a, b]: [number, number], [from, to]: [number, number]): [number, number] {
  return [Math.max(a, from), Math.min(b, to)];
}

/** A row of the stack: a label, then the axis of time. */
export function Row({ row, label, class: name = '', scrub, children }: {
  row: string; label: ComponentChildren; class?: string; scrub?: boolean; children: ComponentChildren;
}) {
  return (
    <div class={`row ${name}`} data-row={row} data-scrub={scrub ? '' : undefined}>
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
  row: string;
  scrubs: boolean;
  moved: boolean;
}

interface StackPointer {
  /** A click in a row: whether it has been dealt with. */
  clicked(row: string, t: number, seconds_per_pixel: number): boolean;
  /** The stretch that a drag has marked; null: none. */
  brushed(range: [number, number] | null): void;
}

/** Rows are elements with data-row, those with data-scrub move the time; `plot` is where the time axis lies. */
function watch_pointer(stack: HTMLElement, plot: HTMLElement, page: Page, then: StackPointer): () => void {
  let drag: Drag | null = null;

  const place = (event: MouseEvent): { t: number; inside: boolean; per_pixel: number } => {
    const { left, width } = plot.getBoundingClientRect();
    const [from, to] = range_of(page.store.get());
    const part = (event.clientX - left) / width;
    return { t: from + part * (to - from), inside: part >= 0 && part <= 1, per_pixel: (to - from) / width };
  };
  const height_of = (event: MouseEvent): number => event.clientY - plot.getBoundingClientRect().top;
  const row_of = (event: Event): HTMLElement | null => (event.target as Element).closest<HTMLElement>('[data-row]');

  const down = (event: PointerEvent): void => {
    const row = row_of(event);
    const { t, inside } = place(event);
    if (event.button !== 0 || !row || !inside || (event.target as Element).closest('button, input, label, summary')) return;
    drag = { id: event.pointerId, begin: t, row: row.dataset.row!, scrubs: row.dataset.scrub !== undefined, moved: false };
    stack.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent): void => {
    const { t, inside, per_pixel } = place(event);
    if (!drag) {
      const row = row_of(event);
      page.hover.set(inside && row ? { t, row: row.dataset.row!, y: height_of(event) } : null);
      return;
    }
    if (event.pointerId !== drag.id) return;
    drag.moved ||= Math.abs(t - drag.begin) > kClick * per_pixel;
    if (!drag.moved) return;
    page.hover.set({ t, row: drag.row, y: height_of(event) });
    if (drag.scrubs) jump(page, t);
    else then.brushed([Math.min(t, drag.begin), Math.max(t, drag.begin)]);
  };
  const up = (event: PointerEvent): void => {
    if (!drag || event.pointerId !== drag.id) return;
    const { t, per_pixel } = place(event);
    const { begin, row, scrubs, moved } = drag;
    drag = null;
    then.brushed(null);
    if (!moved) {
      if (!then.clicked(row, t, per_pixel)) jump(page, t);
    } else if (!scrubs) {
      zoom_to(page, Math.min(t, begin), Math.max(t, begin));
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
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) pan_by(page, sideways * per_pixel);
    else zoom_by(page, Math.exp(event.deltaY * kWheel), t);
  };
  const whole = (event: MouseEvent): void => {
    if (row_of(event) && place(event).inside) page.store.set({ zoom: null });
  };
  return listen(stack, {
    pointerdown: down, pointermove: move, pointerup: up, pointercancel: cancel, pointerleave: () => page.hover.set(null), wheel,
    dblclick: whole,
  }, { passive: false });
}
