// SPDX-License-Identifier: MIT
/** The camera as the overlay and the screen-sized things need it: from the scene (km) to CSS px and back. */
import { PerspectiveCamera, Vector3 } from 'three';
import { kFov, type Stance } from './rig.ts';

/** km: nothing nearer is seen. */
const kNear = 0.002;
/** px around the picture where lines still go on. */
const kAround = 40;

const [kTurned, kOther] = [new Vector3(), new Vector3()];

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
  private focal = 1;  // px per unit of depth ratio.

  resize(width: number, height: number, ui = 1): void {
    this.width = width;
    this.height = height;
    this.ui = ui;
    this.camera.aspect = width / Math.max(1, height);
  }

  /** Stands as the rig says. */
  look(stance: Stance): void {
    this.stance = stance;
    const { camera } = this;
    const tan = Math.tan(stance.fov / 2);
    const distance = stance.height / (2 * tan);
    this.focal = this.height / (2 * tan);
    camera.rotation.set(stance.polar - Math.PI / 2, -stance.azimuth, 0, 'YXZ');
    camera.position.set(0, 0, distance).applyEuler(camera.rotation).add(stance);
    camera.updateMatrixWorld();
    camera.fov = (stance.fov * 180) / Math.PI;
    camera.near = Math.max(kNear, distance * 0.01);
    camera.far = distance + 4000;
    camera.updateProjectionMatrix();
  }

  /** km to the right of the line of sight, above it, and behind the eye. The next call changes it, unless it has another `out`. */
  private turned(x: number, y: number, z: number, out = kTurned): Vector3 {
    return out.set(x, y, z).applyMatrix4(this.camera.matrixWorldInverse);
  }

  /** False: behind the eye. */
  project(x: number, y: number, z: number): boolean {
    const at = this.turned(x, y, z);
    this.depth = -at.z;
    if (this.depth < 1e-3) return false;
    const scale = this.focal / this.depth;
    this.px = this.width / 2 + at.x * scale;
    this.py = this.height / 2 - at.y * scale;
    return true;
  }

  /** What is seen of a segment, from (px, py) to (qx, qy), and some px around the picture; false: nothing. */
  segment(ax: number, ay: number, az: number, bx: number, by: number, bz: number): boolean {
    const a = this.turned(ax, ay, az);
    const b = this.turned(bx, by, bz, kOther);
    if (a.z > -kNear && b.z > -kNear) return false;
    if (a.z > -kNear) a.lerp(b, (a.z + kNear) / (a.z - b.z));
    else if (b.z > -kNear) b.lerp(a, (b.z + kNear) / (b.z - a.z));
    this.px = this.width / 2 - (a.x * this.focal) / a.z;
    this.py = this.height / 2 + (a.y * this.focal) / a.z;
    this.qx = this.width / 2 - (b.x * this.focal) / b.z;
    this.qy = this.height / 2 + (b.y * this.focal) / b.z;
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
    return -this.turned(x, y, z).z;
  }

  km_per_px(x: number, y: number, z: number): number {
    return Math.max(1e-3, this.depth_of(x, y, z)) / this.focal;
  }

  /** Along the line of sight through a pixel, in the scene. */
  private ray(px: number, py: number): Vector3 {
    return kTurned.set(px - this.width / 2, this.height / 2 - py, -this.focal).applyQuaternion(this.camera.quaternion);
  }

  /** rad: the map's azimuth of the line of sight through a pixel, and how far it points above that to a place. */
  way(px: number, py: number, x: number, y: number, z: number): { heading: number; climb: number } {
    const ray = this.ray(px, py);
    const at = this.camera.position;
    const above = (east: number, up: number, south: number): number => Math.atan2(up, Math.hypot(east, south));
    return { heading: Math.atan2(ray.x, -ray.z), climb: above(ray.x, ray.y, ray.z) - above(x - at.x, y - at.y, z - at.z) };
  }

  /** Where the line of sight through a pixel meets the plane at this height; false: nowhere, or further than so many km. */
  hit(px: number, py: number, height = 0, farthest = Infinity): boolean {
    const ray = this.ray(px, py);
    const at = this.camera.position;
    const reach = (height - at.y) / ray.y;
    if (!(reach > 0) || reach * this.focal > farthest) return false;
    this.ground_x = at.x + ray.x * reach;
    this.ground_z = at.z + ray.z * reach;
    return true;
  }
}
