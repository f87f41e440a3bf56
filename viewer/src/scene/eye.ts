// SPDX-License-Identifier: MIT
/** The camera as the overlay and the screen-sized things need it: from the scene (km) to CSS px and back. */
import { PerspectiveCamera } from 'three';
import { kFov, type Stance } from './rig.ts';

/** km: nothing nearer is seen. */
const kNear = 0.002;
/** px around the picture where lines still go on. */
const kAround = 40;

export class Eye {
  readonly camera = new PerspectiveCamera();
  width = 1;  // CSS px
  height = 1;
  ui = 1;  // How much larger than on a small screen writing and marks are.
  /** Of the last project(): CSS px, and how far in front of the eye (km). */
  px = 0;
  py = 0;
  depth = 0;
  /** Of the last segment(): its other end, CSS px. */
  qx = 0;
  qy = 0;
  /** The last hit of the ground. */
  ground_x = 0;
  ground_z = 0;
  stance: Stance = { x: 0, y: 0, z: 0, height: 1, azimuth: 0, polar: 0, fov: kFov };
  /** Of the last turn(): km to the right of the line of sight, above it, and in front of the eye. */
  private rightward = 0;
  private upward = 0;
  private ahead = 0;
  private readonly right = new Float64Array(3);
  private readonly up = new Float64Array(3);
  private readonly back = new Float64Array(3);
  private readonly at = new Float64Array(3);
  private focal = 1;  // px per unit of depth ratio.

  constructor() {
    this.camera.matrixAutoUpdate = false;
  }

  resize(width: number, height: number, ui = 1): void {
    this.width = width;
    this.height = height;
    this.ui = ui;
    this.camera.aspect = width / Math.max(1, height);
  }

  /** Stands as the rig says. */
  look(stance: Stance): void {
    this.stance = stance;
    const { right: r, up: u, back: b, at, camera } = this;
    const [sa, ca, sp, cp] = [Math.sin(stance.azimuth), Math.cos(stance.azimuth), Math.sin(stance.polar), Math.cos(stance.polar)];
    const tan = Math.tan(stance.fov / 2);
    const distance = stance.height / (2 * tan);
    r.set([ca, 0, sa]);
    u.set([sa * cp, sp, -ca * cp]);
    b.set([-sa * sp, cp, ca * sp]);
    at.set([stance.x + b[0]! * distance, stance.y + b[1]! * distance, stance.z + b[2]! * distance]);
    this.focal = this.height / (2 * tan);
    camera.matrix.set(
      r[0]!, u[0]!, b[0]!, at[0]!, r[1]!, u[1]!, b[1]!, at[1]!, r[2]!, u[2]!, b[2]!, at[2]!, 0, 0, 0, 1);
    camera.matrixWorldNeedsUpdate = true;
    camera.fov = (stance.fov * 180) / Math.PI;
    camera.near = Math.max(kNear, distance * 0.01);
    camera.far = distance + 4000;
    camera.updateProjectionMatrix();
  }

  private turn(x: number, y: number, z: number): void {
    const { right: r, up: u, back: b, at } = this;
    const [dx, dy, dz] = [x - at[0]!, y - at[1]!, z - at[2]!];
    this.rightward = dx * r[0]! + dz * r[2]!;
    this.upward = dx * u[0]! + dy * u[1]! + dz * u[2]!;
    this.ahead = -(dx * b[0]! + dy * b[1]! + dz * b[2]!);
  }

  /** False: behind the eye. */
  project(x: number, y: number, z: number): boolean {
    this.turn(x, y, z);
    this.depth = this.ahead;
    if (this.depth < 1e-3) return false;
    const scale = this.focal / this.depth;
    this.px = this.width / 2 + this.rightward * scale;
    this.py = this.height / 2 - this.upward * scale;
    return true;
  }

