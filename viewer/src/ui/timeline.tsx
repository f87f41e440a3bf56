// SPDX-License-Identifier: MIT
/** The events of the run on its axis of time, and the whole run in small with what the strips show of it. */
import { useMemo, useRef } from 'preact/hooks';
import { tick_text } from '../words/text.ts';
import { bring_in_sight, pan_by } from './actions.ts';
import { color, on_axis, use_canvas, type Sheet } from './canvas.ts';
import { clusters_of, kBeside, kHalfGlyph, kLanesFrom, kMarks, lanes_of, type Mark, type MarkKind } from './marks.ts';
import { use_page, type Page } from './page.ts';
import { Row } from './stack.tsx';
import { use_paced, use_range, use_view } from './use.ts';

const kTicks = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600, 7200, 10_800, 21_600, 43_200];
const kDay = 86_400;

/** Times (s) for labels, far enough apart to be read, and the step between them. */
export function ticks_of(from: number, to: number, pixels: number, rem: number): { step: number; ticks: number[] } {
  const least = (5.5 * rem * (to - from)) / Math.max(pixels, 1);
  const step = kTicks.find((one) => one >= least) ?? kDay * 2 ** Math.max(Math.ceil(Math.log2(least / kDay)), 0);
  const first = Math.ceil(from / step);
  const count = Math.max(Math.floor(to / step + 1e-9) - first + 1, 0);
  return { step, ticks: Array.from({ length: count }, (_, i) => (first + i) * step) };
}

function draw_glyph(pen: CanvasRenderingContext2D, kind: MarkKind, x: number, y: number, size: number): void {
  pen.save();
  pen.translate(x, y);
  pen.scale(size / 5, size / 5);
  pen.lineWidth = kind === 'kill' ? 2.4 : 1.6;
  const path = new Path2D(kMarks[kind].path);
  if (kMarks[kind].open) pen.stroke(path);
  else pen.fill(path);
  pen.restore();
}

function draw_ticks({ pen, width, height, rem }: Sheet, range: [number, number]): void {
  const { step, ticks } = ticks_of(...range, width, rem);
  const x_of = on_axis(range, width);
  pen.font = `${0.82 * rem}px system-ui, sans-serif`;
  pen.textBaseline = 'top';
  for (const t of ticks) {
    const x = Math.round(x_of(t)) + 0.5;
    pen.fillStyle = color('line');
    pen.fillRect(x, 0, 1, height);
    pen.fillStyle = color('dim');
    const words = tick_text(t, step);
    if (x + 0.3 * rem + pen.measureText(words).width < width) pen.fillText(words, x + 0.3 * rem, 0.15 * rem);
  }
}

/** Blue above red, phases and leads of flights on the lane of their side. */
function draw_marks({ pen, width, height, rem }: Sheet, marks: Mark[], range: [number, number]): void {
  const top = kLanesFrom * height;
  const x_of = on_axis(range, width);
  const lane_height = (height - top) / lanes_of(marks).length;
  pen.font = `600 ${0.8 * rem}px system-ui, sans-serif`;
  pen.textBaseline = 'middle';
  for (const { marks: all, kind, side, lane, x } of clusters_of(marks, range, width, rem)) {
    const y = top + (lane + 0.5) * lane_height;
    pen.fillStyle = pen.strokeStyle = color(side === 'none' ? 'ink' : side);
    pen.globalAlpha = 0.35;
    for (const mark of all)
      if (mark.kind === 'phase' || mark.kind === 'kill') pen.fillRect(Math.round(x_of(mark.t)), top, 1, height - top);
    pen.globalAlpha = 1;
    const size = Math.min(0.42 * lane_height, kHalfGlyph * rem);
    draw_glyph(pen, kind, x, y, size);
    if (all.length > 1) pen.fillText(String(all.length), x + (kHalfGlyph + kBeside) * rem, y + 0.5);
  }
}

export function Events() {
  const { marks } = use_page();
  const range = use_range();
  const canvas = use_canvas((sheet) => {
    draw_ticks(sheet, range);
    draw_marks(sheet, marks, range);
  }, [marks, range]);
  return (
    <Row row="events" label="events" class="events" scrub>
      <canvas class="fill" ref={canvas} aria-label="Events of the run; the story lists them in words" role="img" />
    </Row>
  );
}

/** The whole run in one line; the window can be moved. */
export function Overview() {
  const page = use_page();
  const zoom = use_view(page.store, (v) => v.zoom);
  const time = use_paced(page.store, (v) => v.time);
  const end = use_view(page.store, (v) => v.end);
  const marks = useMemo(() => page.marks.filter((m) => m.kind !== 'contact'), [page]);
  const canvas = use_canvas(({ pen, width, height }) => {
    for (const { t, kind, side } of marks) {
      pen.fillStyle = color(side === 'none' ? 'dim' : side);
      const tall = kind === 'kill' ? height : height * 0.5;
      pen.fillRect(Math.round((t / end) * width), (height - tall) / 2, kind === 'kill' ? 2 : 1, tall);
    }
  }, [marks, end]);
  const moving = useRef<number | null>(null);
  const percent = (t: number): string => `${((t / end) * 100).toFixed(3)}%`;
  return (
    <div class="overview" title="The whole run; drag the window to move it">
      <div class="row-label" />
      <div class="overview-plot"
        onPointerDown={(event) => {
          moving.current = event.clientX;
          event.currentTarget.setPointerCapture(event.pointerId);
          go_there(page, event);
        }}
        onPointerMove={(event) => {
          if (moving.current === null) return;
          const seconds = ((event.clientX - moving.current) / event.currentTarget.clientWidth) * end;
          moving.current = event.clientX;
          if (page.store.get().zoom) pan_by(page, seconds);
          else go_there(page, event);
        }}
        onPointerUp={() => (moving.current = null)} onPointerCancel={() => (moving.current = null)}>
        <canvas class="fill" ref={canvas} aria-hidden="true" />
        <div class="overview-passed" style={{ width: percent(time) }} />
        {zoom && <div class="overview-window" style={{ left: percent(zoom[0]), width: percent(zoom[1] - zoom[0]) }} />}
      </div>
    </div>
  );
}

/** Without a zoom the time goes where the pointer is, otherwise the window. */
function go_there(page: Page, event: { clientX: number; currentTarget: HTMLElement }): void {
  const { left, width } = event.currentTarget.getBoundingClientRect();
  const { zoom, end } = page.store.get();
  const t = Math.min(Math.max((event.clientX - left) / width, 0), 1) * end;
  if (zoom) bring_in_sight(page, t);
  else page.store.set({ time: t });
}
