// SPDX-License-Identifier: MIT
/** The map below: sea, land, shores and graticule, and a grid in nautical miles. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, ShaderMaterial, type Vector2 } from 'three';
import { type Coast, coast_of, kReach } from './coast.ts';
import type { Eye } from './eye.ts';
import { kNmi } from './frame.ts';
import type { Origin } from './geo.ts';
import { Lines, type Screen } from './lines.ts';
import { type Palette, shares } from './palette.ts';

/** Lines of the grid on each side of the middle, and of the pieces in which each fades. */
const kHalf = 14;
const kPieces = 10;
/** Up to here (shares of the reach) the ground has its own colour. */
const kClear = 0.35;
const kSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500];
/** Each so many lines there is a stronger one, that reaches further. */
const kCoarse = 10;

export interface Grid {
  /** nmi between lines. */
  step: number;
  /** km: the ground seen in the middle of the picture, or lower down if the view is flat. */
  x: number;
  z: number;
}
const seen: Grid = { step: 1, x: 0, z: 0 };

/** Some eight lines to the height of the picture. */
export function grid_of(eye: Eye): Grid {
  const { stance } = eye;
  if (!stance || !eye.hit(eye.width / 2, eye.height * (0.5 + 0.32 * Math.sin(stance.polar)))) return seen;
  seen.x = eye.ground_x;
  seen.z = eye.ground_z;
  const wanted = (eye.km_per_px(seen.x, 0, seen.z) * eye.height) / kNmi / 8;
  seen.step = kSteps.find((step) => step >= wanted) ?? kSteps.at(-1)!;
  return seen;
}

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
        gl_FragColor = vec4(mix(tint, sky, smoothstep(${kClear}, 0.95, far)), 1.0);
      }`,
    uniforms: { tint: { value: new Color() }, sky, middle }, depthWrite: false, side: DoubleSide,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/** Whether all of the picture is ground in its own colour: the sea then needs no drawing. */
function is_near(eye: Eye, x: number, z: number): boolean {
  for (const px of [0, eye.width])
    for (const py of [0, eye.height]) {
      if (!eye.hit(px, py)) return false;
      const { ground_x, ground_z } = eye;
      if (Math.max(Math.hypot(ground_x - x, ground_z - z), Math.hypot(ground_x, ground_z)) > kClear * kReach) return false;
    }
  return true;
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
    const { step, x, z } = grid_of(eye);
    const km = step * kNmi;
    const column = Math.round(x / km);
    const row = Math.round(z / km);
    const key = `${step} ${column} ${row}`;
    const plain = is_near(eye, stance.x, stance.z);
    this.sea.visible = !plain;
    const free = plain ? palette.sea : palette.sky;
    if (key === this.drawn) return free;
    this.drawn = key;
    this.grid.begin();
    this.lay(km, column, row, palette);
    this.lay(km * kCoarse, Math.round(column / kCoarse), Math.round(row / kCoarse), palette);
    this.grid.end();
    return free;
  }

  private lay(step: number, column: number, row: number, palette: Palette): void {
    const { grid } = this;
    const radius = kHalf * step;
    const [mx, mz] = [column * step, row * step];
    const alpha = (a: number, b: number): number => 0.5 * Math.max(0, 1 - (a * a + b * b) / (radius * radius));
    for (let k = -kHalf; k <= kHalf; ++k)
      for (let piece = 0; piece < kPieces; ++piece) {
        const from = radius * ((2 * piece) / kPieces - 1);
        const to = radius * ((2 * (piece + 1)) / kPieces - 1);
        const off = k * step;
        const [a, b] = [alpha(off, from), alpha(off, to)];
        if (a === 0 && b === 0) continue;
        grid.pen(palette.grid, 0.9);
        grid.add(mx + off, 0, mz + from, mx + off, 0, mz + to, a, b);
        grid.add(mx + from, 0, mz + off, mx + to, 0, mz + off, a, b);
      }
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
