// SPDX-License-Identifier: MIT
/** Everybody's model, one instanced mesh for each shape; never smaller on screen than can be read. */
import { Color, DoubleSide, DynamicDrawUsage, InstancedMesh, MeshLambertMaterial, type Group } from 'three';
import type { Missile, Player } from '../../run/run.ts';
import type { Eye } from '../eye.ts';
import type { Poses } from '../motion.ts';
import type { Palette } from '../palette.ts';
import { kShapes, shape_of, matrix_of, size_of, type ShapeName } from '../shapes.ts';

interface Squadron {
  mesh: InstancedMesh;
  name: ShapeName;
  length: number;  // km
  members: number[];
}

export class Fleet {
  private squadrons: Squadron[] = [];
  private built = 0;  // For so many,
  private palette: Palette | null = null;  // and in these colours.
  private readonly material = new MeshLambertMaterial({ side: DoubleSide });
  private readonly color = new Color();

  /** There may be more of them later. */
  constructor(private readonly group: Group, private readonly all: readonly (Player | Missile)[]) {}

  private build(palette: Palette): void {
    for (const { mesh } of this.squadrons) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.dispose();
    }
    this.squadrons = [];
    const shapes = this.all.map(shape_of);
    this.built = shapes.length;
    this.palette = palette;
    for (const name of new Set(shapes)) {
      const { geometry, length } = kShapes[name]();
      const members = shapes.flatMap((shape, i) => (shape === name ? [i] : []));
      const mesh = new InstancedMesh(geometry, this.material, members.length);
      mesh.instanceMatrix.setUsage(DynamicDrawUsage);
      mesh.frustumCulled = false;
      members.forEach((i, slot) => mesh.setColorAt(slot, this.color.setHex(palette.side[this.all[i]!.side])));
      this.squadrons.push({ mesh, name, length: length / 1000, members });
      this.group.add(mesh);
    }
  }

  update(poses: Poses, eye: Eye, palette: Palette): void {
    if (this.all.length > this.built || palette !== this.palette) this.build(palette);
    for (const { mesh, members, name, length } of this.squadrons) {
      const matrices = mesh.instanceMatrix.array as Float32Array;
      let used = 0;
      for (const [slot, i] of members.entries()) {
        // colours stay with their slots, so those who are not there keep theirs and have no size
        const shown = poses.shown[i] === 1;
        const size = shown ? size_of(name, length, poses, i, eye) : 0;
        matrix_of(poses, i, size).toArray(matrices, slot * 16);
        if (shown) used = slot + 1;
      }
      mesh.count = used;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
}
