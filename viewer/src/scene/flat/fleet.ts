// SPDX-License-Identifier: MIT
/** Everybody's model on a flat canvas: faces from back to front, or of a crowd the outlines alone. Faces
 * have the colours that a renderer which knows of light in linear shares makes. */
import type { Missile, Player } from '../../run/run.ts';
import type { Eye } from '../eye.ts';
import { kCrowd } from '../frame.ts';
import type { Poses } from '../motion.ts';
import { kDiffuse, kGround, kSky, kSun, kSunlight, css, shares, type Palette } from '../palette.ts';
import { kShapes, shape_of, type ShapeName } from '../shapes.ts';
import { size_of, write_matrix } from '../stature.ts';

interface Model {
  name: ShapeName;
  length: number;  // km
  corners: ArrayLike<number>;  // Nine numbers for each face.
  faces: number;
  outline: number[];  // x z, all the way around.
}

/** px around the picture within which a model may still reach into it. */
const kMargin = 60;
/** Of the faces between which no gap may show. */
const kSeam = 0.6;
/** Of outlines. */
const kEdge = 1;

const models = new Map<ShapeName, Model>();

function model_of(name: ShapeName): Model {
  let model = models.get(name);
  if (!model) {
    const { geometry, length, outline } = kShapes[name]();
    const corners = geometry.getAttribute('position').array;
    const left = outline.filter(([x]) => x > 0).reverse().map(([x, z]) => [-x, z]);
    model = { name, length: length / 1000, corners, faces: corners.length / 9, outline: [...outline, ...left].flat() };
    models.set(name, model);
  }
  return model;
}

export class FlatFleet {
  private readonly models: Model[];
  private readonly matrix = new Float32Array(16);
  private readonly order: number[] = [];
  private readonly depths: Float64Array;
  /** Of the model that is drawn: x y of the corners of each face, how deep it lies, and those that are seen. */
  private readonly spots: Float64Array;
  private readonly deep: Float64Array;
  private readonly seen: number[] = [];

  constructor(private readonly all: readonly (Player | Missile)[]) {
    this.models = all.map((one) => model_of(shape_of(one)));
    const most = this.models.reduce((faces, model) => Math.max(faces, model.faces), 0);
    this.spots = new Float64Array(6 * most);
    this.deep = new Float64Array(most);
    this.depths = new Float64Array(all.length);
  }

  draw(context: CanvasRenderingContext2D, poses: Poses, eye: Eye, palette: Palette): void {
    const { order, depths } = this;
    order.length = 0;
    for (let i = 0; i < poses.count; ++i) {
      if (!poses.shown[i] || !eye.project(poses.x[i]!, poses.y[i]!, poses.z[i]!) || !eye.on_screen(kMargin * eye.ui)) continue;
      depths[i] = eye.depth;
      order.push(i);
    }
    order.sort((a, b) => depths[b]! - depths[a]!);
    context.lineWidth = poses.count > kCrowd ? kEdge : kSeam;
    context.lineJoin = 'round';
    for (const i of order) {
      const model = this.models[i]!;
      write_matrix(this.matrix, 0, poses, i, size_of(model.name, model.length, poses, i, eye));
      const tint = palette.side[this.all[i]!.side];
      if (poses.count > kCrowd) this.outline(context, model, tint, eye);
      else this.shade(context, model, tint, eye);
    }
  }

  /** Leaves the faces that look here in `seen`. */
  private turn({ corners, faces }: Model, eye: Eye): void {
    const { matrix: m, spots, deep, seen } = this;
    seen.length = 0;
    for (let face = 0; face < faces; ++face) {
      let depth = 0;
      for (let k = 0; k < 3; ++k) {
        const at = 9 * face + 3 * k;
        const [x, y, z] = [corners[at]!, corners[at + 1]!, corners[at + 2]!];
        eye.project(m[0]! * x + m[4]! * y + m[8]! * z + m[12]!, m[1]! * x + m[5]! * y + m[9]! * z + m[13]!,
          m[2]! * x + m[6]! * y + m[10]! * z + m[14]!);
        spots[6 * face + 2 * k] = eye.px;
        spots[6 * face + 2 * k + 1] = eye.py;
        depth += eye.depth;
      }
      const s = 6 * face;
      const area = (spots[s + 2]! - spots[s]!) * (spots[s + 5]! - spots[s + 1]!) -
        (spots[s + 4]! - spots[s]!) * (spots[s + 3]! - spots[s + 1]!);
      // the y axis of the screen points down
      if (area >= 0) continue;
      deep[face] = depth;
      seen.push(face);
    }
  }

