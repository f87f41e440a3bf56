// SPDX-License-Identifier: MIT
/** Small models of what flies and drives, in m: the nose toward -z, right wing +x, up +y. Flat shaded, and never
 * smaller on screen than can be read. */
import { BoxGeometry, BufferGeometry, Euler, Float32BufferAttribute, Matrix4, Vector3 } from 'three';
import type { Missile, Player } from '../run/run.ts';
import type { Eye } from './eye.ts';
import { kCrowd } from './frame.ts';
import type { Poses } from './motion.ts';

type Corner = [x: number, y: number, z: number];
/** A cross section of a body: where, half its width, half its height, and how high its middle is. */
type Section = [z: number, half_width: number, half_height: number, y: number];

export type ShapeName = 'eagle' | 'fulcrum' | 'fighter' | 'truck' | 'missile';

export interface Shape {
  geometry: BufferGeometry;
  /** Its right half from above, from the nose back: x z of each corner, in m. Enough for one of a crowd. */
  outline: readonly (readonly [x: number, z: number])[];
  length: number;  // m
}

class Modeller {
  private readonly corners: number[] = [];

  triangle(a: Corner, b: Corner, c: Corner): void {
    this.corners.push(...a, ...b, ...c);
  }
  /** Corners counter-clockwise as seen from outside. */
  quad(a: Corner, b: Corner, c: Corner, d: Corner): void {
    this.triangle(a, b, c);
    this.triangle(a, c, d);
  }
  /** A body through the sections, front to back, with `sides` sides; `x` to the right of the middle. */
  body(sections: Section[], sides = 6, x = 0): void {
    const corner = ([z, w, h, y]: Section, k: number): Corner => {
      const angle = (2 * Math.PI * (k + 0.5)) / sides;
      return [x + w * Math.cos(angle), y + h * Math.sin(angle), z];
    };
    for (let i = 0; i + 1 < sections.length; ++i)
      for (let k = 0; k < sides; ++k)
        this.quad(corner(sections[i]!, k), corner(sections[i + 1]!, k), corner(sections[i + 1]!, k + 1), corner(sections[i]!, k + 1));
    const [z, , , y] = sections.at(-1)!;
    for (let k = 0; k < sides; ++k) this.triangle(corner(sections.at(-1)!, k), [x, y, z], corner(sections.at(-1)!, k + 1));
  }
  /** A thin plate over an outline; both its faces rise to `thick` over the middle, so that light tells them apart. */
  plate(outline: Corner[], thick: number, normal: Corner): void {
    const middle = [0, 1, 2].map((axis) => outline.reduce((sum, c) => sum + c[axis]!, 0) / outline.length);
    const ridge = (sign: number): Corner => [0, 1, 2].map((axis) => middle[axis]! + normal[axis]! * sign * thick) as Corner;
    const [above, below] = [ridge(1), ridge(-1)];
    outline.forEach((a, i) => {
      const b = outline[(i + 1) % outline.length]!;
      this.triangle(a, b, above);
      this.triangle(b, a, below);
    });
  }
  /** Right and left at once: the outline to the right as seen from above, counter-clockwise. */
  wings(outline: [x: number, z: number][], y: number, thick = 0.2): void {
    this.plate(outline.map(([x, z]) => [x, y, z]), thick, [0, 1, 0]);
    this.plate(outline.map(([x, z]): Corner => [-x, y, z]).reverse(), thick, [0, 1, 0]);
  }
  /** A fin: its outline in the plane of z and y, at `x`, its tip leaning out by `lean`. */
  fin(outline: [z: number, y: number][], x: number, lean = 0): void {
    const low = Math.min(...outline.map(([, y]) => y));
    this.plate(outline.map(([z, y]): Corner => [x + (y - low) * lean, y, z]), 0.12, [1, 0, 0]);
  }
  /** On (x, y, z), the middle of its lower face. */
  box(x: number, y: number, z: number, width: number, height: number, length: number): void {
    const box = new BoxGeometry(width, height, length).translate(x, y + height / 2, z).toNonIndexed();
    this.corners.push(...box.getAttribute('position').array);
  }
  done(length: number, outline: Shape['outline']): Shape {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(this.corners, 3));
    geometry.computeVertexNormals();
    return { geometry, length, outline };
  }
}

/** Broad wings, two upright fins. */
function eagle(): Shape {
  const m = new Modeller();
  m.body([[-9.7, 0.05, 0.05, -0.1], [-7.5, 0.6, 0.6, 0], [-5, 0.85, 1.05, 0.25], [-2, 0.9, 0.9, 0.1], [6, 0.8, 0.5, 0]]);
  for (const side of [-1, 1]) m.body([[-4, 0.7, 0.8, -0.1], [2, 0.85, 0.75, -0.1], [8, 0.7, 0.65, 0], [8.9, 0.5, 0.5, 0]], 6, side * 1.3);
  m.wings([[1.8, -3], [1.8, 4], [6.5, 4.2], [6.5, 2.2]], 0.3);
  m.wings([[1.9, 5.4], [1.9, 8.6], [4.3, 9.6], [4.3, 8]], 0);
  for (const side of [-1, 1]) m.fin([[4.4, 0.5], [7.3, 3.6], [8.6, 3.6], [8.4, 0.5]], side * 1.9);
  return m.done(19.4, [[0, -9.7], [0.9, -5], [1.9, -3], [6.5, 2.2], [6.5, 4.2], [1.9, 4], [1.9, 5.4], [4.3, 8], [4.3, 9.6], [1.9, 8.9]]);
}

