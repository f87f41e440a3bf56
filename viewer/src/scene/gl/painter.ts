// SPDX-License-Identifier: MIT
/** Draws with a graphics card. */
import { DirectionalLight, Group, HemisphereLight, Scene, Vector2, WebGLRenderer } from 'three';
import type { Run } from '../../run/run.ts';
import type { Eye } from '../eye.ts';
import type { Frame } from '../frame.ts';
import type { Painter } from '../painter.ts';
import { kDiffuse, kGround, kSky, kSun, kSunlight } from '../palette.ts';
import type { Volume } from '../radar.ts';
import { Fleet } from './fleet.ts';
import { Ground } from './ground.ts';
import { Lines, type Screen } from './lines.ts';
import { Puffs } from './puffs.ts';
import { RadarVolume } from './radar.ts';

export class GlPainter implements Painter {
  readonly flat = false;
  private readonly screen: Screen = { pixels: { value: new Vector2(1, 1) }, ratio: { value: 1 } };
  private readonly scene = new Scene();
  private readonly players: Fleet;
  private readonly missiles: Fleet;
  private readonly ground: Ground;
  private readonly radar = new RadarVolume(4);
  private readonly renderer: WebGLRenderer;
  readonly lines: Lines;
  readonly puffs: Puffs;

  constructor(readonly canvas: HTMLCanvasElement, context: WebGL2RenderingContext, run: Run, private readonly eye: Eye) {
    this.renderer = new WebGLRenderer({ canvas, context, alpha: false });
    // to ask for errors is to wait for the compiler
    this.renderer.debug.checkShaderErrors = false;
    const { screen } = this;
    const group = new Group();
    // three draws what is opaque first: the ground, then the models
    group.renderOrder = 2;
    this.lines = new Lines(screen, 5, 4096);
    this.puffs = new Puffs(screen, 6);
    this.ground = new Ground(run.origin, screen);
    this.players = new Fleet(group, run.players);
    this.missiles = new Fleet(group, run.missiles);
    const sun = new DirectionalLight(0xffffff, kSunlight);
    sun.position.set(...kSun);
    this.scene.add(new HemisphereLight(kSky, kGround, kDiffuse), sun);
    this.scene.add(group, this.ground.group, this.radar.mesh, this.lines.mesh, this.puffs.mesh);
    // fire and smoke too, so that the first explosion does not have to wait
    this.renderer.compile(this.scene, eye.camera);
  }

  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.screen.pixels.value.set(width * ratio, height * ratio);
    this.screen.ratio.value = ratio * this.eye.ui;
  }

  draw({ eye, palette, view, players, missiles }: Frame, volume: Volume | null): void {
    this.renderer.setClearColor(palette.sky);
    this.ground.update(eye, palette, view.layers.coast);
    this.players.update(players, eye, palette);
    this.missiles.update(missiles, eye, palette);
    this.radar.update(volume, palette);
    this.lines.end();
    this.puffs.end();
    this.renderer.render(this.scene, eye.camera);
  }

  /** With the context goes all that is kept in it. */
  dispose(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
