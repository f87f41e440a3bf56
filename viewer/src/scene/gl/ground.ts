// SPDX-License-Identifier: MIT
/** The map below: sea, land, shores and graticule, and a grid in nautical miles. */
import { BufferAttribute, BufferGeometry, CircleGeometry, Color, DoubleSide, Group, LinearSRGBColorSpace, Mesh, ShaderMaterial, Vector2 } from 'three';
import { type Coast, coast_of, draw_shores, kReach } from '../coast.ts';
import type { Eye } from '../eye.ts';
import type { Origin } from '../geo.ts';
import { draw_grid, grid_of, kClear, kHazy } from '../grid.ts';
import { Lines, type Screen } from './lines.ts';
import type { Palette } from '../palette.ts';

type Flat = Mesh<BufferGeometry, ShaderMaterial>;

/** Drawn before all else. Flat at y = 0, in one colour, that goes over into the sky's far from the middle. */
function flat(geometry: BufferGeometry, order: number, middle: { value: Vector2 }, sky: { value: Color }): Flat {
  const material = new ShaderMaterial({
    vertexShader: 'varying vec2 at; void main() { at = position.xz; gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0); }',
    fragmentShader: `uniform vec3 tint; uniform vec3 sky; uniform vec2 middle; varying vec2 at;
      void main() {
        float far = max(length(at), distance(at, middle)) / ${kReach}.0;
        gl_FragColor = vec4(mix(tint, sky, smoothstep(${kClear}, ${kHazy}, far)), 1.0);
      }`,
    uniforms: { tint: { value: new Color() }, sky, middle }, depthWrite: false, side: DoubleSide,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

export class Ground {
  readonly group = new Group();
  private readonly coast: Coast;
  private readonly sky = { value: new Color() };
  private readonly middle = { value: new Vector2() };
  private readonly sea: Flat;
  private readonly land: Flat;
  private readonly shores: Lines;
  private readonly grid: Lines;
  private palette: Palette | null = null;  // In which it was painted.

  constructor(origin: Origin, screen: Screen) {
    this.coast = coast_of(origin);
    this.sea = flat(new CircleGeometry(kReach, 64).rotateX(-Math.PI / 2), 0, this.middle, this.sky);
    this.land = flat(new BufferGeometry().setAttribute('position', new BufferAttribute(this.coast.land, 3)), 1, this.middle, this.sky);
    this.shores = new Lines(screen, 2);
    this.grid = new Lines(screen, 3);
    this.group.add(this.sea, this.land, this.shores.mesh, this.grid.mesh);
  }

  private paint(palette: Palette): void {
    this.palette = palette;
    // as the screen shows it: shaders write without conversion
    const put = (color: Color, tint: number): Color => color.setHex(tint, LinearSRGBColorSpace);
    put(this.sky.value, palette.sky);
    put(this.sea.material.uniforms.tint!.value as Color, palette.sea);
    put(this.land.material.uniforms.tint!.value as Color, palette.land);
    draw_shores(this.shores, this.coast, palette);
    this.shores.end();
  }

  /** The grid around the middle of the picture; `coast` shows land and shores. */
  update(eye: Eye, palette: Palette, coast: boolean): void {
    if (palette !== this.palette) this.paint(palette);
    this.land.visible = coast;
    this.shores.mesh.visible = coast;
    const { x, z } = eye.stance;
    this.middle.value.set(x, z);
    this.shores.haze.set(x, kReach, z);
    draw_grid(this.grid, grid_of(eye), palette);
    this.grid.end();
  }
}
