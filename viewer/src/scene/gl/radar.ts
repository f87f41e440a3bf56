// SPDX-License-Identifier: MIT
/** What the selected player's radar sweeps: a sector of a shell, brightest at the antenna. */
import { BackSide, BufferAttribute, BufferGeometry, Mesh, ShaderMaterial, Vector4 } from 'three';
import type { Frame } from './frame.ts';
import type { Lines } from './lines.ts';
import { shares } from './palette.ts';

const kColumns = 36;
const kRows = 4;

/** Corners over the front, row by row: unit directions in the scene. */
type Fan = Float32Array;

function aim(out: Fan, at: number, azimuth: number, elevation: number): void {
  out[at] = Math.sin(azimuth) * Math.cos(elevation);
  out[at + 1] = Math.sin(elevation);
  out[at + 2] = -Math.cos(azimuth) * Math.cos(elevation);
}

export class RadarVolume {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly fan: Fan = new Float32Array((kColumns + 1) * (kRows + 1) * 3);
  private readonly corners: BufferAttribute;

  constructor(order: number) {
    const geometry = new BufferGeometry();
    // the antenna, then the front; only the far side is drawn, so that each line of sight through the volume meets it once
    this.corners = new BufferAttribute(new Float32Array(3 + this.fan.length), 3);
    geometry.setAttribute('position', this.corners);
    const at = (column: number, row: number): number => 1 + row * (kColumns + 1) + column;
    const index: number[] = [];
    for (let c = 0; c < kColumns; ++c) index.push(0, at(c, 0), at(c + 1, 0), 0, at(c + 1, kRows), at(c, kRows));
    for (let r = 0; r < kRows; ++r) index.push(0, at(0, r + 1), at(0, r), 0, at(kColumns, r), at(kColumns, r + 1));
    for (let c = 0; c < kColumns; ++c)
      for (let r = 0; r < kRows; ++r)
        index.push(at(c, r), at(c, r + 1), at(c + 1, r + 1), at(c, r), at(c + 1, r + 1), at(c + 1, r));
    geometry.setIndex(index);
    const material = new ShaderMaterial({
      vertexShader: `attribute float nearness; varying float shade; void main() { shade = nearness;
        gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0); }`,
      fragmentShader: `uniform vec4 tint; varying float shade;
        void main() { gl_FragColor = vec4(tint.rgb, tint.a * (0.3 + 0.7 * shade)); }`,
      uniforms: { tint: { value: new Vector4() } }, transparent: true, depthWrite: false, side: BackSide,
    });
    const nearness = new Float32Array(1 + this.fan.length / 3);
    nearness[0] = 1;
    geometry.setAttribute('nearness', new BufferAttribute(nearness, 1));
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  update({ view, players, palette, lines, sight }: Frame): void {
    const player = sight?.player;
    const scan = sight?.now.scan;
    const radar = player?.radar;
    this.mesh.visible = false;
    if (!view.layers.radar || !player || !radar || !scan || scan.mode === 'off') return;
    const i = player.index;
    const track = scan.mode === 'track';
    const heading = players.heading[i]! + scan.azimuth;
    for (let row = 0; row <= kRows; ++row)
      for (let column = 0; column <= kColumns; ++column)
        aim(this.fan, (row * (kColumns + 1) + column) * 3, heading + radar.azimuth * ((2 * column) / kColumns - 1),
          Math.min(1.55, Math.max(-1.55, scan.elevation + radar.elevation * ((2 * row) / kRows - 1))));
    const out = this.corners.array as Float32Array;
    const range = radar.range / 1000;
    const [x, y, z] = [players.x[i]!, players.y[i]!, players.z[i]!];
    out.set([x, y, z]);
    for (let k = 0; k < this.fan.length; k += 3) {
      out[k + 3] = x + this.fan[k]! * range;
      out[k + 4] = y + this.fan[k + 1]! * range;
      out[k + 5] = z + this.fan[k + 2]! * range;
    }
    this.corners.needsUpdate = true;
    const tint = this.mesh.material.uniforms.tint!.value as Vector4;
    tint.set(...shares(palette.radar), palette.veil * (track ? 1.9 : 1));
    this.mesh.visible = true;
    lines.pen(palette.radar, track ? 1.6 : 1);
    this.outline(lines, track ? 0.8 : 0.45);
  }

  /** The four edges from the antenna, and the rim. */
  private outline(lines: Lines, alpha: number): void {
    const p = this.corners.array as Float32Array;
    const at = (column: number, row: number): number => (1 + row * (kColumns + 1) + column) * 3;
    const join = (a: number, b: number, from: number, to: number): void =>
      lines.add(p[a]!, p[a + 1]!, p[a + 2]!, p[b]!, p[b + 1]!, p[b + 2]!, from, to);
    for (const c of [0, kColumns]) {
      join(0, at(c, 0), alpha, alpha * 0.5);
      join(0, at(c, kRows), alpha, alpha * 0.5);
      for (let r = 0; r < kRows; ++r) join(at(c, r), at(c, r + 1), alpha * 0.5, alpha * 0.5);
    }
    for (const r of [0, kRows]) for (let c = 0; c < kColumns; ++c) join(at(c, r), at(c + 1, r), alpha * 0.5, alpha * 0.5);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
