// SPDX-License-Identifier: MIT
/** Draws without a graphics card: what stands in for one is many times slower than a flat canvas. */
import type { Run } from '../../run/run.ts';
import type { Frame } from '../frame.ts';
import type { Painter } from '../painter.ts';
import type { Volume } from '../radar.ts';
import { FlatFleet } from './fleet.ts';
import { FlatGround, draw_volume } from './ground.ts';
import { FlatLines, FlatPuffs } from './lines.ts';

export class FlatPainter implements Painter {
  readonly flat = true;
  readonly lines = new FlatLines();
  readonly puffs = new FlatPuffs();
  private readonly ground: FlatGround;
  private readonly players: FlatFleet;
  private readonly missiles: FlatFleet;
  private ratio = 1;

  constructor(readonly canvas: HTMLCanvasElement, private readonly context: CanvasRenderingContext2D, run: Run) {
    this.ground = new FlatGround(run.origin);
    this.players = new FlatFleet(run.players);
    this.missiles = new FlatFleet(run.missiles);
  }

  resize(width: number, height: number, ratio: number): void {
    this.ratio = ratio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  draw({ eye, palette, view, players, missiles }: Frame, volume: Volume | null): void {
    const { context } = this;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.ground.draw(context, eye, palette, view.layers.coast);
    if (volume) draw_volume(context, eye, palette, volume);
    this.lines.draw(context, eye);
    this.lines.clear();
    this.players.draw(context, players, eye, palette);
    this.missiles.draw(context, missiles, eye, palette);
    this.puffs.draw(context, eye);
  }

  dispose(): void {
    this.canvas.width = this.canvas.height = 0;
  }
}
