// SPDX-License-Identifier: MIT
/** Another run of the same players beside the one that was flown, such as its other future: where everybody would be, drawn hollow and
 * broken from where the two part. */
import { made } from '../made.ts';
import type { Run, Side } from '../run/run.ts';
import { kSideMark, type Frame } from './frame.ts';
import { Poses } from './motion.ts';
import { draw_way, trail_of } from './trails.ts';
import { kSmoke } from './weapons.ts';

export interface Other {
  from: number;  // s: where it parts from the run.
  run: Run;
  label: string;
}
export const kFlownOn = 'flown on';

/** km: nearer than this the two futures are one in the picture. */
const kApart = 0.05;

const kPoses = new WeakMap<Run, { players: Poses; missiles: Poses }>();

/** Where all in it are at the time of the picture; null: there is none, or not yet. */
export function poses_of({ other, view }: Pick<Frame, 'other' | 'view'>): { players: Poses; missiles: Poses } | null {
  if (!other || view.time < other.from) return null;
  const { run } = other;
  const poses = made(kPoses, run, () => ({ players: new Poses(run.players), missiles: new Poses(run.missiles) }));
  poses.players.update(view.time);
  poses.missiles.update(view.time);
  return poses;
}

export function draw_other(frame: Frame): void {
  const { other, view, players, lines, palette, eye, notes } = frame;
  const poses = poses_of(frame);
  if (!other || !poses) return;
  const { run } = other;
  const place = (all: Poses, i: number): boolean => eye.project(all.x[i]!, all.y[i]!, all.z[i]!) && eye.on_screen();
  const tint = (side: Side): number => palette.side[side];

  for (const player of run.players) {
    const i = player.index;
    const { x, y, z, shown, noted } = poses.players;
    if (run.players[i]!.name !== frame.run.players[i]?.name) continue;
    const apart = Math.hypot(x[i]! - players.x[i]!, y[i]! - players.y[i]!, z[i]! - players.z[i]!) > kApart || shown[i] !== players.shown[i];
    if (!apart) continue;
    lines.pen(tint(player.side), i === view.selected ? 2.2 : 1.6);
    if (view.layers.trails) draw_way(frame, player.motion, Math.max(other.from, view.time - trail_of(view)), Math.min(view.time, player.gone), true);
    if (shown[i] && players.shown[i]) {
      lines.pen(palette.faint, 1, 3);
      lines.add(x[i]!, y[i]!, z[i]!, players.x[i]!, players.y[i]!, players.z[i]!, 0.5);
    }
    if (!(shown[i] || noted[i]) || !place(poses.players, i)) continue;
    notes.mark(shown[i] ? kSideMark[player.side] : 'cross', eye.px, eye.py, 6, tint(player.side), 1.8);
    if (view.layers.labels) notes.tag(30000 + i, eye.px, eye.py, player.name, shown[i] ? other.label : `lost, ${other.label}`, tint(player.side), null, i === view.selected ? 90 : 20);
  }
  run.missiles.forEach((missile, i) => {
    if (view.time < missile.born || view.time > missile.gone + kSmoke) return;
    lines.pen(palette.smoke, 1.8);
    if (view.layers.trails) draw_way(frame, missile.motion, Math.max(missile.born, view.time - kSmoke), Math.min(view.time, missile.gone), true);
    if (poses.missiles.shown[i] && place(poses.missiles, i)) notes.mark('diamond', eye.px, eye.py, 3, tint(missile.side), 1.4);
  });
}
