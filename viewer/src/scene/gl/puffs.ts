// SPDX-License-Identifier: MIT
/** Soft discs, all in one draw call. */
import {
  BufferAttribute, BufferGeometry, DynamicDrawUsage, InterleavedBuffer, InterleavedBufferAttribute, Points, ShaderMaterial,
} from 'three';
import type { Discs } from '../painter.ts';
import type { Screen } from './lines.ts';

const kVertex = /* glsl */ `
  attribute vec2 size;
  attribute vec4 tint;
  uniform vec2 pixels;
  uniform float ratio;
  varying vec4 shade;
  void main() {
    vec4 at = viewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * at;
    float km = projectionMatrix[1][1] * pixels.y * 0.5 / max(1e-3, -at.z);
    gl_PointSize = min(512.0, max(size.y * ratio, size.x * km) * 2.0);
    shade = tint;
  }`;

const kFragment = /* glsl */ `
  varying vec4 shade;
  void main() {
    float out_from_middle = length(gl_PointCoord * 2.0 - 1.0);
    if (out_from_middle > 1.0) discard;
    gl_FragColor = vec4(shade.rgb, shade.a * smoothstep(1.0, 0.35, out_from_middle));
  }`;

const kFloats = 5;
const kMost = 1024;

/** As many as fit; what is beyond is left out. */
export class Puffs implements Discs {
  readonly mesh: Points<BufferGeometry, ShaderMaterial>;
  private count = 0;
  private readonly floats: InterleavedBuffer;
  private readonly tints: BufferAttribute;

  constructor(screen: Screen, order: number) {
    const geometry = new BufferGeometry();
    this.floats = new InterleavedBuffer(new Float32Array(kMost * kFloats), kFloats).setUsage(DynamicDrawUsage);
    this.tints = new BufferAttribute(new Uint8Array(kMost * 4), 4, true).setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', new InterleavedBufferAttribute(this.floats, 3, 0));
    geometry.setAttribute('size', new InterleavedBufferAttribute(this.floats, 2, 3));
    geometry.setAttribute('tint', this.tints);
    const material = new ShaderMaterial({
      vertexShader: kVertex, fragmentShader: kFragment, uniforms: { pixels: screen.pixels, ratio: screen.ratio },
      transparent: true, depthWrite: false,
    });
    this.mesh = new Points(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  add(x: number, y: number, z: number, radius: number, least: number, tint: number, alpha: number): void {
    if (this.count === kMost) return;
    (this.floats.array as Float32Array).set([x, y, z, radius, least], this.count * kFloats);
    (this.tints.array as Uint8Array).set([tint >> 16, (tint >> 8) & 255, tint & 255, alpha * 255], this.count * 4);
    ++this.count;
  }

  end(): void {
    this.floats.needsUpdate = true;
    this.tints.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, this.count);
    this.mesh.visible = this.count > 0;
    this.count = 0;
  }
}
