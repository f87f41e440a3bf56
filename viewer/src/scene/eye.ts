// SPDX-License-Identifier: MIT
/** The camera as the overlay and the screen-sized things need it: from the scene (km) to CSS px and back. */
import { PerspectiveCamera } from 'three';
import type { Stance } from './rig.ts';

export class Eye {
  readonly camera = new PerspectiveCamera();
  /** CSS px */
  width = 1;
  height = 1;
  /** How much larger than on a small screen writing and marks are. */
  ui = 1;
  /** Of the last project(): CSS px, and how far in front of the eye (km). */
  px = 0;
  py = 0;
  depth = 0;
  /** The last hit of the ground. */
  ground_x = 0;
  ground_z = 0;
  stance: Stance | null = null;
  private readonly right = new Float64Array(3);
  private readonly up = new Float64Array(3);
  private readonly back = new Float64Array(3);
  private readonly at = new Float64Array(3);
  /** px per unit of depth ratio. */
  private focal = 1;

  constructor() {
    this.camera.matrixAutoUpdate = false;
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.ui = Math.min(2, Math.max(1, Math.min(width / 1500, height / 900)));
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
    camera.near = Math.max(0.002, distance * 0.01);
    camera.far = distance + 4000;
    camera.updateProjectionMatrix();
  }

  /** False: behind the eye. */
  project(x: number, y: number, z: number): boolean {
    const { right: r, up: u, back: b, at } = this;
    const dx = x - at[0]!;
    const dy = y - at[1]!;
    const dz = z - at[2]!;
    this.depth = -(dx * b[0]! + dy * b[1]! + dz * b[2]!);
    if (this.depth < 1e-3) return false;
    const scale = this.focal / this.depth;
    this.px = this.width / 2 + (dx * r[0]! + dz * r[2]!) * scale;
    this.py = this.height / 2 - (dx * u[0]! + dy * u[1]! + dz * u[2]!) * scale;
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

  km_per_px(x: number, y: number, z: number): number {
    const { back: b, at } = this;
    const depth = (at[0]! - x) * b[0]! + (at[1]! - y) * b[1]! + (at[2]! - z) * b[2]!;
    return Math.max(1e-3, depth) / this.focal;
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
