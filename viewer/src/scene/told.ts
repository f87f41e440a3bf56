// SPDX-License-Identifier: MIT
/** The picture in words, for those who do not see it. */
import type { Run } from '../run/run.ts';
import type { View } from '../store.ts';
import { clock_text, heading_text } from '../words/text.ts';
import { height_words } from './frame.ts';
import { convergence } from './geo.ts';
import type { Poses } from './motion.ts';

const kCamera: Record<View['camera'], string> = {
  free: 'seen from a free camera', follow: 'seen from behind the selected player', top: 'seen from above', whole: 'seen as a whole',
};

/** rad: of a player who is there now. */
export function true_heading(run: Run, players: Poses, i: number): number {
  return players.heading[i]! + convergence(run.origin, { east: players.x[i]! * 1000, north: -players.z[i]! * 1000 });
}

export function told(run: Run, view: View, players: Poses, missiles: Poses): string {
  const alive = { blue: 0, red: 0, none: 0 };
  for (const player of run.players) alive[player.side] += players.shown[player.index]!;
  const flying = missiles.shown.reduce((sum, shown) => sum + shown, 0);
  const sides = (['blue', 'red', 'none'] as const).filter((side) => run.players.some((p) => p.side === side))
    .map((side) => `${alive[side]} ${side === 'none' ? 'neutral' : side}`);
  const words = [`Air picture at ${clock_text(view.time)}, ${kCamera[view.camera]}: ${sides.join(', ')}, ${flying} missiles in flight.`];
  const chosen = run.players[view.selected];
  if (chosen) {
    const i = chosen.index;
    const there = `${chosen.name}, ${chosen.type}, heading ${heading_text(true_heading(run, players, i))} at ${height_words(players.y[i]!)}.`;
    words.push(players.shown[i] ? `Selected: ${there}` : `Selected: ${chosen.name}, not in the air picture.`);
  }
  return words.join(' ');
}
