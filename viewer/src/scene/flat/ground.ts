// SPDX-License-Identifier: MIT
/** The map below on a flat canvas: sea, land, shores and graticule, far haze, and the grid. */
import { MathUtils } from 'three';
import { type Coast, coast_of, draw_shores, kReach } from '../coast.ts';
import type { Eye } from '../eye.ts';
import type { Origin } from '../geo.ts';
import { draw_grid, grid_of, is_near, kClear, kHazy } from '../grid.ts';
import { css, fill, type Palette } from '../palette.ts';
import { FlatLines } from './lines.ts';
import { circle_on_ground, trace_area } from './areas.ts';

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