  private trace(context: CanvasRenderingContext2D, face: number): void {
    const { spots } = this;
    const s = 6 * face;
    context.moveTo(spots[s]!, spots[s + 1]!);
    context.lineTo(spots[s + 2]!, spots[s + 3]!);
    context.lineTo(spots[s + 4]!, spots[s + 5]!);
  }

  /** Stroked too: seen from the side it is but a line. */
  private outline(context: CanvasRenderingContext2D, { outline }: Model, tint: number, eye: Eye): void {
    const { matrix: m } = this;
    context.beginPath();
    for (let k = 0; k < outline.length; k += 2) {
      const [x, z] = [outline[k]!, outline[k + 1]!];
      eye.project(m[0]! * x + m[8]! * z + m[12]!, m[1]! * x + m[9]! * z + m[13]!, m[2]! * x + m[10]! * z + m[14]!);
      if (k === 0) context.moveTo(eye.px, eye.py);
      else context.lineTo(eye.px, eye.py);
    }
    context.closePath();
    context.fillStyle = context.strokeStyle = css(tint);
    context.fill();
    context.stroke();
  }

  private shade(context: CanvasRenderingContext2D, model: Model, tint: number, eye: Eye): void {
    this.turn(model, eye);
    const { corners: c } = model;
    const { matrix: m, deep, seen } = this;
    const shades = shades_of(tint);
    seen.sort((a, b) => deep[b]! - deep[a]!);
    for (const face of seen) {
      const at = 9 * face;
      const [ux, uy, uz] = [c[at + 3]! - c[at]!, c[at + 4]! - c[at + 1]!, c[at + 5]! - c[at + 2]!];
      const [vx, vy, vz] = [c[at + 6]! - c[at]!, c[at + 7]! - c[at + 1]!, c[at + 8]! - c[at + 2]!];
      const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      const [x, y, z] = [m[0]! * nx + m[4]! * ny + m[8]! * nz, m[1]! * nx + m[5]! * ny + m[9]! * nz, m[2]! * nx + m[6]! * ny + m[10]! * nz];
      const length = Math.hypot(x, y, z) || 1;
      context.fillStyle = context.strokeStyle = shades[level_of(x / length, y / length, z / length)]!;
      context.beginPath();
      this.trace(context, face);
      context.closePath();
      context.fill();
      context.stroke();
    }
  }
}

const kLevels = 24;
/** What is brighter is white already. */
const kBrightest = (kDiffuse + kSunlight) / Math.PI;

function to_linear(share: number): number {
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}
function to_screen(light: number): number {
  const share = Math.min(1, light <= 0.0031308 ? light * 12.92 : 1.055 * light ** (1 / 2.4) - 0.055);
  return Math.round(share * 255);
}
function grey_of(tint: number): number {
  return shares(tint).reduce((sum, share) => sum + to_linear(share), 0) / 3;
}

const sky = grey_of(kSky);
const ground = grey_of(kGround);
const sun_length = Math.hypot(...kSun);

/** The level of light on a face with that normal. */
export function level_of(x: number, y: number, z: number): number {
  const above = 0.5 + 0.5 * y;
  const sun = Math.max(0, (x * kSun[0] + y * kSun[1] + z * kSun[2]) / sun_length);
  const light = (kDiffuse * (ground + (sky - ground) * above) + kSunlight * sun) / Math.PI;
  return Math.min(kLevels, Math.round((light / kBrightest) * kLevels));
}

const shades = new Map<number, string[]>();

/** Of a colour at each level. */
export function shades_of(tint: number): string[] {
  let all = shades.get(tint);
  if (!all) {
    const linear = shares(tint).map(to_linear);
    all = Array.from({ length: kLevels + 1 }, (_, level) => {
      const [r, g, b] = linear.map((share) => to_screen((share * level * kBrightest) / kLevels)) as [number, number, number];
      return css((r << 16) | (g << 8) | b);
    });
    shades.set(tint, all);
  }
  return all;
}
