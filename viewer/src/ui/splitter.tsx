// SPDX-License-Identifier: MIT
/** The border of a panel: drag it, or move it with the arrow keys; a double click hides the panel. */
import { useRef } from 'preact/hooks';
import { rem_size } from './canvas.ts';

/** Sizes are in rem; `grows` says in which direction of the screen the panel gets larger. */
export function Splitter({ label, size, limits: [least, most], grows, onChange, onHide }: {
  label: string; size: number; limits: readonly [least: number, most: number]; grows: 'left' | 'right' | 'up';
  onChange: (size: number) => void; onHide: () => void;
}) {
  const from = useRef<{ at: number; size: number } | null>(null);
  const sign = grows === 'right' ? 1 : -1;
  const put = (wanted: number): void => onChange(Math.min(Math.max(wanted, least), most));
  const place = (event: PointerEvent): number => (grows === 'up' ? event.clientY : event.clientX);
  const steps: Record<string, number> = grows === 'up' ? { ArrowUp: 1, ArrowDown: -1 } : { ArrowLeft: -sign, ArrowRight: sign };
  return (
    <div class={`splitter grows-${grows}`} role="separator" tabIndex={0} title={`${label}: drag; a double click hides it`}
      aria-label={label} aria-orientation={grows === 'up' ? 'horizontal' : 'vertical'}
      aria-valuenow={Math.round(size)} aria-valuemin={least} aria-valuemax={most}
      onPointerDown={(event) => {
        from.current = { at: place(event), size };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => from.current && put(from.current.size + (sign * (place(event) - from.current.at)) / rem_size())}
      onPointerUp={() => (from.current = null)} onPointerCancel={() => (from.current = null)} onDblClick={onHide}
      onKeyDown={(event) => {
        const step = steps[event.key];
        if (step === undefined) return;
        put(size + step);
        event.preventDefault();
      }} />
  );
}
