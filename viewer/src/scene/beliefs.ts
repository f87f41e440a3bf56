// SPDX-License-Identifier: MIT
/** What a player believes at any time, and of the selected one its tracks against the truth, and its missile's zone against its target. */
import { last_at, type Place, type Player, type Side, type Sight, type TrackSeen } from '../run/run.ts';
import { kCrowd, range_words, x_of, y_of, z_of, type Frame } from './frame.ts';
import type { Mark } from './notes.ts';
import type { Palette } from './palette.ts';
import { draw_arc } from './callouts.ts';

const kMark: Record<TrackSeen['identity'], Mark> = { hostile: 'square', friendly: 'circle', unknown: 'diamond' };
/** s: older tracks are pale, and say how old they are. */
const kStale = 4;
const kHalfArc = Math.PI / 6;

function tint_of(track: TrackSeen, own: Side, palette: Palette): number {
  if (track.identity === 'unknown' || own === 'none') return palette.side.none;
  if (track.identity === 'friendly') return palette.side[own];
  return palette.side[own === 'blue' ? 'red' : 'blue'];
}

export function draw_tracks({ view, players, lines, palette, eye, notes, sight }: Frame): void {
  if (!view.layers.tracks || !sight) return;
  for (const track of sight.now.tracks) {
    const place = sight.place_of(track);
    const [x, y, z] = [x_of(place), y_of(place), z_of(place)];
    const tint = tint_of(track, sight.player.side, palette);
    const stale = track.age > kStale;
    const bold = track.is_target;
    if (track.truth >= 0 && players.shown[track.truth]) {
      lines.pen(tint, bold ? 1.8 : 1.2);
      lines.add(x, y, z, players.x[track.truth]!, players.y[track.truth]!, players.z[track.truth]!, stale ? 0.6 : 0.9);
    }
    if (!eye.project(x, y, z) || !eye.on_screen(20)) continue;
    const friend = track.identity === 'friendly';
    if (friend && players.count > kCrowd) continue;
    const radius = bold ? 15 : friend ? 11 : 13;
    notes.mark(kMark[track.identity], eye.px, eye.py, radius, tint, bold ? 3 : 1.5, false, stale || friend ? 0.65 : 1);
    const words = [...(track.identity === 'unknown' ? [`unknown #${track.id}`] : []), ...(stale && !friend ? [`${track.age.toFixed(0)} s old`] : [])];
    if (words.length && view.layers.labels) notes.tag(-100 - track.id, eye.px, eye.py, words.join(', '), '', tint, null, 22);
  }
}

/** Arcs around the player towards its target: nearest, no escape and farthest. */
export function draw_zone(frame: Frame): void {
  const { view, players, lines, palette, eye, notes, sight } = frame;
  const zone = sight?.now.zone;
  const target = sight?.now.tracks.find((track) => track.is_target);
  if (!view.layers.zones || !sight || !zone || !target) return;
  const i = sight.player.index;
  const [x, y, z] = [players.x[i]!, players.y[i]!, players.z[i]!];
  const place = sight.place_of(target);
  const bearing = Math.atan2(x_of(place) - x, z - z_of(place));
  const arc = (range: number, width: number, dash: number, alpha: number, label: string): void => {
    const km = range / 1000;
    if (!(km > 0) || km < 24 * eye.ui * eye.km_per_px(x, y, z)) return;
    lines.pen(palette.zone, width, dash);
    draw_arc(frame, x, y, z, km, alpha, bearing - kHalfArc, 2 * kHalfArc);
    const end = bearing + kHalfArc;
    if (eye.project(x + km * Math.sin(end), y, z - km * Math.cos(end)) && eye.on_screen())
      notes.tag(-10 - width, eye.px, eye.py, label, range_words(km), palette.zone, null, 60);
  };
  arc(zone.max, 1.5, 0, 0.85, 'max');
  arc(zone.no_escape, 3, 0, 1, 'no escape');
  arc(zone.min, 1, 0, 0.7, 'min');
  lines.pen(palette.zone, 1, 8);
  const far = zone.max / 1000;
  const near = zone.min / 1000;
  for (const a of [bearing - kHalfArc, bearing + kHalfArc]) {
    const [s, c] = [Math.sin(a), Math.cos(a)];
    lines.add(x + near * s, y, z - near * c, x + far * s, y, z - far * c, 0.55);
  }
}

/** s: over longer gaps between sights nothing is guessed. */
const kBridge = 2.5;

export interface Eyesight {
  player: Player;
  now: Sight;
  /** Where the track is believed to be: between sights on the straight line, so that it does not hop in playback. */
  place_of(track: TrackSeen): Place;
}

/** Null: it has seen nothing yet. */
export function eyesight(player: Player, t: number): Eyesight | null {
  const { sights } = player;
  const index = last_at(sights.t, t);
  if (index < 0) return null;
  const [from, to] = [sights.t[index]!, sights.t[index + 1] ?? Infinity];
  const next = to > from && to - from < kBridge ? sights.at(index + 1) : null;
  const share = Math.min(1, (t - from) / (to - from));
  return {
    player, now: sights.at(index),
    place_of({ id, place }) {
      const then = next?.tracks.find((other) => other.id === id)?.place ?? place;
      const between = (axis: keyof Place): number => place[axis] + (then[axis] - place[axis]) * share;
      return { east: between('east'), north: between('north'), up: between('up') };
    },
  };
}
