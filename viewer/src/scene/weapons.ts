// SPDX-License-Identifier: MIT
/** Missiles in flight and what becomes of them, and of everybody. */
import type { Missile } from '../run/run.ts';
import { type Frame, kCrowd, kSideMark } from './frame.ts';
import { draw_legs } from './trails.ts';

/** s: how long smoke, fire and its smoke hang there. */
export const kSmoke = 20;
const kFire = 4;
const kPlume = 25;
const kPuff = 2.5;
/** Among more missiles than these only those that concern the selected player have labels. */
const kFew = 8;

function draw_smoke({ view, lines, palette }: Frame, missile: Missile): void {
  draw_legs(lines, missile.motion, [Math.max(missile.born, view.time - kSmoke), Math.min(view.time, missile.gone)], 0.5, (t) => {
    const age = (view.time - t) / kSmoke;
    lines.pen(palette.smoke, 2 + 4 * age);
    return 0.75 * (1 - age) * (1 - age);
  });
}

/** A fireball and the smoke it leaves, `age` s after it burst. */
function draw_burst({ puffs, palette, eye }: Frame, x: number, y: number, z: number, age: number, big: boolean): void {
  const { ui } = eye;
  if (!big) {
    const fade = 1 - age / kPuff;
    if (fade > 0) puffs.add(x, y, z, 0.02 + 0.05 * (1 - fade), (4 + 8 * (1 - fade)) * ui, palette.smoke, 0.8 * fade);
    return;
  }
  const plume = 1 - age / kPlume;
  if (plume > 0) puffs.add(x, y + 0.004 * age, z, 0.08 + 0.01 * age, (9 + 0.5 * age) * ui, palette.smoke, 0.55 * plume);
  const fire = 1 - age / kFire;
  if (fire <= 0) return;
  const grown = 1 - fire * fire;
  puffs.add(x, y, z, 0.05 + 0.2 * grown, (8 + 20 * grown) * ui, palette.fire, 0.9 * fire);
  puffs.add(x, y, z, 0.04 + 0.05 * grown, (6 + 8 * grown) * ui, palette.core, fire * fire);
}

function draw_missile(frame: Frame, missile: Missile, i: number, few: boolean): void {
  const { view, missiles, players, lines, palette, eye, notes } = frame;
  const [x, y, z] = [missiles.x[i]!, missiles.y[i]!, missiles.z[i]!];
  const tint = palette.side[missile.side];
  const active = view.time >= missile.active;
  if (missile.target >= 0 && players.shown[missile.target]) {
    lines.pen(tint, active ? 1.6 : 1.1, active ? 0 : 6);
    lines.add(x, y, z, players.x[missile.target]!, players.y[missile.target]!, players.z[missile.target]!, active ? 0.85 : 0.6);
  }
  const mine = missile.shooter === view.selected || missile.target === view.selected;
  if (!view.layers.labels || !(few || mine) || !eye.project(x, y, z) || !eye.on_screen()) return;
  notes.tag(10000 + missile.id, eye.px, eye.py, missile.type, active ? 'active' : '', tint, null, mine ? 45 : 25);
}

export function draw_missiles(frame: Frame): void {
  const { run, view, missiles } = frame;
  const flying = missiles.shown.reduce((sum, shown) => sum + shown, 0);
  for (const [i, missile] of run.missiles.entries()) {
    if (view.time < missile.born) continue;
    if (view.layers.trails && view.time < missile.gone + kSmoke) draw_smoke(frame, missile);
    if (missiles.shown[i]) draw_missile(frame, missile, i, flying <= kFew);
    else if (missile.end !== 'flying')
      draw_burst(frame, missiles.x[i]!, missiles.y[i]!, missiles.z[i]!, view.time - missile.gone, missile.end === 'kill');
  }
}

/** Who has left: of the lost fire at its time, and from then on a cross on the map; who is home stands pale where that was. */
export function draw_gone(frame: Frame): void {
  const { run, view, players, eye, notes, palette } = frame;
  for (const player of run.players) {
    const { index, side, name, end } = player;
    if (!end || view.time < player.gone) continue;
    const lost = end === 'lost';
    const [x, y, z] = [players.x[index]!, players.y[index]!, players.z[index]!];
    if (lost) draw_burst(frame, x, y, z, view.time - player.gone, true);
    if (!eye.project(x, lost ? 0 : y, z) || !eye.on_screen(10)) continue;
    const tint = lost ? palette.side[side] : palette.faint;
    if (lost) notes.mark('cross', eye.px, eye.py, 6.5, palette.chip, 5, false, 0.7);
    notes.mark(lost ? 'cross' : kSideMark[side], eye.px, eye.py, 6, tint, lost ? 2.4 : 1.4, false, lost ? 1 : 0.8);
    const chosen = index === view.selected;
    if (view.layers.labels && (chosen || players.count <= kCrowd))
      notes.tag(20000 + index, eye.px, eye.py, name, end === 'unheard' ? 'not heard of' : end, tint, kSideMark[side], chosen ? 95 : 22);
  }
}
