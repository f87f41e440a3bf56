// SPDX-License-Identifier: MIT
/** From pointers and wheel to what the user means: turn, push, zoom, click. */
import { listen } from '../events.ts';

export interface Hand {
  /** Drag with the main button, px. */
  drag(dx: number, dy: number): void;
  /** Drag with another button, with shift or ctrl, or with two fingers, px. */
  push(dx: number, dy: number): void;
  zoom(factor: number, px: number, py: number): void;
  click(px: number, py: number, shift: boolean): void;
  /** The pointer is here without a button down; null: it left. */
  hover(px: number | null, py: number): void;
}

/** px that a click may wander, and a finger. */
const kWander = { mouse: 4, touch: 12 };
const kWheel = 0.0014;
/** px of wheels that count in lines. */
const kLine = 18;
/** ms: a finger that rests for so long means what shift and a click do. */
const kRests = 450;

/** Returns how to stop listening. */
export function watch_hand(element: HTMLElement, hand: Hand): () => void {
  const pointers = new Map<number, { x: number; y: number }>();
  let wandered = 0;
  let spread = 0;
  let since = 0;
  const rests = ({ pointerType }: PointerEvent): boolean => wandered <= kWander[pointerType === 'touch' ? 'touch' : 'mouse'];
  const local = (event: MouseEvent): { x: number; y: number } => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const down = (event: PointerEvent): void => {
    if (pointers.size === 0) wandered = 0;
    pointers.set(event.pointerId, local(event));
    spread = 0;
    since = event.timeStamp;
    element.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent): void => {
    const at = local(event);
    const last = pointers.get(event.pointerId);
    if (!last) return hand.hover(at.x, at.y);
    const dx = at.x - last.x;
    const dy = at.y - last.y;
    pointers.set(event.pointerId, at);
    wandered += Math.abs(dx) + Math.abs(dy);
    if (rests(event)) return;
    if (pointers.size > 1) {
      const [a, b] = [...pointers.values()] as [typeof at, typeof at];
      const apart = Math.hypot(a.x - b.x, a.y - b.y);
      if (spread > 0 && apart > 0) hand.zoom(spread / apart, (a.x + b.x) / 2, (a.y + b.y) / 2);
      spread = apart;
      hand.push(dx / 2, dy / 2);
    } else if (event.buttons & 6 || event.shiftKey || event.ctrlKey) {
      hand.push(dx, dy);
    } else {
      hand.drag(dx, dy);
    }
  };
  const lift = (event: PointerEvent): void => {
    const was = pointers.get(event.pointerId);
    pointers.delete(event.pointerId);
    spread = 0;
    if (!was || event.type !== 'pointerup' || event.button !== 0 || !rests(event)) return;
    hand.click(was.x, was.y, event.shiftKey || (event.pointerType === 'touch' && event.timeStamp - since > kRests));
  };
  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const at = local(event);
    const turned = event.deltaY * (event.deltaMode === 1 ? kLine : 1);
    hand.zoom(Math.exp(Math.max(-300, Math.min(300, turned)) * kWheel), at.x, at.y);
  };
  return listen(element, {
    pointerdown: down, pointermove: move, pointerup: lift, pointercancel: lift, pointerleave: () => hand.hover(null, 0),
    contextmenu: (event) => event.preventDefault(), wheel,
  }, { passive: false });
}
