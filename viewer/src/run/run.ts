// SPDX-License-Identifier: MIT
/** A recorded run as the page holds it in memory. SI units and radians throughout, time in seconds. */
import type { RunningEngine } from '../engine/engine.ts';

export type Side = 'blue' | 'red' | 'none';

/** East and north on the map (m, azimuthal equidistant around the scenario's reference point), and
 * the altitude above the ellipsoid (m). */
export interface Place {
  east: number;
  north: number;
  up: number;
}

/** Samples of a motion, by time. All arrays have one length. */
export interface Motion {
  t: Float64Array;
  east: Float64Array;
  north: Float64Array;
  up: Float64Array;
  heading: Float64Array;  // rad clockwise from north on the map, in [0, 2 pi).
  pitch: Float64Array;  // rad, positive up.
  roll: Float64Array;  // rad, positive right wing down.
}

/** What the strips show, at the times of `motion.t`. */
export interface Gauges {
  speed: Float64Array;  // m/s true airspeed.
  mach: Float64Array;
  load_factor: Float64Array;  // g
  fuel: Float64Array;  // kg, NaN for vehicles.
}

export type PlayerKind = 'aircraft' | 'vehicle';

export interface Player {
  index: number;  // Index into Run.players.
  name: string;
  side: Side;
  kind: PlayerKind;
  type: string;  // "F-15C"
  model: string;  // "f15c"
  flight: number;  // Index into Run.flights.
  remote: boolean;  // Another program flies it, and takes no orders.
  born: number;  // When it was first there; 1e9: never.
  gone: number;  // When it left the run: home, lost, not heard of any more, or the end of the run.
  end: 'home' | 'lost' | 'unheard' | '';  // Unheard: another program flew it, and fell silent.
  motion: Motion;
  gauges: Gauges;
  decisions: Decisions;
  sights: Sights;
  /** Half of the width and of the height of the radar's scan (rad), and its range (m); null: none. */
  radar: { azimuth: number; elevation: number; range: number } | null;
}

export interface Missile {
  id: number;
  type: string;  // "AIM-120"
  side: Side;
  shooter: number;  // Index into Run.players; -1: nobody.
  target: number;
  born: number;
  gone: number;
  active: number;  // When its own seeker went active; NaN: never.
  end: 'kill' | 'miss' | 'trashed' | 'flying';
  motion: Motion;
}

export interface Waypoint extends Place {
  speed: number;  // m/s, NaN: unchanged.
}

export interface Flight {
  name: string;
  side: Side;
  kind: PlayerKind;
  members: number[];  // Indices into Run.players, in order of rank.
  route: Waypoint[];
  home: Place | null;
}

export interface StoryLine {
  t: number;
  kind: string;  // "launch", "kill", "defend", "phase", ...: the kind of event.
  tone: 'plain' | 'blue' | 'red' | 'kill' | 'phase';
  who: number;  // Index into Run.players; -1: nobody.
  name: string;
  text: string;
  decider: number;  // Whose decision it comes of: of a kill its victim's; an index into Run.players, -1: nobody's.
  decided: number;  // s, when that was made, or later.
}

interface NamedField {
  name: string;
  unit: string;  // SI: "rad", "m", "m/s", "".
  form: 'quantity' | 'height' | 'climb' | 'direction';  // As what its numbers read.
}

export interface ActionField extends NamedField {
  /** number: the value itself; text: an index into Run.texts; id: a track's number, 0 for nobody. */
  kind: 'number' | 'text' | 'flag' | 'id';
}

export interface StateField extends NamedField {
  kind: 'number' | 'flag' | 'choice';
  choices: string[];
}

/** What pilots, or drivers, can want and see. */
export interface Platform {
  action: ActionField[];
  state: StateField[];
}

export interface TreeNode {
  label: string;
  type: string;  // "winner_takes_all", "pursue" ...
  path: string;  // "root/bvr/pursue": what `eyrie whatif --set` calls it.
  kind: 'behavior' | 'arbiter' | 'control' | 'decorator' | 'condition';
  parent: number;  // Index of the parent in the tree; -1 for the root.
  children: number[];
  depth: number;
  /** As a file would write them: "2 nmi"; limits and axes by field: "bounds.altitude.min", "grid.heading.from". */
  params: Record<string, string>;
  remembers: boolean;  // It keeps something from decision to decision.
  /** Of a sequencer, whose last children are the conditions of these: from which of its first children to which; -1: from any. */
  rules?: [from: number, to: number][];
}

