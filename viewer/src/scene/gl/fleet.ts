// SPDX-License-Identifier: MIT
/** Everybody's model, one instanced mesh for each shape; never smaller on screen than can be read. */
import { Color, DoubleSide, DynamicDrawUsage, type Group, InstancedMesh, MeshLambertMaterial, type Side as Faces } from 'three';
import type { Missile, Player, Side } from '../run/run.ts';
import type { Eye } from './eye.ts';
import { kCrowd } from './frame.ts';
import type { Palette } from './palette.ts';
import type { Poses } from './poses.ts';
import { kShapes, shape_of, type ShapeName } from './shapes.ts';

/** Least length on screen, CSS px. */
const kLeast: Record<ShapeName, number> = { eagle: 30, fulcrum: 28, fighter: 27, truck: 14, missile: 13 };
const kCrowded = 0.72;
const kFaces: Faces = DoubleSide;

interface Squadron {
  mesh: InstancedMesh;
  name: ShapeName;
  /** km */
  length: number;
  members: number[];
}

/** Columns of the turn by roll, then pitch, then heading, times `size`; then the place. */
function write_matrix(out: Float32Array, at: number, poses: Poses, i: number, size: number): void {
  const sh = Math.sin(poses.heading[i]!);
  const ch = Math.cos(poses.heading[i]!);
  const sp = Math.sin(poses.pitch[i]!);
  const cp = Math.cos(poses.pitch[i]!);
  const sr = Math.sin(poses.roll[i]!);
  const cr = Math.cos(poses.roll[i]!);
  out[at] = (ch * cr + sh * sp * sr) * size;
  out[at + 1] = -cp * sr * size;
  out[at + 2] = (sh * cr - ch * sp * sr) * size;
  out[at + 3] = 0;
  out[at + 4] = (ch * sr - sh * sp * cr) * size;
  out[at + 5] = cp * cr * size;
  out[at + 6] = (sh * sr + ch * sp * cr) * size;
  out[at + 7] = 0;
  out[at + 8] = -sh * cp * size;
  out[at + 9] = -sp * size;
  out[at + 10] = ch * cp * size;
  out[at + 11] = 0;
  out[at + 12] = poses.x[i]!;
  out[at + 13] = poses.y[i]!;
  out[at + 14] = poses.z[i]!;
  out[at + 15] = 1;
}

export class Fleet {
  private readonly squadrons: Squadron[] = [];
  private readonly material = new MeshLambertMaterial({ side: kFaces });
  private readonly color = new Color();

  constructor(private readonly group: Group, private readonly sides: readonly Side[], shapes: readonly ShapeName[]) {
    for (const name of new Set(shapes)) {
      const { geometry, length } = kShapes[name]();
      const members = shapes.flatMap((shape, i) => (shape === name ? [i] : []));
      const mesh = new InstancedMesh(geometry, this.material, members.length);
      mesh.instanceMatrix.setUsage(DynamicDrawUsage);
      mesh.frustumCulled = false;
      this.squadrons.push({ mesh, name, length: length / 1000, members });
      group.add(mesh);
    }
  }

  static of_players(group: Group, players: readonly Player[]): Fleet {
    return new Fleet(group, players.map((p) => p.side), players.map((p) => shape_of(p.kind, p.model)));
  }
  static of_missiles(group: Group, missiles: readonly Missile[]): Fleet {
    return new Fleet(group, missiles.map((m) => m.side), missiles.map(() => 'missile'));
  }

  paint(palette: Palette): void {
    for (const { mesh, members } of this.squadrons) {
      members.forEach((i, slot) => mesh.setColorAt(slot, this.color.setHex(palette.side[this.sides[i]!])));
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  update(poses: Poses, eye: Eye): void {
    for (const { mesh, members, name, length } of this.squadrons) {
      const matrices = mesh.instanceMatrix.array as Float32Array;
      const least = kLeast[name] * eye.ui * (poses.count > kCrowd ? kCrowded : 1);
      let used = 0;
      for (const [slot, i] of members.entries()) {
        // colours stay with their slots, so those who are not there keep theirs and have no size
        const shown = poses.shown[i] === 1;
        const size = shown ? 0.001 * Math.max(1, (least * eye.km_per_px(poses.x[i]!, poses.y[i]!, poses.z[i]!)) / length) : 0;
        write_matrix(matrices, slot * 16, poses, i, size);
        if (shown) used = slot + 1;
      }
      mesh.count = used;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const { mesh } of this.squadrons) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.dispose();
    }
    this.material.dispose();
  }
}