  /** What is seen of a segment, from (px, py) to (qx, qy), and some px around the picture; false: nothing. */
  segment(ax: number, ay: number, az: number, bx: number, by: number, bz: number): boolean {
    this.turn(ax, ay, az);
    let { ahead: far_a, rightward: right_a, upward: up_a } = this;
    this.turn(bx, by, bz);
    let { ahead: far_b, rightward: right_b, upward: up_b } = this;
    if (far_a < kNear && far_b < kNear) return false;
    if (far_a < kNear || far_b < kNear) {
      const share = (kNear - far_a) / (far_b - far_a);
      const [right, up] = [right_a + (right_b - right_a) * share, up_a + (up_b - up_a) * share];
      if (far_a < kNear) [far_a, right_a, up_a] = [kNear, right, up];
      else [far_b, right_b, up_b] = [kNear, right, up];
    }
    this.px = this.width / 2 + (right_a * this.focal) / far_a;
    this.py = this.height / 2 - (up_a * this.focal) / far_a;
    this.qx = this.width / 2 + (right_b * this.focal) / far_b;
    this.qy = this.height / 2 - (up_b * this.focal) / far_b;
    return this.cut();
  }

  /** Cuts the last segment to the picture: Liang and Barsky's. */
  private cut(): boolean {
    const { px, py, width, height } = this;
    const [dx, dy] = [this.qx - px, this.qy - py];
    let from = 0;
    let to = 1;
    for (let side = 0; side < 4; ++side) {
      const way = side === 0 ? -dx : side === 1 ? dx : side === 2 ? -dy : dy;
      const room = kAround + (side === 0 ? px : side === 1 ? width - px : side === 2 ? py : height - py);
      if (way === 0 && room < 0) return false;
      if (way < 0) from = Math.max(from, room / way);
      else if (way > 0) to = Math.min(to, room / way);
    }
    if (from > to) return false;
    this.px = px + dx * from;
    this.py = py + dy * from;
    this.qx = px + dx * to;
    this.qy = py + dy * to;
    return true;
  }

  /** Whether the last projected point is on screen, or within `margin` px of it. */
  on_screen(margin = 0): boolean {
    return this.px > -margin && this.px < this.width + margin && this.py > -margin && this.py < this.height + margin;
  }

  /** At the last projected point. */
  km_per_px_at(): number {
    return this.depth / this.focal;
  }

  /** km in front of the eye; negative: behind it. */
  depth_of(x: number, y: number, z: number): number {
    this.turn(x, y, z);
    return this.ahead;
  }

  km_per_px(x: number, y: number, z: number): number {
    return Math.max(1e-3, this.depth_of(x, y, z)) / this.focal;
  }

  /** rad: the map's azimuth of the line of sight through a pixel, and how far it points above that to a place. */
  way(px: number, py: number, x: number, y: number, z: number): { heading: number; climb: number } {
    const { right: r, up: u, back: b, at } = this;
    const [sx, sy] = [(px - this.width / 2) / this.focal, (this.height / 2 - py) / this.focal];
    const [dx, dy, dz] = [0, 1, 2].map((i) => r[i]! * sx + u[i]! * sy - b[i]!) as [number, number, number];
    const above = (east: number, up: number, south: number): number => Math.atan2(up, Math.hypot(east, south));
    return { heading: Math.atan2(dx, -dz), climb: above(dx, dy, dz) - above(x - at[0]!, y - at[1]!, z - at[2]!) };
  }

  /** Where the line of sight through a pixel meets the plane at this height; false: nowhere, or further than so many km. */
  hit(px: number, py: number, height = 0, farthest = Infinity): boolean {
    const { right: r, up: u, back: b, at } = this;
    const sx = (px - this.width / 2) / this.focal;
    const sy = (this.height / 2 - py) / this.focal;
    const dy = u[1]! * sy - b[1]!;
    const reach = (height - at[1]!) / dy;
    if (!(reach > 0) || reach > farthest) return false;
    this.ground_x = at[0]! + (r[0]! * sx + u[0]! * sy - b[0]!) * reach;
    this.ground_z = at[2]! + (r[2]! * sx + u[2]! * sy - b[2]!) * reach;
    return true;
  }
}
