// SPDX-License-Identifier: MIT
/** The pointer over the timeline and the strips: click jumps, drag scrubs or zooms, wheel zooms or moves. */
import { listen } from '../events.ts';
import { jump, pan_by, zoom_by, zoom_to } from './actions.ts';
import { range_of, type Page } from './page.ts';

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

export interface StackPointer {
  /** A click in a row: whether it has been dealt with. */
  clicked(row: string, t: number, seconds_per_pixel: number): boolean;
  /** The stretch that a drag has marked; null: none. */
  brushed(range: [number, number] | null): void;
}

/** Rows are elements with data-row, those with data-scrub move the time; `plot` is where the time axis lies. */
export function watch_pointer(stack: HTMLElement, plot: HTMLElement, page: Page, then: StackPointer): () => void {
  let drag: Drag | null = null;

  const place = (event: MouseEvent): { t: number; inside: boolean; per_pixel: number } => {
    const { left, width } = plot.getBoundingClientRect();
    const [from, to] = range_of(page.store.get());
    const part = (event.clientX - left) / width;
    return { t: from + part * (to - from), inside: part >= 0 && part <= 1, per_pixel: (to - from) / width };
  };
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
      page.hover.set(inside && row ? { t, row: row.dataset.row! } : null);
      return;
    }
    if (event.pointerId !== drag.id) return;
    drag.moved ||= Math.abs(t - drag.begin) > kClick * per_pixel;
    if (!drag.moved) return;
    page.hover.set({ t, row: drag.row });
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
