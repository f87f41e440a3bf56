// SPDX-License-Identifier: MIT
/** The store's camera and the user's hand, turned into what the rig should do. */
import { Box3, Vector3 } from 'three';
import type { Pose, View } from '../store.ts';
import type { Eye } from './eye.ts';
import type { Poses } from './motion.ts';
import { fit, height_for_both, kFlatFov, kFov, kPace, Rig } from './rig.ts';

/** rad from straight down, in 'whole' and when 'top' is left. */
const kTilt = 0.95;
/** km of the scene in the picture when one aircraft is followed, and at least when all are seen. */
const kChase = 0.15;
const kLeast = 1.5;
/** km: a fight no wider is seen without the ground below it; an opponent no further is kept in the picture of who is followed. */
const kClose = 8;
const kTogether = 100;
/** rad: a drag over the height of the picture. */
const kSwing = 3;

const still = (camera: View['camera']): boolean => camera === 'free' || camera === 'top';

export class SceneCamera {
  readonly rig: Rig;
  private camera: View['camera'] | null = null;
  private followed = -1;
  private nearer = 1;  // Of what the chasing camera would show.
  private ways: Vector3[] | null = null;  // All that was flown.
  private beside = 0;  // Where the chasing camera looks, from the heading.
  private pose: Pose | null = null;  // As the view has it.

  constructor(still: boolean) {
    this.rig = new Rig({ x: 0, y: 6, z: 0, height: 150, azimuth: 0, polar: kTilt, fov: kFov }, still);
  }

  /** A camera was chosen. */
  private change(camera: View['camera'], players: Poses, eye: Eye, also: Vector3[]): void {
    const { goal } = this.rig;
    const before = this.camera;
    this.camera = camera;
    this.rig.pace = kPace.change;
    goal.fov = camera === 'top' ? kFlatFov : kFov;
    if (camera !== 'follow') {
      this.rig.rebase(0, 0, 0);
      this.followed = -1;
    }
    if (camera === 'top') {
      goal.polar = 0;
      goal.azimuth = 0;
      if (before === 'follow') goal.height = Math.max(goal.height, 60);
      if (before === 'whole') this.fit(players, eye, false, also);
    } else if (camera === 'free') {
      if (before === 'top') goal.polar = kTilt;
    } else if (camera === 'whole') {
      goal.polar = kTilt;
      goal.azimuth = 0;
    } else {
      goal.polar = 1.25;
      goal.height = kChase;
      this.nearer = 1;
      this.beside = 0;
    }
  }

  /** In the end all that was flown. */
  private fit(players: Poses, eye: Eye, at_end: boolean, also: Vector3[]): void {
    const points = [...(at_end ? (this.ways ??= players.ways()) : players.spots()), ...also];
    const { x, z } = new Box3().setFromPoints(points).getSize(new Vector3());
    const close = Math.max(x, z) < kClose;
    fit(this.rig.goal, points, eye.width / Math.max(1, eye.height), kLeast, close ? 0.6 : 0.8, !close);
  }

  private follow(players: Poses, i: number, opponent: number, aspect: number): void {
    const [x, y, z] = [players.x[i]!, players.y[i]!, players.z[i]!];
    const { rig } = this;
    if (this.followed !== i) {
      rig.rebase(x, y, z);
      this.followed = i;
      rig.pace = kPace.change;
    } else {
      rig.carry(x, y, z);
    }
    const [dx, dy, dz] = opponent < 0 ? [0, 0, 0] : [players.x[opponent]! - x, players.y[opponent]! - y, players.z[opponent]! - z];
    const apart = Math.hypot(dx, dy, dz);
    const both = apart > 0 && apart < kTogether;
    [rig.goal.x, rig.goal.y, rig.goal.z] = both ? [dx / 2, dy / 2, dz / 2] : [0, 0, 0];
    const azimuth = (both ? Math.atan2(dx, -dz) : players.heading[i]!) + this.beside;
    // a turning aircraft swings the camera after it, not at once
    if (Math.abs(Math.sin((azimuth - rig.goal.azimuth) / 2)) > 1e-4 && rig.pace === kPace.hand) rig.pace = kPace.chase;
    rig.goal.azimuth = azimuth;
    rig.goal.height = Math.max(kChase, both ? Math.max(1.1 * apart, height_for_both(rig.goal, dx, dy, dz, aspect)) : 0) * this.nearer;
  }

  /** Sets the goal for this picture. `also`: what besides the players belongs into the whole. */
  aim(view: View, players: Poses, eye: Eye, opponent: number, also: Vector3[]): void {
    const at_end = view.time >= view.end - 0.05;
    const first = this.camera === null;
    if (this.camera !== view.camera) this.change(view.camera, players, eye, also);
    if (view.camera === 'follow' && view.selected < players.count) this.follow(players, view.selected, opponent, eye.width / Math.max(1, eye.height));
    if (view.camera === 'whole' || (first && view.camera !== 'follow')) this.fit(players, eye, at_end, also);
    this.placed(view);
    if (first) this.rig.arrive();
  }

  /** A link or another page says where the camera stands. */
  private placed(view: View): void {
    if (view.pose === this.pose) return;
    this.pose = view.pose;
    if (view.pose && still(view.camera)) this.rig.place(view.pose);
  }

  /** Where the camera has come to rest, if that is to be told; null: nothing new. */
  rested(view: View): Pose | null {
    if (!still(view.camera)) return null;
    const pose = this.rig.pose().map((value) => Number(value.toPrecision(6))) as unknown as Pose;
    if (this.pose?.every((value, i) => value === pose[i])) return null;
    return (this.pose = pose);
  }

  /** True: from 'whole' this made a free camera. */
  drag(dx: number, dy: number, view: View, eye: Eye): boolean {
    if (view.camera === 'top') {
      this.rig.pan(-dx / eye.height, dy / eye.height);
      return false;
    }
    const freed = this.free(view);
    const swing = (-dx * kSwing) / eye.height;
    if (view.camera === 'follow') this.beside += swing;
    this.rig.orbit(swing, (-dy * kSwing) / eye.height);
    return freed;
  }

  push(dx: number, dy: number, view: View, eye: Eye): boolean {
    if (view.camera === 'follow') return this.drag(dx, dy, view, eye);
    const freed = this.free(view);
    this.rig.pan(-dx / eye.height, dy / eye.height);
    return freed;
  }

  zoom(factor: number, px: number, py: number, view: View, eye: Eye): boolean {
    const { rig } = this;
    if (view.camera === 'follow') {
      this.nearer = Math.min(100, Math.max(0.1, this.nearer * factor));
      rig.pace = kPace.hand;
      return false;
    }
    const freed = this.free(view);
    const { y, height } = eye.stance;
    const farthest = height * (view.camera === 'top' ? 1000 : 4);
    if (eye.hit(px, py, y, farthest)) rig.zoom(factor, eye.ground_x, eye.ground_z);
    else rig.zoom(factor);
    return freed;
  }

  /** Whoever touches 'whole' wants to look around from there. */
  private free(view: View): boolean {
    if (view.camera !== 'whole') return false;
    this.camera = 'free';
    return true;
  }
}
