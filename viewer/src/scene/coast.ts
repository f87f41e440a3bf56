// SPDX-License-Identifier: MIT
/** Land, coastlines and graticule around the origin, in km on the map. */
import { ShapeUtils, Vector2 } from 'three';
import { feature } from 'topojson-client';
import type { GeometryCollection, Topology } from 'topojson-specification';
import land_110m from 'world-atlas/land-110m.json';
import { kRadian, type Origin, sphere_at, to_map } from './geo.ts';
import { turn } from './motion.ts';
import type { Pens } from './painter.ts';
import type { Palette } from './palette.ts';

/** Nothing further from the origin is drawn (km). */
export const kReach = 1500;
/** Points beyond this are moved onto this circle (km), so that rings around the antipode stay away from us. */
const kFar = 6000;
const kCorners = 64;
const kGraticule = 5;

export interface Coast {
  land: Float32Array;  // Triangles, x y z of each corner in the scene.
  shore: Float32Array;  // Segments, x y of both ends.
  graticule: Float32Array;  // Segments of the lines of equal latitude and longitude each five degrees.
}

function project(origin: Origin, longitude: number, latitude: number): Vector2 {
  const [east, north] = to_map(origin, latitude, longitude);
  return new Vector2(east / 1000, north / 1000);
}

/** The ring with far points pulled in, and with steps along the circle where it runs on it. */
function pull_in(ring: Vector2[]): Vector2[] {
  return ring.flatMap((point, i) => {
    if (point.length() <= kFar) return [point];
    const next = ring[(i + 1) % ring.length]!;
    const from = Math.atan2(point.y, point.x);
    const sweep = turn(from, Math.atan2(next.y, next.x));
    const steps = next.length() > kFar ? Math.max(1, Math.ceil(Math.abs(sweep) / 0.4)) : 1;
    const angles = Array.from({ length: steps }, (_, k) => from + (sweep * k) / steps);
    return angles.map((angle) => new Vector2(kFar * Math.cos(angle), kFar * Math.sin(angle)));
  });
}

/** What of the ring lies within reach: Sutherland and Hodgman's, edge by edge of a polygon for the circle. */
function clip(ring: Vector2[]): Vector2[] {
  let inside = ring;
  const edge = kReach * Math.cos(Math.PI / kCorners);
  for (let k = 0; k < kCorners && inside.length; ++k) {
    const angle = (2 * Math.PI * k) / kCorners;
    const out = new Vector2(Math.cos(angle), Math.sin(angle));
    const next: Vector2[] = [];
    inside.forEach((a, i) => {
      const b = inside[(i + 1) % inside.length]!;
      const da = a.dot(out) - edge;
      const db = b.dot(out) - edge;
      if (da <= 0) next.push(a);
      if (da <= 0 !== db <= 0) next.push(a.clone().lerp(b, da / (da - db)));
    });
    inside = next;
  }
  return inside;
}

/** Rings of the globe are closed: their first point is also their last. */
function fill(rings: number[][][], origin: Origin, out: number[]): void {
  const clipped: Vector2[][] = [];
  for (const [k, ring] of rings.entries()) {
    const flat = pull_in(ring.slice(0, -1).map(([lon, lat]) => project(origin, lon!, lat!)));
    // outer rings of the atlas run clockwise; one that does not after projection has the antipode
    // inside, and with it lies far away
    if (k === 0 && ShapeUtils.area(flat) > 0) return;
    const cut = clip(flat);
    if (cut.length >= 3) clipped.push(cut);
    else if (k === 0) return;
  }
  const [outer, ...holes] = clipped;
  if (!outer) return;
  const corners = clipped.flat();
  for (const triangle of ShapeUtils.triangulateShape(outer, holes))
    for (const corner of triangle) out.push(corners[corner]!.x, 0, -corners[corner]!.y);
}

/** The part of a segment within reach, appended. */
function add_segment({ x: ax, y: ay }: Vector2, { x: bx, y: by }: Vector2, out: number[]): void {
  const dx = bx - ax;
  const dy = by - ay;
  const a = dx * dx + dy * dy;
  const b = ax * dx + ay * dy;
  const root = b * b - a * (ax * ax + ay * ay - kReach * kReach);
  if (a === 0 || root <= 0) return;
  const from = Math.max(0, (-b - Math.sqrt(root)) / a);
  const to = Math.min(1, (-b + Math.sqrt(root)) / a);
  if (from < to) out.push(ax + dx * from, ay + dy * from, ax + dx * to, ay + dy * to);
}

/** Where the atlas was cut open there is no shore. */
function is_seam([lon_a, lat_a]: number[], [lon_b, lat_b]: number[]): boolean {
  return (Math.abs(lon_a!) > 179.9 && Math.abs(lon_b!) > 179.9) || (lat_a! < -89.9 && lat_b! < -89.9);
}

function add_shore(ring: number[][], origin: Origin, out: number[]): void {
  for (let i = 0; i + 1 < ring.length; ++i) {
    const a = project(origin, ring[i]![0]!, ring[i]![1]!);
    const b = project(origin, ring[i + 1]![0]!, ring[i + 1]![1]!);
    if (Math.min(a.length(), b.length()) < 3 * kReach && !is_seam(ring[i]!, ring[i + 1]!)) add_segment(a, b, out);
  }
}

function graticule_of(origin: Origin): number[] {
  const out: number[] = [];
  const far = kReach / ((sphere_at(origin) / 1000) * kRadian) + kGraticule;
  const south = Math.max(-90, Math.floor(origin.latitude - far));
  const north = Math.min(90, Math.ceil(origin.latitude + far));
  for (let lon = -180; lon < 180; lon += kGraticule)
    for (let lat = south; lat < north; ++lat)
      if (lat >= -85 && lat < 85) add_segment(project(origin, lon, lat), project(origin, lon, lat + 1), out);
  for (let lat = Math.ceil(south / kGraticule) * kGraticule; lat <= north; lat += kGraticule)
    for (let lon = -180; lon < 180; ++lon) add_segment(project(origin, lon, lat), project(origin, lon + 1, lat), out);
  return out;
}

let last: { origin: Origin; coast: Coast } | null = null;

/** The runs of a page have one origin, and it is asked for again whenever a picture is made. */
export function coast_of(origin: Origin): Coast {
  if (last?.origin.latitude !== origin.latitude || last.origin.longitude !== origin.longitude) last = { origin, coast: made(origin) };
  return last.coast;
}

function made(origin: Origin): Coast {
  const topology = land_110m as unknown as Topology<{ land: GeometryCollection }>;
  const land: number[] = [];
  const shore: number[] = [];
  for (const { geometry } of feature(topology, topology.objects.land).features) {
    if (geometry.type !== 'MultiPolygon') continue;
    for (const polygon of geometry.coordinates) {
      fill(polygon, origin, land);
      for (const ring of polygon) add_shore(ring, origin, shore);
    }
  }
  return { land: Float32Array.from(land), shore: Float32Array.from(shore), graticule: Float32Array.from(graticule_of(origin)) };
}

/** Graticule and shores, on the ground. */
export function draw_shores(lines: Pens, { graticule, shore }: Coast, palette: Palette): void {
  for (const [segments, width, alpha] of [[graticule, 1, 0.22], [shore, 1.4, 0.9]] as const) {
    lines.pen(palette.shore, width);
    for (let i = 0; i < segments.length; i += 4)
      lines.add(segments[i]!, 0, -segments[i + 1]!, segments[i + 2]!, 0, -segments[i + 3]!, alpha);
  }
}
