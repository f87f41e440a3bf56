// SPDX-License-Identifier: MIT
/** The picture without a graphics card: what of a line is seen, and what is stroked in one go. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Eye } from '../src/scene/eye.ts';
import { kFlatFov, kFov, type Stance } from '../src/scene/rig.ts';

type Op = readonly ['move' | 'line', number, number];

/** What a browser has and node has not. */
class FakePath {
  readonly ops: Op[] = [];
  moveTo(x: number, y: number): void {
    this.ops.push(['move', x, y]);
  }
  lineTo(x: number, y: number): void {
    this.ops.push(['line', x, y]);
  }
  closePath(): void {
    this.ops.push(['line', NaN, NaN]);
  }
}
Object.assign(globalThis, { Path2D: FakePath });
const { FlatLines } = await import('../src/scene/flat/lines.ts');
const { trace_area } = await import('../src/scene/flat/ground.ts');
const { level_of, shades_of } = await import('../src/scene/flat/fleet.ts');

interface Stroke {
  style: string;
  width: number;
  dash: number[];
  ops: Op[];
}
/** Draws, and gives what was stroked. */
function strokes_of(lines: InstanceType<typeof FlatLines>, eye: Eye): Stroke[] {
  const out: Stroke[] = [];
  let dash: number[] = [];
  const context = {
    strokeStyle: '', lineWidth: 0,
    setLineDash: (to: number[]) => (dash = to),
    stroke(path: FakePath) {
      out.push({ style: context.strokeStyle, width: context.lineWidth, dash, ops: path.ops });
    },
  };
  lines.draw(context as unknown as CanvasRenderingContext2D, eye);
  return out;
}

const near = (a: number, b: number, by = 1e-6): void => assert.ok(Math.abs(a - b) <= by, `${a} is not within ${by} of ${b}`);
function eye_at(patch: Partial<Stance> = {}): Eye {
  const eye = new Eye();
  eye.resize(1000, 500);
  eye.look({ x: 0, y: 0, z: 0, height: 100, azimuth: 0, polar: 0, fov: kFlatFov, ...patch });
  return eye;
}

test('a segment within the picture ends where its ends are', () => {
  const eye = eye_at({ polar: 1.1, fov: kFov, azimuth: 0.4 });
  const [a, b] = [[3, 2, -7], [-5, 8, 4]] as const;
  const at = [a, b].map(([x, y, z]) => (assert.ok(eye.project(x, y, z)), [eye.px, eye.py] as const));
  assert.ok(eye.segment(...a, ...b));
  near(eye.px, at[0]![0]);
  near(eye.py, at[0]![1]);
  near(eye.qx, at[1]![0]);
  near(eye.qy, at[1]![1]);
});

test('a segment is cut where it leaves the picture, and keeps its line', () => {
  const eye = eye_at();
  // 5 px to the km: from the middle far out to the right, and half as much up
  assert.ok(eye.segment(0, 0, 0, 1000, 0, -500));
  near(eye.px, 500);
  near(eye.py, 250);
  assert.ok(eye.qx > 1000 && eye.qx < 1100 || (eye.qy < 0 && eye.qy > -100), `ends at ${eye.qx} ${eye.qy}`);
  near((250 - eye.qy) / (eye.qx - 500), 0.5, 1e-9);
  assert.equal(eye.segment(300, 0, 0, 300, 0, -40), false, 'beside the picture');
  assert.equal(eye.segment(-300, 0, 20, 20, 0, 300), false, 'past its corner');
});

test('a segment is cut where it passes the eye', () => {
  const eye = eye_at({ polar: 1.2, fov: kFov });
  const { x, y, z } = { x: 1, y: 0, z: 0 };
  assert.ok(eye.segment(x, y, z, 1, 60, 400), 'its other end is behind the eye');
  assert.ok(eye.project(x, y, z));
  assert.ok([eye.px, eye.py, eye.qx, eye.qy].every(Number.isFinite));
  assert.equal(eye.segment(0, 80, 300, 5, 90, 400), false, 'all of it is');
});

test('legs that follow each other in one colour are one line', () => {
  const eye = eye_at();
  const lines = new FlatLines();
  lines.clear();
  lines.pen(0x112233, 2);
  lines.add(0, 0, 0, 5, 0, 0, 0.5);
  lines.add(5, 0, 0, 5, 0, 5, 0.5);
  lines.add(-5, 0, 0, -5, 0, 5, 0.5);
  lines.pen(0x445566, 1, 10);
  lines.add(0, 0, 0, 1, 0, 0, 1);
  lines.pen(0x112233, 2);
  lines.add(0, 0, 9, 1, 0, 9, 0);
  const [first, second, ...rest] = strokes_of(lines, eye);
  assert.deepEqual(rest, [], 'what is not seen at all is not stroked');
  assert.deepEqual(first!.ops.map(([op]) => op), ['move', 'line', 'line', 'move', 'line']);
  assert.deepEqual([first!.style, first!.width, first!.dash], ['rgba(17,34,51,0.5)', 2, []]);
  assert.equal(second!.dash.reduce((a, b) => a + b), 10);
  lines.clear();
  assert.deepEqual(strokes_of(lines, eye), [], 'the next picture begins empty');
});

test('many segments of many widths are few strokes', () => {
  const eye = eye_at();
  const lines = new FlatLines();
  lines.clear();
  const count = 5000;
  for (let i = 0; i < count; ++i) {
    lines.pen(0x808080, 2 + (4 * i) / count);
    lines.add(0, 0, -40 + (80 * i) / count, 10, 0, -40 + (80 * i) / count, 1);
  }
  const strokes = strokes_of(lines, eye);
  assert.ok(strokes.length <= 20, `${strokes.length} strokes`);
  assert.equal(strokes.reduce((sum, { ops }) => sum + ops.filter(([op]) => op === 'line').length, 0), count, 'and none is lost');
});

test('of the ground only what is before the eye is filled', () => {
  const square = [-900, 0, -900, 900, 0, -900, 900, 0, 900, -900, 0, 900];
  const [above, low] = [new FakePath(), new FakePath()];
  trace_area(above as unknown as Path2D, eye_at(), square);
  assert.equal(above.ops.filter(([, x]) => Number.isFinite(x)).length, 4);
  trace_area(low as unknown as Path2D, eye_at({ polar: 1.4, fov: kFov }), square);
  const seen = low.ops.filter(([, x]) => Number.isFinite(x));
  assert.ok(seen.length >= 3 && low.ops.length > 0);
  // two corners lie behind, and the border runs below the picture instead
  assert.equal(seen.filter(([, , y]) => y > 500).length >= 2, true);
  const behind = new FakePath();
  trace_area(behind as unknown as Path2D, eye_at({ polar: 1.4, fov: kFov }), [-1, 0, 500, 1, 0, 500, 1, 0, 900, -1, 0, 900]);
  assert.deepEqual(behind.ops, []);
});

test('what looks up is lighter than what looks down, and never lighter than the sun makes it', () => {
  const [up, level, down] = [level_of(0, 1, 0), level_of(1, 0, 0), level_of(0, -1, 0)];
  assert.ok(up > level && level > down && down > 0, `${up} ${level} ${down}`);
  const shades = shades_of(0x0072b2);
  const blue = (style: string): number => Number(/,(\d+),1\)$/.exec(style)![1]);
  for (let k = 1; k < shades.length; ++k) assert.ok(blue(shades[k]!) >= blue(shades[k - 1]!));
  assert.equal(shades[0], 'rgba(0,0,0,1)');
});
