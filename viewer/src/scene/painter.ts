// SPDX-License-Identifier: MIT
/** What the layers draw with, and what puts it on the screen: with a graphics card (gl) if there is one, or without (flat). */
import type { Run } from '../run/run.ts';
import type { Eye } from './eye.ts';
import { FlatPainter } from './flat/painter.ts';
import type { Frame } from './frame.ts';
import { GlPainter } from './gl/painter.ts';
import type { Volume } from './radar.ts';

/** Segments in scene units. */
export interface Pens {
  /** What follows has this colour and width (CSS px), and dashes as long as this with their gaps (CSS px); 0: solid. */
  pen(tint: number, width: number, dash?: number): void;
  /** From opacity to opacity. */
  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, alpha: number, to_alpha?: number): void;
}

/** Soft discs that face the eye: fire, smoke and flashes. */
export interface Discs {
  /** `radius` in scene units, but at least `least` CSS px. */
  add(x: number, y: number, z: number, radius: number, least: number, tint: number, alpha: number): void;
}

export interface Painter {
  readonly canvas: HTMLCanvasElement;
  readonly flat: boolean;  // There is no graphics card.
  readonly lines: Pens;
  readonly puffs: Discs;
  /** Size of the picture in CSS px, and how many of its own pixels are drawn for each of those. */
  resize(width: number, height: number, ratio: number): void;
  /** The picture: ground, everybody, the radar's volume, and what was given to lines and puffs, which are then empty for the next. */
  draw(frame: Frame, volume: Volume | null): void;
  dispose(): void;
}

/** Whether the processor stands in for a graphics card. */
function is_stand_in(context: WebGL2RenderingContext): boolean {
  const named = context.getExtension('WEBGL_debug_renderer_info');
  const name: unknown = named && context.getParameter(named.UNMASKED_RENDERER_WEBGL);
  return typeof name === 'string' && /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** What the address asks for: "?draw=webgl" or "?draw=canvas" after the name of the file; null: what suits the machine. */
const wish = (): string | null => new URLSearchParams(location.search).get('draw');

function new_canvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;inset:0;width:100%;height:100%;display:block';
  return canvas;
}

function with_card(run: Run, eye: Eye): Painter | null {
  const canvas = new_canvas();
  const context = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'high-performance' });
  if (!context) return null;
  if (wish() === 'webgl' || !is_stand_in(context)) return new GlPainter(canvas, context, run, eye);
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return null;
}

export function painter_for(run: Run, eye: Eye): Painter {
  const painter = wish() === 'canvas' ? null : with_card(run, eye);
  if (painter) return painter;
  const canvas = new_canvas();
  const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true });
  if (!context) throw new Error('this browser offers neither WebGL 2 nor a 2-D canvas');
  return new FlatPainter(canvas, context, run);
}
