// SPDX-License-Identifier: MIT
/**
 * Many lines in one draw call: each segment a quad that the vertex shader spreads to its width on screen. Not instanced:
 * renderers in software take each instance for a draw call of its own. And soft discs, all in another one.
 */
import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, InterleavedBuffer, InterleavedBufferAttribute, Mesh, Points,
  ShaderMaterial, type Vector2, Vector3,
} from 'three';
import type { Discs, Pens } from '../painter.ts';

const kVertex = /* glsl */ `
  attribute vec3 from;
  attribute vec3 to;
  attribute vec4 from_tint;
  attribute vec4 to_tint;
  attribute vec2 pen;
  uniform vec2 pixels;
  uniform float ratio;
  uniform vec3 haze;
  varying vec4 tint;
  varying vec2 across;
  varying vec2 dash;

  // moves p along to q until it is no further out than four pictures: what lies far outside spoils the figures of what is seen
  vec3 nearer(vec3 p, vec3 q) {
    vec3 way = q - p;
    if (abs(p.x) > 4.0) p += way * clamp((abs(p.x) - 4.0) / max(1e-6, -way.x * sign(p.x)), 0.0, 1.0);
    way = q - p;
    if (abs(p.y) > 4.0) p += way * clamp((abs(p.y) - 4.0) / max(1e-6, -way.y * sign(p.y)), 0.0, 1.0);
    return p;
  }

  void main() {
    // the four corners of a segment: at which end, and on which side
    float end = float(gl_VertexID & 1);
    float side = float(gl_VertexID & 2) - 1.0;
    vec4 a = viewMatrix * vec4(from, 1.0);
    vec4 b = viewMatrix * vec4(to, 1.0);
    // what reaches behind the eye is cut where it passes it; all varyings then run straight on screen (w = 1)
    float near = projectionMatrix[3][2] / (1.0 - projectionMatrix[2][2]) * 1.01;
    if (a.z > near && b.z > near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
    if (a.z > near) a = mix(a, b, (near - a.z) / (b.z - a.z));
    if (b.z > near) b = mix(b, a, (near - b.z) / (a.z - b.z));
    vec4 ca = projectionMatrix * a;
    vec4 cb = projectionMatrix * b;
    vec3 na = nearer(ca.xyz / ca.w, cb.xyz / cb.w);
    vec3 nb = nearer(cb.xyz / cb.w, na);
    vec2 along = (nb.xy - na.xy) * pixels * 0.5;
    float reach = length(along);
    vec2 way = reach > 1e-4 ? along / reach : vec2(1.0, 0.0);
    float half_width = pen.x * ratio * 0.5;
    float spread = half_width + 1.0;
    vec2 shift = vec2(-way.y, way.x) * side * spread;
    // no gaps where legs of an opaque line meet
    if (min(from_tint.a, to_tint.a) > 0.99) shift += way * (end - 0.5);
    vec3 at = mix(na, nb, end);
    gl_Position = vec4(at.xy + shift * 2.0 / pixels, at.z, 1.0);
    tint = mix(from_tint, to_tint, end);
    if (haze.y > 0.0) tint.a *= 1.0 - smoothstep(0.35, 0.95, distance(mix(from, to, end).xz, haze.xz) / haze.y);
    across = vec2(side * spread, half_width);
    dash = vec2(end * reach, pen.y * ratio);
  }`;

const kFragment = /* glsl */ `
  varying vec4 tint;
  varying vec2 across;
  varying vec2 dash;
  void main() {
    if (dash.y > 0.0 && fract(dash.x / dash.y) > 0.55) discard;
    // lines thinner than a pixel are paler instead
    float cover = clamp(across.y + 0.5 - abs(across.x), 0.0, 1.0) * min(1.0, across.y * 2.0);
    gl_FragColor = vec4(tint.rgb, tint.a * cover);
  }`;

/** Shared by all lines and puffs of a scene: size of the picture in device pixels, and those per CSS pixel. */
export interface Screen {
  pixels: { value: Vector2 };
  ratio: { value: number };
}

const kFloats = 8;
const kBytes = 8;
const kCorners = 4;

export class Lines implements Pens {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly haze = new Vector3();  // Around (x, z) all fades out towards the distance y; 0: nothing does.
  private count = 0;
  private floats: InterleavedBuffer;
  private bytes: InterleavedBuffer;
  private tint = 0;
  private width = 1;
  private dash = 0;

