// SPDX-License-Identifier: MIT
/** The map below: sea, land, shores and graticule, and a grid in nautical miles. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, ShaderMaterial, type Vector2 } from 'three';
import { type Coast, coast_of, kReach } from '../coast.ts';
import type { Eye } from '../eye.ts';
import type { Origin } from '../geo.ts';
import { draw_grid, grid_key, grid_of, is_near, kClear, kHazy } from '../grid.ts';
import { Lines, type Screen } from './lines.ts';
import { type Palette, shares } from '../palette.ts';

type Flat = Mesh<BufferGeometry, ShaderMaterial>;

/** Drawn before all else. Flat at y = 0, in one colour, that goes over into the sky's far from the middle. */
function flat(corners: Float32Array, order: number, middle: { value: Vector2 }, sky: { value: Color }): Flat {
  const geometry = new BufferGeometry();
  const places = new Float32Array((corners.length / 2) * 3);
  for (let i = 0; i < corners.length / 2; ++i) places.set([corners[2 * i]!, 0, -corners[2 * i + 1]!], 3 * i);
  geometry.setAttribute('position', new BufferAttribute(places, 3));
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

function disc(): Float32Array {
  const out: number[] = [];
  const corner = (k: number): [number, number] => [kReach * Math.cos((k * Math.PI) / 32), kReach * Math.sin((k * Math.PI) / 32)];
  for (let k = 0; k < 64; ++k) out.push(0, 0, ...corner(k), ...corner(k + 1));
  return Float32Array.from(out);
}

export class Ground {
  readonly group = new Group();
  private readonly coast: Coast;
  private readonly sky = { value: new Color() };
  private readonly middle: { value: Vector2 };
  private readonly sea: Flat;
  private readonly land: Flat;
  private readonly shores: Lines;
  private readonly grid: Lines;
  private drawn = '';

  constructor(origin: Origin, screen: Screen, middle: Vector2) {
    this.coast = coast_of(origin);
    this.middle = { value: middle };
    this.sea = flat(disc(), 0, this.middle, this.sky);
    this.land = flat(this.coast.land, 1, this.middle, this.sky);
    this.shores = new Lines(screen, 2);
    this.grid = new Lines(screen, 3);
    this.group.add(this.sea, this.land, this.shores.mesh, this.grid.mesh);
  }

  paint(palette: Palette): void {
    this.sky.value.setRGB(...shares(palette.sky));
    (this.sea.material.uniforms.tint!.value as Color).setRGB(...shares(palette.sea));
    (this.land.material.uniforms.tint!.value as Color).setRGB(...shares(palette.land));
    const { shores, coast } = this;
    const put = (flat_lines: Float32Array, alpha: number): void => {
      for (let i = 0; i < flat_lines.length; i += 4)
        shores.add(flat_lines[i]!, 0, -flat_lines[i + 1]!, flat_lines[i + 2]!, 0, -flat_lines[i + 3]!, alpha);
    };
    shores.begin();
    shores.pen(palette.shore, 1);
    put(coast.graticule, 0.22);
    shores.pen(palette.shore, 1.4);
    put(coast.shore, 0.9);
    shores.end();
    this.drawn = '';
  }

  /** The grid around the middle of the picture; `coast` shows land and shores. Returns the colour of what is left free. */
  update(eye: Eye, palette: Palette, coast: boolean): number {
    this.land.visible = coast;
    this.shores.mesh.visible = coast;
    const { stance } = eye;
    if (!stance) return palette.sky;
    this.middle.value.set(stance.x, stance.z);
    this.shores.haze.set(stance.x, kReach, stance.z);
    const grid = grid_of(eye);
    const key = grid_key(grid);
    const plain = is_near(eye, stance.x, stance.z);
    this.sea.visible = !plain;
    const free = plain ? palette.sea : palette.sky;
    if (key === this.drawn) return free;
    this.drawn = key;
    this.grid.begin();
    draw_grid(this.grid, grid, palette);
    this.grid.end();
    return free;
  }

  dispose(): void {
    for (const mesh of [this.sea, this.land]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.shores.dispose();
    this.grid.dispose();
  }
}
