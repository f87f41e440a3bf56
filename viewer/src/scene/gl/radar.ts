// SPDX-License-Identifier: MIT
/** The radar's volume as triangles. */
import { BackSide, BufferAttribute, BufferGeometry, Mesh, MeshBasicMaterial } from 'three';
import type { Palette } from '../palette.ts';
import { corner_of as at, kColumns, kRows, kTrackVeil, type Volume } from '../radar.ts';

export class RadarVolume {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly corners: BufferAttribute;

  constructor(order: number) {
    const count = at(kColumns, kRows) + 1;
    const geometry = new BufferGeometry();
    // only the far side is drawn, so that each line of sight through the volume meets it once
    this.corners = new BufferAttribute(new Float32Array(3 * count), 3);
    geometry.setAttribute('position', this.corners);
    const index: number[] = [];
    for (let c = 0; c < kColumns; ++c) index.push(0, at(c, 0), at(c + 1, 0), 0, at(c + 1, kRows), at(c, kRows));
    for (let r = 0; r < kRows; ++r) index.push(0, at(0, r + 1), at(0, r), 0, at(kColumns, r), at(kColumns, r + 1));
    for (let c = 0; c < kColumns; ++c)
      for (let r = 0; r < kRows; ++r)
        index.push(at(c, r), at(c, r + 1), at(c + 1, r + 1), at(c, r), at(c + 1, r + 1), at(c + 1, r));
    geometry.setIndex(index);
    // strongest at the antenna
    const colors = new Float32Array(4 * count).map((_, i) => (i < 4 || i % 4 < 3 ? 1 : 0.3));
    geometry.setAttribute('color', new BufferAttribute(colors, 4));
    const material = new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: BackSide });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  update(volume: Volume | null, palette: Palette): void {
    this.mesh.visible = volume !== null;
    if (!volume) return;
    (this.corners.array as Float32Array).set(volume.corners);
    this.corners.needsUpdate = true;
    this.mesh.material.color.setHex(palette.radar);
    this.mesh.material.opacity = palette.veil * (volume.track ? kTrackVeil : 1);
  }
}
