// SPDX-License-Identifier: MIT
/** Draws with a graphics card. */
import {
  BackSide, BufferAttribute, BufferGeometry, DirectionalLight, Group, HemisphereLight, Mesh, MeshBasicMaterial, Scene, Vector2,
  WebGLRenderer,
} from 'three';
import type { Run } from '../../run/run.ts';
import type { Eye } from '../eye.ts';
import type { Frame } from '../frame.ts';
import type { Painter } from '../painter.ts';
import { type Palette, kDiffuse, kGround, kSky, kSun, kSunlight } from '../palette.ts';
import { type Volume, corner_of as at, kColumns, kRows, kTrackVeil } from '../radar.ts';
import { Fleet } from './fleet.ts';
import { Ground } from './ground.ts';
import { Lines, Puffs, type Screen } from './lines.ts';

/** The radar's volume as triangles. */
class RadarVolume {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly corners: BufferAttribute;

  constructor(order: number) {
    const count = at(kColumns, kRows) + 1;
    const geometry = new BufferGeometry();
    // only the far side is drawn, so that each line of sight through the volume meets it once
    this.corners = new BufferAttribute(new Float32Array(3 * count), 3);
    geometry.setAttribute('position', this.corners);
    const index: number[] = [];
    for (let c = 0; c < kColumns; ++c) index.push(0, at(c, 0), at(c + 1, 0), 0, at(c + 1, kRows), at(c, kRows));
    for (let r = 0; r < kRows; ++r) index.push(0, at(0, r + 1), at(0, r), 0, at(kColumns, r), at(kColumns, r + 1));
    for (let c = 0; c < kColumns; ++c)
      for (let r = 0; r < kRows; ++r)
        index.push(at(c, r), at(c, r + 1), at(c + 1, r + 1), at(c, r), at(c + 1, r + 1), at(c + 1, r));
    geometry.setIndex(index);
    // strongest at the antenna
    const colors = new Float32Array(4 * count).map((_, i) => (i < 4 || i % 4 < 3 ? 1 : 0.3));
    geometry.setAttribute('color', new BufferAttribute(colors, 4));
    const material = new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: BackSide });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  update(volume: Volume | null, palette: Palette): void {
    this.mesh.visible = volume !== null;
    if (!volume) return;
    (this.corners.array as Float32Array).set(volume.corners);
    this.corners.needsUpdate = true;
    this.mesh.material.color.setHex(palette.radar);
    this.mesh.material.opacity = palette.veil * (volume.track ? kTrackVeil : 1);
  }
}

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
