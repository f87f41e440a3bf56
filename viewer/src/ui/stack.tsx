// SPDX-License-Identifier: MIT
/** Timeline and strips above each other over one axis of time, with one line for now and one for the pointer. */
import type { ComponentChildren, RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { jump, select } from './actions.ts';
import { clock_text } from './format.ts';
import { kMarkWords, pick_mark } from './marks.ts';
import { range_of, use_page, type Page } from './page.ts';
import { watch_pointer } from './stack_pointer.ts';
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
      {hover && <Tip page={page} x={x(hover.t)} width={width} per_pixel={(to - from) / Math.max(width, 1)} />}
      <div class="now-line" ref={now} />
    </div>
  );
}

function tip_words(page: Page, t: number, row: string, per_pixel: number): string {
  if (row === 'events') {
    const mark = pick_mark(page.marks, t, kReach * per_pixel);
    if (!mark) return '';
    const told = page.run.story[mark.line]!;
    return `${kMarkWords[mark.kind]} at ${clock_text(told.t)}: ${told.name} ${told.text}`;
  }
  return page.tips.get(row)?.(t) ?? '';
}

function Tip({ page, x, width, per_pixel }: { page: Page; x: number; width: number; per_pixel: number }) {
  const { t, row } = page.hover.get() ?? { t: 0, row: '' };
  const words = tip_words(page, t, row, per_pixel);
  const left = x < width / 2;
  return (
    <div class="tip" style={left ? { left: `${x + 8}px` } : { right: `${width - x + 8}px` }}>
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
      select(page, page.run.story[mark.line]!.who);
      jump(page, mark.t);
      return true;
    },
  }), [page]);
  return (
    <div class="stack" ref={stack}>
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
