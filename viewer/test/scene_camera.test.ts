// SPDX-License-Identifier: MIT
/** Where the camera stands. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { SceneCamera } from '../src/scene/camera.ts';
import { Eye } from '../src/scene/eye.ts';
import { fit, height_for_both, kFlatFov, kFov, Rig, type Stance } from '../src/scene/rig.ts';
import { Sharpness } from '../src/scene/pace.ts';
import type { Poses } from '../src/scene/motion.ts';
import type { View } from '../src/store.ts';

const near = (a: number, b: number, by = 1e-6): void => assert.ok(Math.abs(a - b) <= by, `${a} is not within ${by} of ${b}`);
const stance = (patch: Partial<Stance> = {}): Stance => ({ x: 0, y: 0, z: 0, height: 100, azimuth: 0, polar: 0.9, fov: kFov, ...patch });

function eye_at(where: Stance): Eye {
  const eye = new Eye();
  eye.resize(1600, 900);
  eye.look(where);
  return eye;
}

test('from above north is up and a picture high is its height', () => {
  const eye = eye_at(stance({ polar: 0, fov: kFlatFov }));
  assert.ok(eye.project(0, 0, -50));
  near(eye.px, 800);
  near(eye.py, 0);
  assert.ok(eye.project(50, 0, 0));
  near(eye.px, 1250);
  near(eye.py, 450);
});

test('what is high stands nearly where it is on the map from above', () => {
  const eye = eye_at(stance({ polar: 0, fov: kFlatFov }));
  eye.project(60, 12, 0);
  const high = eye.px;
  eye.project(60, 0, 0);
  assert.ok(Math.abs(high - eye.px) < 5);
});

test('a pixel of the ground projects to itself', () => {
  const eye = eye_at(stance({ x: 12, z: -7, azimuth: 2.1, polar: 1.1 }));
  assert.ok(eye.hit(300, 700));
  assert.ok(eye.project(eye.ground_x, 0, eye.ground_z));
  near(eye.px, 300, 1e-6);
  near(eye.py, 700, 1e-6);
  assert.equal(eye_at(stance({ polar: 1.5 })).hit(800, 0), false, 'that is the sky');
});

test('it agrees with the camera of the renderer', () => {
  const eye = eye_at(stance({ x: 3, y: 5, azimuth: 0.7, polar: 1.2, height: 30 }));
  const { camera } = eye;
  camera.updateMatrixWorld();
  const [x, y, z] = [9, 8, -11];
  const view = camera.matrixWorldInverse.elements;
  const lens = camera.projectionMatrix.elements;
  const at = [0, 1, 2].map((row) => view[row]! * x + view[row + 4]! * y + view[row + 8]! * z + view[row + 12]!);
  assert.ok(eye.project(x, y, z));
  near(eye.px, (((lens[0]! * at[0]!) / -at[2]! + 1) / 2) * 1600, 1e-6);
  near(eye.py, ((1 - (lens[5]! * at[1]!) / -at[2]!) / 2) * 900, 1e-6);
  near(eye.depth, -at[2]!, 1e-9);
});

test('all fit into the picture', () => {
  const points = [new Vector3(-120, 7, 4), new Vector3(90, 11, -31), new Vector3(14, 2, 77)];
  for (const where of [stance(), stance({ polar: 0, fov: kFlatFov }), stance({ azimuth: 2, polar: 1.2 })]) {
    assert.ok(fit(where, points, 16 / 9, 10));
    const eye = eye_at(where);
    let [least, most] = [Infinity, -Infinity];
    for (const { x, y: up, z } of points)
      for (const y of [up, 0]) {
        assert.ok(eye.project(x, y, z));
        assert.ok(eye.on_screen(-50), `${eye.px} ${eye.py}`);
        least = Math.min(least, eye.px / 1600, eye.py / 900);
        most = Math.max(most, eye.px / 1600, eye.py / 900);
      }
    assert.ok(least < 0.15 || most > 0.85, 'and fill it');
  }
});

test('a few who keep together are not looked at too closely', () => {
  const where = stance();
  assert.ok(fit(where, [new Vector3(30, 9, -40)], 1.5, 16));
  assert.ok(where.height >= 16 - 1e-9);
  const eye = eye_at(where);
  eye.project(30, 9, -40);
  assert.ok(eye.on_screen(-200));
  assert.equal(fit(where, [], 1.5, 16), false);
});

test('two are in the picture from the middle between them, whichever way one is from the other', () => {
  for (const aspect of [16 / 9, 0.5])
    for (const polar of [0.1, 1.25, 1.5])
      for (const way of [[0, 1, 0], [0.1, 0.99, 0], [1, 0, 0], [0, 0, 1], [0.5, -0.8, -0.3]]) {
        const [dx, dy, dz] = way as [number, number, number];
        const where = stance({ polar, azimuth: 1, x: dx / 2, y: dy / 2, z: dz / 2 });
        const eye = new Eye();
        eye.resize(900 * aspect, 900);
        eye.look({ ...where, height: height_for_both(where, dx, dy, dz, aspect) });
        for (const part of [0, 1]) {
          assert.ok(eye.project(dx * part, dy * part, dz * part));
          assert.ok(eye.on_screen(-0.09 * Math.min(900 * aspect, 900)), `${way} at ${polar}: ${eye.px}, ${eye.py}`);
        }
      }
});

test('what is zoomed at stays in place all the way', () => {
  const rig = new Rig(stance({ polar: 0, fov: kFlatFov }));
  const eye = eye_at(rig.stance());
  assert.ok(eye.hit(1300, 200));
  const [x, z] = [eye.ground_x, eye.ground_z];
  rig.zoom(0.2, x, z);
  for (let i = 0; i < 60; ++i) {
    rig.step(1 / 60);
    eye.look(rig.stance());
    eye.project(x, 0, z);
    near(eye.px, 1300, 1);
    near(eye.py, 200, 1);
  }
  near(rig.stance().height, 20, 1e-9);
});

test('a glide ends and ends at the goal', () => {
  const rig = new Rig(stance());
  Object.assign(rig.goal, stance({ x: 40, height: 3, azimuth: 6, polar: 0.2 }));
  let steps = 0;
  while (rig.step(1 / 60)) assert.ok(++steps < 200);
  assert.deepEqual(rig.stance(), rig.goal);
});

test('to follow somebody else does not jump', () => {
  const rig = new Rig(stance({ x: 5 }));
  rig.rebase(100, 8, -3);
  near(rig.stance().x, 5);
  rig.carry(101, 8, -3);
  near(rig.stance().x, 6);
});

test('who wants less motion gets none', () => {
  const rig = new Rig(stance(), true);
  rig.goal.x = 77;
  assert.equal(rig.step(0.01), false);
  near(rig.stance().x, 77);
});

test('fewer pixels while it is too slow and all of them at rest', () => {
  const sharpness = new Sharpness();
  const pixels = 3840 * 2160;
  for (let i = 0; i < 30; ++i) sharpness.judge(16, pixels);
  assert.equal(sharpness.scale, 1);
  for (let i = 0; i < 60; ++i) sharpness.judge(200, pixels);
  assert.ok(sharpness.scale >= 0.4 && sharpness.scale < 0.5);
  assert.equal(sharpness.rest(), true);
  assert.equal(sharpness.scale, 1);
  assert.equal(sharpness.rest(), false);
  const small = new Sharpness();
  for (let i = 0; i < 60; ++i) small.judge(200, 1280 * 720);
  assert.equal(small.scale, 1);
});

test('the whole has in it what else there is to be seen', () => {
  const at = (...all: number[]) => all.map((x) => new Vector3(x, 8, 0));
  const view = { time: 0, end: 100, camera: 'whole', selected: 0, pose: null } as unknown as View;
  const other = at(150);
  for (const [also, seen] of [[[], false], [other, true]] as const) {
    const eye = eye_at(stance());
    const camera = new SceneCamera(true);
    camera.aim(view, { spots: () => at(-10, 10) } as unknown as Poses, eye, -1, [...also]);
    eye.look(camera.rig.stance());
    assert.equal(eye.project(150, 8, 0) && eye.on_screen(), seen);
    assert.ok(eye.project(-10, 8, 0) && eye.on_screen());
  }
});