/** Swept wings with long roots, two fins that lean out. */
function fulcrum(): Shape {
  const m = new Modeller();
  m.body([[-8.6, 0.05, 0.05, -0.3], [-6.4, 0.55, 0.6, -0.1], [-4, 0.7, 1, 0.2], [0, 0.7, 0.7, 0.1], [7, 0.3, 0.3, 0]]);
  const engine: Section[] = [[-2.6, 0.6, 0.75, -0.7], [2, 0.7, 0.75, -0.5], [7.2, 0.65, 0.6, -0.2], [8, 0.45, 0.45, -0.2]];
  for (const side of [-1, 1]) m.body(engine, 6, side * 1.25);
  m.wings([[0.6, -5.6], [0.6, 4.4], [5.7, 4.6], [5.7, 3.2], [2, -1.4]], 0);
  m.wings([[1.8, 5.2], [1.8, 7.8], [3.9, 8.9], [3.9, 7.8]], -0.2);
  for (const side of [-1, 1]) m.fin([[3.4, 0.2], [6.6, 3.2], [7.7, 3.2], [7, 0.2]], side * 1.8, side * 0.22);
  return m.done(17.3, [[0, -8.6], [0.7, -5.6], [2, -1.4], [5.7, 3.2], [5.7, 4.6], [1.8, 4.4], [1.8, 5.2], [3.9, 7.8], [3.9, 8.9], [1.9, 8]]);
}

/** One engine, one fin: whatever we have no model for. */
function fighter(): Shape {
  const m = new Modeller();
  m.body([[-7.5, 0.05, 0.05, 0], [-5.5, 0.6, 0.6, 0], [-3.2, 0.8, 1, 0.2], [2, 0.9, 0.85, 0], [7.2, 0.6, 0.6, 0]]);
  m.wings([[0.8, -3.8], [0.8, 3.2], [4.9, 3.2], [4.9, 1.8], [1.4, -1.4]], 0);
  m.wings([[0.8, 4.6], [0.8, 7], [2.9, 7.4], [2.9, 6.4]], 0);
  m.fin([[2.6, 0.6], [5.6, 3.6], [7, 3.6], [6.6, 0.6]], 0);
  return m.done(15, [[0, -7.5], [0.8, -3.8], [1.4, -1.4], [4.9, 1.8], [4.9, 3.2], [0.9, 3.2], [0.9, 4.6], [2.9, 6.4], [2.9, 7.4], [0.6, 7.2]]);
}

function truck(): Shape {
  const m = new Modeller();
  m.box(0, 0.9, 1.4, 2.5, 2.4, 5.2);
  m.box(0, 0.9, -2.3, 2.4, 1.7, 1.6);
  m.box(0, 0.9, -3.5, 1.8, 0.9, 1);
  for (const z of [-2.9, 1.4, 2.9]) m.box(0, 0, z, 2.4, 1, 1);
  return m.done(8, [[0, -4], [1.25, -4], [1.25, 4]]);
}

function missile(): Shape {
  const m = new Modeller();
  m.body([[-1.85, 0.02, 0.02, 0], [-1.4, 0.14, 0.14, 0], [1.85, 0.14, 0.14, 0]], 5);
  m.wings([[0.1, -0.3], [0.1, 0.2], [0.42, 0.2]], 0, 0.03);
  m.wings([[0.1, 1.2], [0.1, 1.8], [0.45, 1.8]], 0, 0.03);
  for (const sign of [-1, 1]) m.fin(sign > 0 ? [[1.2, 0.1], [1.8, 0.45], [1.8, 0.1]] : [[1.2, -0.1], [1.8, -0.1], [1.8, -0.45]], 0);
  return m.done(3.7, [[0, -1.85], [0.14, -1.4], [0.14, 1], [0.45, 1.8], [0.14, 1.85]]);
}

export const kShapes: Record<ShapeName, () => Shape> = { eagle, fulcrum, fighter, truck, missile };

const kByModel: Record<string, ShapeName> = { f15c: 'eagle', mig29: 'fulcrum', su27: 'fulcrum' };

export function shape_of(one: Player | Missile): ShapeName {
  if (!('kind' in one)) return 'missile';
  return one.kind === 'vehicle' ? 'truck' : (kByModel[one.model] ?? 'fighter');
}

/** Least length on screen, CSS px. */
const kLeast: Record<ShapeName, number> = { eagle: 30, fulcrum: 28, fighter: 27, truck: 14, missile: 13 };
const kCrowded = 0.72;

/** Scene units for each m of a model so many km long. */
export function size_of(name: ShapeName, length: number, poses: Poses, i: number, eye: Eye): number {
  const least = kLeast[name] * eye.ui * (poses.count > kCrowd ? kCrowded : 1);
  return 0.001 * Math.max(1, (least * eye.km_per_px(poses.x[i]!, poses.y[i]!, poses.z[i]!)) / length);
}

const [matrix, angles, scale] = [new Matrix4(), new Euler(0, 0, 0, 'YXZ'), new Vector3()];

/** The turn by roll, then pitch, then heading, times `size`; then the place. The next call changes it. */
export function matrix_of(poses: Poses, i: number, size: number): Matrix4 {
  angles.set(poses.pitch[i]!, -poses.heading[i]!, -poses.roll[i]!);
  return matrix.makeRotationFromEuler(angles).scale(scale.setScalar(size)).setPosition(poses.x[i]!, poses.y[i]!, poses.z[i]!);
}
