// SPDX-License-Identifier: MIT
/** Everybody's model on a flat canvas: faces from back to front, or of a crowd the outlines alone. Faces
 * have the colours that a renderer which knows of light in linear shares makes. */
import { Color, Vector3, type Matrix4 } from 'three';
import { made } from '../../made.ts';
import type { Missile, Player } from '../../run/run.ts';
import type { Eye } from '../eye.ts';
import { kCrowd } from '../frame.ts';
import type { Poses } from '../motion.ts';
import { kDiffuse, kGround, kSky, kSun, kSunlight, css, type Palette } from '../palette.ts';
import { kShapes, shape_of, matrix_of, size_of, type ShapeName } from '../shapes.ts';

interface Model {
  name: ShapeName;
  length: number;  // km
  corners: ArrayLike<number>;  // x y z of the three of each face
  normals: ArrayLike<number>;  // at each of them
  outline: (readonly [x: number, z: number])[];  // all the way around
}

/** px around the picture within which a model may still reach into it. */
const kMargin = 60;
/** Of the faces between which no gap may show. */
const kSeam = 0.6;
/** Of outlines: seen from the side one is but a line. */
const kEdge = 1;

const models = new Map<ShapeName, Model>();

function model_of(name: ShapeName): Model {
  return made(models, name, () => {
    const { geometry, length, outline } = kShapes[name]();
    const [corners, normals] = ['position', 'normal'].map((each) => geometry.getAttribute(each).array);
    const left = outline.filter(([x]) => x > 0).reverse().map(([x, z]) => [-x, z] as const);
    return { name, length: length / 1000, corners: corners!, normals: normals!, outline: [...outline, ...left] };
  });
}

const point = new Vector3();
const [xs, ys] = [new Float64Array(3), new Float64Array(3)];

function outline_of({ outline }: Model, matrix: Matrix4, eye: Eye): number[] {
  return outline.flatMap(([x, z]) => {
    point.set(x, 0, z).applyMatrix4(matrix);
    eye.project(point.x, point.y, point.z);
    return [eye.px, eye.py];
  });
}

/** Those that look here, from back to front: x y of their corners in the picture, how deep these lie together, and how much light it has. */
function faces_of({ corners, normals }: Model, matrix: Matrix4, eye: Eye): { spots: number[]; depth: number; level: number }[] {
  const faces: ReturnType<typeof faces_of> = [];
  for (let at = 0; at < corners.length; at += 9) {
    let depth = 0;
    for (let k = 0; k < 3; ++k) {
      point.fromArray(corners, at + 3 * k).applyMatrix4(matrix);
      eye.project(point.x, point.y, point.z);
      xs[k] = eye.px;
      ys[k] = eye.py;
      depth += eye.depth;
    }
    const [ax, bx, cx, ay, by, cy] = [xs[0]!, xs[1]!, xs[2]!, ys[0]!, ys[1]!, ys[2]!];
    // the y axis of the screen points down
    if ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay) >= 0) continue;
    point.fromArray(normals, at).transformDirection(matrix);
    faces.push({ spots: [ax, ay, bx, by, cx, cy], depth, level: level_of(point.x, point.y, point.z) });
  }
  return faces.sort((a, b) => b.depth - a.depth);
}

function fill(context: CanvasRenderingContext2D, spots: number[], style: string): void {
  context.beginPath();
  for (let k = 0; k < spots.length; k += 2) context.lineTo(spots[k]!, spots[k + 1]!);
  context.closePath();
  context.fillStyle = context.strokeStyle = style;
  context.fill();
  context.stroke();
}

export class FlatFleet {
  private readonly models: Model[] = [];

  /** There may be more of them later. */
  constructor(private readonly all: readonly (Player | Missile)[]) {}

  draw(context: CanvasRenderingContext2D, poses: Poses, eye: Eye, palette: Palette): void {
    const seen: { i: number; depth: number }[] = [];
    for (let i = 0; i < poses.count; ++i)
      if (poses.shown[i] && eye.project(poses.x[i]!, poses.y[i]!, poses.z[i]!) && eye.on_screen(kMargin * eye.ui))
        seen.push({ i, depth: eye.depth });
    const crowd = poses.count > kCrowd;
    context.lineWidth = crowd ? kEdge : kSeam;
    context.lineJoin = 'round';
    for (const { i } of seen.sort((a, b) => b.depth - a.depth)) {
      const model = (this.models[i] ??= model_of(shape_of(this.all[i]!)));
      const matrix = matrix_of(poses, i, size_of(model.name, model.length, poses, i, eye));
      const tint = palette.side[this.all[i]!.side];
      if (crowd) fill(context, outline_of(model, matrix, eye), css(tint));
      else for (const { spots, level } of faces_of(model, matrix, eye)) fill(context, spots, shades_of(tint)[level]!);
    }
  }
}

const kLevels = 24;
/** What is brighter is white already. */
const kBrightest = (kDiffuse + kSunlight) / Math.PI;

/** Light, in linear shares. */
function grey_of(tint: number): number {
  const { r, g, b } = new Color(tint);
  return (r + g + b) / 3;
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
  return made(shades, tint, () =>
    Array.from({ length: kLevels + 1 }, (_, level) => css(new Color(tint).multiplyScalar((level * kBrightest) / kLevels).getHex())));
}
