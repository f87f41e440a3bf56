// SPDX-License-Identifier: MIT
/** Small pictures: of buttons, in a box of 16 by 16, and the glyphs of events. */
import { kMarks, type MarkKind } from './marks.ts';

export const kIcons = {
  play: 'M4 2.5L13.5 8L4 13.5Z',
  pause: 'M3.5 2.5H6.5V13.5H3.5ZM9.5 2.5H12.5V13.5H9.5Z',
  back: 'M11.5 3V13L4.5 8Z',
  on: 'M4.5 3V13L11.5 8Z',
  back_to: 'M3 3H5V13H3ZM13 3V13L6 8Z',
  on_to: 'M11 3H13V13H11ZM3 3V13L10 8Z',
  closer: 'M7 2.5A4.5 4.5 0 1 0 7 11.5A4.5 4.5 0 1 0 7 2.5ZM7 4.8V9.2M4.8 7H9.2M10.4 10.4L14 14',
  sun: 'M8 5A3 3 0 1 0 8 11A3 3 0 1 0 8 5ZM8 1V3M8 13V15M1 8H3M13 8H15M3 3L4.5 4.5M11.5 11.5L13 13M3 13L4.5 11.5M11.5 4.5L13 3',
  moon: 'M13 9.6A5.6 5.6 0 0 1 6.4 3A5.6 5.6 0 1 0 13 9.6Z',
  link: 'M6.6 9.4L9.4 6.6M7.4 4.4L9 2.8A2.7 2.7 0 0 1 13.2 7L11.6 8.6M8.6 11.6L7 13.2A2.7 2.7 0 0 1 2.8 9L4.4 7.4',
  help: 'M5.5 6A2.5 2.5 0 1 1 8.6 8.4Q8 8.7 8 9.6M8 11.6V12.6',
  left: 'M2 3H14V13H2ZM6.5 3V13',
  bottom: 'M2 3H14V13H2ZM2 9H14',
  right: 'M2 3H14V13H2ZM9.5 3V13',
} as const;
export type IconName = keyof typeof kIcons;
/** The others are stroked. */
const kFilled: ReadonlySet<IconName> = new Set(['play', 'pause', 'back', 'on', 'back_to', 'on_to']);

export function Icon({ name }: { name: IconName }) {
  return <svg class={kFilled.has(name) ? 'icon' : 'icon stroked'} viewBox="0 0 16 16" aria-hidden="true"><path d={kIcons[name]} /></svg>;
}

export function IconButton({ icon, label, keys, pressed, onClick }: {
  icon: IconName; label: string; keys?: string; pressed?: boolean; onClick: () => void;
}) {
  const title = keys ? `${label} (${keys})` : label;
  return (
    <button type="button" class="tool" aria-label={label} aria-pressed={pressed} title={title} onClick={onClick}>
      <Icon name={icon} />
    </button>
  );
}

/** Of an event; empty for those that have none. */
export function Glyph({ kind, side = '' }: { kind: MarkKind | null; side?: string }) {
  const glyph = kind && kMarks[kind];
  return (
    <svg class={`icon ${side}`} viewBox="-7 -7 14 14" aria-hidden="true">
      {glyph && <path d={glyph.path} class={glyph.open ? 'open' : ''} />}
    </svg>
  );
}
