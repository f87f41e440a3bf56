// SPDX-License-Identifier: MIT
/**
 * Between the map (azimuthal equidistant around the run's origin) and the globe: Snyder, Map Projections,
 * USGS 1395, 1987, p. 195, on the sphere that fits the ellipsoid at the origin. Coastlines and bearings
 * in the picture need no more: over 1000 km the sphere is off by some 0.3 %.
 */
import type { Place, Run } from '../run/run.ts';
import { turn, wrapped } from './motion.ts';

export type Origin = Run['origin'];

const kMajor = 6378137;
const kEccentricity2 = 0.00669437999014;
export const kRadian = Math.PI / 180;

/** m: of the sphere that has the ellipsoid's mean curvature at the origin. */
export function sphere_at(origin: Origin): number {
  const s = Math.sin(origin.latitude * kRadian);
  return (kMajor * Math.sqrt(1 - kEccentricity2)) / (1 - kEccentricity2 * s * s);
}

/** On the unit sphere a point of the latitude `to`, `apart` further east, from one of the latitude `from`: east, north and up there. */
function seen_from(from: number, to: number, apart: number): [x: number, y: number, z: number] {
  const [sf, cf, st, ct, ca] = [Math.sin(from), Math.cos(from), Math.sin(to), Math.cos(to), Math.cos(apart)];
  return [ct * Math.sin(apart), cf * st - sf * ct * ca, sf * st + cf * ct * ca];
}

/** m east and north on the map of a point on the globe (deg). */
export function to_map(origin: Origin, latitude: number, longitude: number): [east: number, north: number] {
  const [x, y, z] = seen_from(origin.latitude * kRadian, latitude * kRadian, (longitude - origin.longitude) * kRadian);
  const s = Math.hypot(x, y);
  const angle = Math.atan2(s, z);
  const scale = s > 1e-12 ? (angle / s) * sphere_at(origin) : sphere_at(origin);
  return [x * scale, y * scale];
}

/** rad north and rad east of a place on the map. */
function to_globe(origin: Origin, east: number, north: number): [latitude: number, longitude: number] {
  const from = origin.latitude * kRadian;
  const far = Math.hypot(east, north);
  const base = origin.longitude * kRadian;
  if (far < 1e-6) return [from, base];
  const c = far / sphere_at(origin);
  const latitude = Math.asin(Math.cos(c) * Math.sin(from) + (north * Math.sin(c) * Math.cos(from)) / far);
  const longitude = base + Math.atan2(east * Math.sin(c), far * Math.cos(from) * Math.cos(c) - north * Math.sin(from) * Math.sin(c));
  return [latitude, longitude];
}

/** From `a` to `b`: m as the crow flies, rad from true north at `a`, in [0, 2 pi), and m that `b` is higher. Off the origin the map's
 * north is not true north; the bearing is the great circle's. */
export function measure(origin: Origin, a: Place, b: Place): { range: number; bearing: number; higher: number } {
  const [from, from_lon] = to_globe(origin, a.east, a.north);
  const [to, to_lon] = to_globe(origin, b.east, b.north);
  const [x, y, z] = seen_from(from, to, to_lon - from_lon);
  const higher = b.up - a.up;
  const level = Math.atan2(Math.hypot(x, y), z) * (sphere_at(origin) + (a.up + b.up) / 2);
  return { range: Math.hypot(level, higher), bearing: wrapped(Math.atan2(x, y)), higher };
}

/** rad that the true bearing of the map's north is at a place: headings on the map and this make true headings. */
export function convergence(origin: Origin, { east, north }: Pick<Place, 'east' | 'north'>): number {
  return turn(0, measure(origin, { east, north, up: 0 }, { east, north: north + 100, up: 0 }).bearing);
}
