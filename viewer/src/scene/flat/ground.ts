// SPDX-License-Identifier: MIT
/** Areas on a flat canvas, as far as they are in front of the eye: the map below, which is sea, land, shores and graticule, far haze, and
 * the grid; and the radar's volume, which is two of them, its lower and its upper face, each half of the veil. */
import { MathUtils } from 'three';
import { type Coast, coast_of, draw_shores, kReach } from '../coast.ts';
import type { Eye } from '../eye.ts';
import type { Origin } from '../geo.ts';
import { draw_grid, grid_of, is_near, kClear, kHazy } from '../grid.ts';
import { type Palette, css, fill } from '../palette.ts';
import { FlatLines } from './lines.ts';
import { type Volume, corner_of, kColumns, kRows, kTrackVeil } from '../radar.ts';

/** km: nothing nearer to the eye is drawn. */
const kNear = 0.05;

/** Adds the polygon with these corners (x y z each, in the scene) to the path: `count` of them from number `first`. */
export function trace_area(path: Path2D, eye: Eye, corners: ArrayLike<number>, first = 0, count = corners.length / 3): void {
  let begun = false;
  const put = (x: number, y: number, z: number): void => {
    eye.project(x, y, z);
    if (begun) path.lineTo(eye.px, eye.py);
    else path.moveTo(eye.px, eye.py);
    begun = true;
  };
  for (let i = 0; i < count; ++i) {
    const a = 3 * (first + i);
    const b = 3 * (first + ((i + 1) % count));
    const [ax, ay, az] = [corners[a]!, corners[a + 1]!, corners[a + 2]!];
    const [bx, by, bz] = [corners[b]!, corners[b + 1]!, corners[b + 2]!];
    const before = eye.depth_of(ax, ay, az) - kNear;
    const after = eye.depth_of(bx, by, bz) - kNear;
    if (before >= 0) put(ax, ay, az);
    if (before >= 0 === after >= 0) continue;
    const share = before / (before - after);
    put(ax + (bx - ax) * share, ay + (by - ay) * share, az + (bz - az) * share);
  }
  if (begun) path.closePath();
}

/** Corners of a circle on the ground. */
function circle_on_ground(x: number, z: number, radius: number, corners = 64): Float64Array {
  const out = new Float64Array(3 * corners);
  for (let k = 0; k < corners; ++k) {
    out[3 * k] = x + radius * Math.cos((2 * Math.PI * k) / corners);
    out[3 * k + 2] = z + radius * Math.sin((2 * Math.PI * k) / corners);
  }
  return out;
}

/** Share of the veil that is left at its far end. */
const kFar = 0.3;

/** The antenna, then one row of the front. */
const face = new Float32Array(3 * (kColumns + 2));

/** Brightest at the antenna, if that is in front of the eye. */
function shade_of(context: CanvasRenderingContext2D, eye: Eye, tint: number, veil: number): CanvasGradient | string {
  const middle = 3 * (1 + kColumns / 2);
  if (!eye.project(face[middle]!, face[middle + 1]!, face[middle + 2]!)) return css(tint, veil);
  const [far_x, far_y] = [eye.px, eye.py];
  if (!eye.project(face[0]!, face[1]!, face[2]!)) return css(tint, veil * kFar);
  const reach = Math.max(1, Math.hypot(far_x - eye.px, far_y - eye.py));
  const shade = context.createRadialGradient(eye.px, eye.py, 0, eye.px, eye.py, reach);
  shade.addColorStop(0, css(tint, veil));
  shade.addColorStop(1, css(tint, veil * kFar));
  return shade;
}

export function draw_volume(context: CanvasRenderingContext2D, eye: Eye, palette: Palette, { corners, track }: Volume): void {
  const veil = (palette.veil * (track ? kTrackVeil : 1)) / 2;
  for (const row of [0, kRows]) {
    const from = 3 * corner_of(0, row);
    face.set(corners.subarray(0, 3));
    face.set(corners.subarray(from, from + 3 * (kColumns + 1)), 3);
    const path = new Path2D();
    trace_area(path, eye, face);
    context.fillStyle = shade_of(context, eye, palette.radar, veil);
    context.fill(path);
  }
}

/** So many veils lie over each other until all is sky. */
const kVeils = 10;

export class FlatGround {
  private readonly coast: Coast;
  private readonly shores = new FlatLines();
  private palette: Palette | null = null;  // Of the shores.
  private readonly grid = new FlatLines();
  private readonly disc = circle_on_ground(0, 0, kReach);

  constructor(origin: Origin) {
    this.coast = coast_of(origin);
  }

  draw(context: CanvasRenderingContext2D, eye: Eye, palette: Palette, coast: boolean): void {
    const { x, z } = eye.stance;
    const plain = is_near(eye, x, z);
    context.fillStyle = css(plain ? palette.sea : palette.sky);
    context.fillRect(0, 0, eye.width, eye.height);
    if (!plain) {
      const sea = new Path2D();
      trace_area(sea, eye, this.disc);
      fill(context, palette.sea, 1, sea);
    }
    if (coast) this.draw_land(context, eye, palette);
    if (!plain) this.draw_haze(context, eye, palette, x, z);
    draw_grid(this.grid, grid_of(eye), palette);
    this.grid.draw(context, eye);
    this.grid.clear();
  }

  private draw_land(context: CanvasRenderingContext2D, eye: Eye, palette: Palette): void {
    const land = new Path2D();
    const { land: corners } = this.coast;
    for (let i = 0; i < corners.length / 3; i += 3) trace_area(land, eye, corners, i, 3);
    fill(context, palette.land, 1, land);
    if (palette !== this.palette) {
      this.palette = palette;
      this.shores.clear();
      draw_shores(this.shores, this.coast, palette);
    }
    this.shores.draw(context, eye);
  }

  /** Over all that is further out than a circle, one veil of sky after the other, so that together they make a smooth step. */
  private draw_haze(context: CanvasRenderingContext2D, eye: Eye, palette: Palette, x: number, z: number): void {
    let clear = 1;
    for (let k = 0; k < kVeils; ++k) {
      const veil = new Path2D();
      veil.rect(0, 0, eye.width, eye.height);
      trace_area(veil, eye, circle_on_ground(x, z, kReach * (kClear + ((kHazy - kClear) * (k + 0.5)) / kVeils)));
      const left = 1 - MathUtils.smoothstep(k + 1, 0, kVeils);
      fill(context, palette.sky, 1 - left / clear, veil, 'evenodd');
      clear = left;
    }
  }
}