  constructor(screen: Screen, order: number, private capacity = 1024) {
    const material = new ShaderMaterial({
      vertexShader: kVertex, fragmentShader: kFragment,
      uniforms: { pixels: screen.pixels, ratio: screen.ratio, haze: { value: this.haze } },
      transparent: true, depthWrite: false, side: DoubleSide,
    });
    this.floats = this.buffer(Float32Array, kFloats);
    this.bytes = this.buffer(Uint8Array, kBytes);
    this.mesh = new Mesh(this.geometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  private buffer(type: typeof Float32Array | typeof Uint8Array, stride: number): InterleavedBuffer {
    return new InterleavedBuffer(new type(this.capacity * kCorners * stride), stride).setUsage(DynamicDrawUsage);
  }

  private geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    const index = new Uint32Array(this.capacity * 6);
    for (let i = 0; i < this.capacity; ++i) [0, 1, 3, 0, 3, 2].forEach((corner, k) => (index[6 * i + k] = kCorners * i + corner));
    geometry.setIndex(new BufferAttribute(index, 1));
    geometry.setAttribute('from', new InterleavedBufferAttribute(this.floats, 3, 0));
    geometry.setAttribute('to', new InterleavedBufferAttribute(this.floats, 3, 3));
    geometry.setAttribute('pen', new InterleavedBufferAttribute(this.floats, 2, 6));
    geometry.setAttribute('from_tint', new InterleavedBufferAttribute(this.bytes, 4, 0, true));
    geometry.setAttribute('to_tint', new InterleavedBufferAttribute(this.bytes, 4, 4, true));
    return geometry;
  }

  private grow(): void {
    const { floats, bytes } = this;
    this.capacity *= 2;
    this.floats = this.buffer(Float32Array, kFloats);
    this.bytes = this.buffer(Uint8Array, kBytes);
    this.floats.array.set(floats.array);
    this.bytes.array.set(bytes.array);
    this.mesh.geometry.dispose();
    this.mesh.geometry = this.geometry();
  }

  pen(tint: number, width: number, dash = 0): void {
    this.tint = tint;
    this.width = width;
    this.dash = dash;
  }

  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, alpha: number, to_alpha = alpha): void {
    if (this.count === this.capacity) this.grow();
    const f = this.floats.array as Float32Array;
    const b = this.bytes.array as Uint8Array;
    const { tint } = this;
    const first = this.count * kCorners;
    let i = first * kFloats;
    f[i] = ax;
    f[i + 1] = ay;
    f[i + 2] = az;
    f[i + 3] = bx;
    f[i + 4] = by;
    f[i + 5] = bz;
    f[i + 6] = this.width;
    f[i + 7] = this.dash;
    f.copyWithin(i + kFloats, i, i + kFloats);
    f.copyWithin(i + 2 * kFloats, i, i + 2 * kFloats);
    i = first * kBytes;
    b[i] = b[i + 4] = tint >> 16;
    b[i + 1] = b[i + 5] = (tint >> 8) & 255;
    b[i + 2] = b[i + 6] = tint & 255;
    b[i + 3] = alpha * 255;
    b[i + 7] = to_alpha * 255;
    b.copyWithin(i + kBytes, i, i + kBytes);
    b.copyWithin(i + 2 * kBytes, i, i + 2 * kBytes);
    ++this.count;
  }

  /** What was added is drawn with the next picture, and what is added from now on with the one after. */
  end(): void {
    for (const buffer of [this.floats, this.bytes]) {
      buffer.clearUpdateRanges();
      buffer.addUpdateRange(0, this.count * kCorners * buffer.stride);
      buffer.needsUpdate = true;
    }
    this.mesh.geometry.setDrawRange(0, this.count * 6);
    this.mesh.visible = this.count > 0;
    this.count = 0;
  }
}

const kDiscVertex = /* glsl */ `
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

const kDiscFragment = /* glsl */ `
  varying vec4 shade;
  void main() {
    float out_from_middle = length(gl_PointCoord * 2.0 - 1.0);
    if (out_from_middle > 1.0) discard;
    gl_FragColor = vec4(shade.rgb, shade.a * smoothstep(1.0, 0.35, out_from_middle));
  }`;

const kDiscFloats = 5;
const kMost = 1024;

/** As many as fit; what is beyond is left out. */
export class Puffs implements Discs {
  readonly mesh: Points<BufferGeometry, ShaderMaterial>;
  private count = 0;
  private readonly floats: InterleavedBuffer;
  private readonly tints: BufferAttribute;

  constructor(screen: Screen, order: number) {
    const geometry = new BufferGeometry();
    this.floats = new InterleavedBuffer(new Float32Array(kMost * kDiscFloats), kDiscFloats).setUsage(DynamicDrawUsage);
    this.tints = new BufferAttribute(new Uint8Array(kMost * 4), 4, true).setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', new InterleavedBufferAttribute(this.floats, 3, 0));
    geometry.setAttribute('size', new InterleavedBufferAttribute(this.floats, 2, 3));
    geometry.setAttribute('tint', this.tints);
    const material = new ShaderMaterial({
      vertexShader: kDiscVertex, fragmentShader: kDiscFragment, uniforms: { pixels: screen.pixels, ratio: screen.ratio },
      transparent: true, depthWrite: false,
    });
    this.mesh = new Points(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }

  add(x: number, y: number, z: number, radius: number, least: number, tint: number, alpha: number): void {
    if (this.count === kMost) return;
    (this.floats.array as Float32Array).set([x, y, z, radius, least], this.count * kDiscFloats);
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
