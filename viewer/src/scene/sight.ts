// SPDX-License-Identifier: MIT
/** What one player believes at any time. */
import { last_at, type Place, type Player, type Sight, type TrackSeen } from '../run/run.ts';

/** s: over longer gaps between sights nothing is guessed. */
const kBridge = 2.5;

export interface Eyesight {
  player: Player;
  now: Sight;
  /** Where the track is believed to be: between sights on the straight line, so that it does not hop in playback. */
  place_of(track: TrackSeen): Place;
}

/** Keeps the last two sights read, as each is made anew when asked for. */
export class SightReader {
  private player: Player | null = null;
  private index = -2;
  private now: Sight | null = null;
  private next: Sight | null = null;
  private share = 0;
  private readonly between: Place = { east: 0, north: 0, up: 0 };

  read(player: Player, t: number): Eyesight | null {
    const { sights } = player;
    const index = last_at(sights.t, t);
    if (index < 0) return null;
    if (player !== this.player || index !== this.index) {
      this.now = sights.at(index);
      const span = index + 1 < sights.t.length ? sights.t[index + 1]! - sights.t[index]! : Infinity;
      this.next = span > 0 && span < kBridge ? sights.at(index + 1) : null;
      this.player = player;
      this.index = index;
    }
    const { now, next } = this;
    if (!now) return null;
    this.share = next ? Math.min(1, (t - now.t) / (next.t - now.t)) : 0;
    return { player, now, place_of: (track) => this.place_of(track) };
  }

  private place_of(track: TrackSeen): Place {
    const { next, share, between } = this;
    const then = next?.tracks.find((other) => other.id === track.id);
    if (!then) return track.place;
    between.east = track.place.east + (then.place.east - track.place.east) * share;
    between.north = track.place.north + (then.place.north - track.place.north) * share;
    between.up = track.place.up + (then.place.up - track.place.up) * share;
    return between;
  }
}