/** Nodes in pre-order: children stand behind their parent. */
export interface Tree {
  name: string;
  kind: PlayerKind;
  nodes: TreeNode[];
}

export type Status = 'failure' | 'success' | 'running';

/** What does not change from decision to decision for long: statuses, votes, who supplied what. */
export interface Shape {
  tree: number;  // Index into Run.trees.
  leader: number;  // The node whose recommendation led; -1: nobody's.
  status: (Status | null)[];  // Per node; null: not asked.
  vote: number[];  // Per node, as it went up.
  why: string[];  // Per node why it failed; "" if it did not say or did not fail.
  /** Per node, per field of the action: the node that supplied it (a leaf, or the arbiter that
   * blended it), or -1: not set. Null for nodes that proposed nothing. */
  supplier: (Int16Array | null)[];
  held: (boolean[] | null)[];  // Whether that one proposed it in an earlier decision, whatever it answered in this.
  won: Won[];  // By field of the action, those that were set.
}

/** Who won a field of the action. */
export interface Won {
  field: number;  // Index into the platform's action.
  winner: number;  // A leaf, or the arbiter that blended it.
  reason: string;  // "voted 40 against 10".
  rivals: Rival[];  // What a blend is made of, then those that came up, then the others; by vote, the highest first.
}
/** Somebody who proposed a field that another one won. */
export interface Rival {
  node: number;
  vote: number;  // Of its branch, where it met that of the winner.
}

/** The node of which Decisions.value() has what `node` sent up for `field`; -1: none. */
export function source_of({ supplier, held }: Shape, node: number, field: number): number {
  const from = supplier[node]?.[field] ?? -1;
  if (from < 0 || !held[node]![field]) return from;
  return held[0]?.[field] && supplier[0]![field] === from ? 0 : -1; // Only the root's is recorded.
}

export interface Decisions {
  t: Float64Array;
  step: Float64Array;  // Of the world.
  shape: Int32Array;  // Indices into Run.shapes.
  why_not: Int32Array;  // Indices into Run.texts: why who led before leads no more; -1: he does, or in another tree.
  /** What `node` proposed itself for `field` at each decision; NaN where it did not. Null: never. */
  value(node: number, field: number): Float64Array | null;
}

export interface TrackSeen {
  id: number;  // As the player knows it.
  truth: number;  // Who it really is: index into Run.players; -1: not one of them.
  identity: 'unknown' | 'friendly' | 'hostile';
  is_target: boolean;
  place: Place;
  age: number;  // s since the last update.
}
export interface Warning {
  kind: string;  // "radar" or "missile".
  bearing: number;  // rad, true.
  range: number;  // m; NaN: unknown.
  name: string;  // "bogey1", "missile 12": who it really is.
}
export interface Sight {
  t: number;
  state: Float64Array;  // By field of the platform's state, NaN: no value.
  tracks: TrackSeen[];
  warnings: Warning[];
  /** Middle of the scan: rad clockwise from the heading, and up. */
  scan: { mode: 'off' | 'search' | 'track'; azimuth: number; elevation: number } | null;
  /** m, of the missile in hand against the target; null: no target or no missile. */
  zone: { min: number; no_escape: number; max: number } | null;
}
/** What a player perceived, once a second and whenever somebody else in its tree began to lead. */
export interface Sights {
  t: Float64Array;
  at(index: number): Sight;
  /** A field of the state over all sights. */
  channel(field: number): Float64Array;
}

export interface Run {
  about: {
    scenario: string;
    help: string;
    file: string;
    seed: string;
    sets: string[];  // Overrides, as given.
    hash: string;  // World hash at the end.
    build: string;
    steps: number;
    dt: number;
    duration: number;
    outcome: string;
    /** s between decisions that the page has; larger than the agents' own period if thinned. */
    decision_period: number;
    thinned: boolean;
  };
  origin: { latitude: number; longitude: number };  // deg
  flights: Flight[];
  players: Player[];
  missiles: Missile[];
  trees: Tree[];
  shapes: Shape[];
  platforms: Record<PlayerKind, Platform>;
  texts: string[];
  stores: string[];  // Types of missiles, as a release counts them.
  story: StoryLine[];
  verified?: string;  // With what it was compared, if not with a recording.
  is_part?: boolean;  // Only its beginning: the rest is being flown.
  engine?: RunningEngine;  // Who flew it again and can be asked; none if the page has its columns only.
}

/** The index of the last time that is not after `t`; -1 if all are. */
export function last_at(times: Float64Array, t: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= t + 1e-9) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
