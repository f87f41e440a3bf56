// SPDX-License-Identifier: MIT
/** The map under the scene: projection, bearings, coastlines. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { coast_of, kReach } from '../src/scene/coast.ts';
import { convergence, measure, to_map } from '../src/scene/geo.ts';

const near = (a: number, b: number, by: number): void => assert.ok(Math.abs(a - b) <= by, `${a} is not within ${by} of ${b}`);
const kDegree = Math.PI / 180;

test('a degree north is sixty miles', () => {
  const [east, north] = to_map({ latitude: 33, longitude: -68 }, 34, -68);
  near(east, 0, 1e-6);
  near(north, 60 * 1852, 500);
});

test('from the origin bearing and range are those of the map', () => {
  const origin = { latitude: 33, longitude: -68 };
  const { range, bearing, higher } = measure(origin, { east: 0, north: 0, up: 0 }, { east: 100e3, north: 100e3, up: 0 });
  near(bearing, 45 * kDegree, 1e-9);
  near(range, Math.SQRT2 * 100e3, 1e-3);
  assert.equal(higher, 0);
});

test('off the origin true north is not the maps north', () => {
  const origin = { latitude: 60, longitude: 0 };
  const [east, north] = to_map(origin, 60, 10);
  const [east_b, north_b] = to_map(origin, 62, 10);
  const { bearing } = measure(origin, { east, north, up: 0 }, { east: east_b, north: north_b, up: 0 });
  const on_map = Math.atan2(east_b - east, north_b - north);
  near(on_map + convergence(origin, { east, north }), 0, 0.005);
  assert.equal(convergence(origin, { east: 0, north: 0 }), 0);
  near(Math.min(bearing, 2 * Math.PI - bearing), 0, 1e-9);
  assert.ok(Math.abs(on_map) > 7 * kDegree);
});

test('range is as the crow flies', () => {
  const { range, higher } = measure({ latitude: 0, longitude: 0 }, { east: 0, north: 0, up: 0 }, { east: 3000, north: 0, up: 4000 });
  near(range, 5000, 1.5);
  assert.equal(higher, 4000);
});

/** How many triangles of the land cover the place (km east, km north). */
function covers(land: Float32Array, x: number, y: number): number {
  let count = 0;
  for (let i = 0; i < land.length; i += 9) {
    const side = (a: number, b: number): number =>
      (land[i + b]! - land[i + a]!) * (-y - land[i + a + 2]!) - (land[i + b + 2]! - land[i + a + 2]!) * (x - land[i + a]!);
    const [p, q, r] = [side(0, 3), side(3, 6), side(6, 0)];
    if ((p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0)) ++count;
  }
  return count;
}

test('land is where land is', () => {
  const bermuda = { latitude: 33, longitude: -68 };
  const { land, shore, graticule } = coast_of(bermuda);
  const washington = to_map(bermuda, 38.9, -77.5);
  const halifax = to_map(bermuda, 45.5, -66.5);
  assert.equal(covers(land, 0, 0), 0);
  assert.ok(covers(land, washington[0] / 1000, washington[1] / 1000) > 0);
  assert.ok(covers(land, halifax[0] / 1000, halifax[1] / 1000) > 0);
  assert.ok(shore.length > 100 && graticule.length > 100);
  for (const lines of [shore, graticule])
    for (let i = 0; i < lines.length; i += 2) assert.ok(Math.hypot(lines[i]!, lines[i + 1]!) <= kReach + 0.1);
  for (let i = 0; i < land.length; i += 3) assert.ok(Math.hypot(land[i]!, land[i + 2]!) <= kReach + 0.1);
});

test('in the middle of a continent all is land and in the middle of an ocean nothing is', () => {
  const steppe = coast_of({ latitude: 48, longitude: 67 }).land;
  for (const [x, y] of [[0, 0], [900, 300], [200, -700]]) assert.ok(covers(steppe, x!, y!) > 0);
  // the antipodes of these lie in or near Asia and Australia
  for (const origin of [{ latitude: -48, longitude: -113 }, { latitude: 31, longitude: -50 }, { latitude: -35, longitude: -100 }]) {
    const { land, shore } = coast_of(origin);
    assert.equal(land.length, 0);
    assert.equal(shore.length, 0);
  }
});

test('the seams of the atlas are no shores', () => {
  // the atlas is cut along 180 degrees, through Chukotka and Antarctica
  const { land, shore } = coast_of({ latitude: 67, longitude: 180 });
  assert.ok(covers(land, -100, 0) > 0 && covers(land, 100, 0) > 0);
  for (let i = 0; i < shore.length; i += 4)
    assert.ok(Math.abs(shore[i]!) > 1 || Math.abs(shore[i + 2]!) > 1, 'no shore runs along the meridian');
  assert.ok(covers(coast_of({ latitude: -90, longitude: 0 }).land, 5, 5) > 0);
});
