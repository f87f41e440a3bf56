// SPDX-License-Identifier: MIT
/**
 * From the data of the page to a Run. src/page writes it, in the program or in the engine of the page:
 *
 *   u32 length of the document | document (JSON) | columns
 *
 * A column stands in the document as [offset, count, quantum, order] and in the columns as `count`
 * numbers, each a zigzag varint: the value over `quantum`, rounded, as its `order`-th difference. The
 * number kNothing stands for NaN.
 */
import type {
  ActionField, Decisions, Flight, Gauges, Missile, Motion, Place, Player, PlayerKind, Run, Shape, Side, Sight,
  Sights, StateField, Status, StoryLine, TrackSeen, Tree, TreeNode, Warning, Waypoint,
} from './run.ts';

export const kFormat = 1;
const kNothing = -2147483648;

export type Column = [offset: number, count: number, quantum: number, order: number];

export class Columns {
  constructor(private readonly bytes: Uint8Array) {}

  read([offset, count, quantum, order]: Column): Float64Array {
    const out = new Float64Array(count);
    const bytes = this.bytes;
    let at = offset;
    let last = 0;
    let slope = 0;
    for (let i = 0; i < count; ++i) {
      let value = 0;
      let scale = 1;
      for (;;) {
        const byte = bytes[at++]!;
        value += (byte & 127) * scale;
        if (byte < 128) break;
        scale *= 128;
      }
      value = value % 2 ? -(value + 1) / 2 : value / 2;
      if (order === 2) {
        slope += value;
        last += slope;
      } else if (order === 1) {
        last += value;
      } else {
        last = value;
      }
      out[i] = last === kNothing ? NaN : last * quantum;
    }
    return out;
  }
}

interface MotionData { t: Column; east: Column; north: Column; up: Column; heading: Column; pitch: Column; roll: Column }
interface SightData {
  t: Column;
  state: Column[];
  tracks: { count: Column; id: Column; truth: Column; identity: Column; target: Column; east: Column; north: Column; up: Column; age: Column };
  warnings: { count: Column; kind: Column; bearing: Column; range: Column; name: Column };
  scan: { mode: Column; azimuth: Column; elevation: Column } | null;
  zone: { min: Column; no_escape: Column; max: Column } | null;
}
interface PlayerData {
  id: number; name: string; side: Side; kind: PlayerKind; type: string; model: string; flight: number; rank: number;
  born: number; gone: number; end: 'home' | 'lost' | '';
  radar: Player['radar'];
  motion: MotionData;
  gauges: { speed: Column; mach: Column; load_factor: Column; fuel: Column };
  decisions: { step: Column; shape: Column; values: [node: number, field: number, column: Column][] };
  sights: SightData;
}
interface MissileData {
  id: number; type: string; side: Side; shooter: number; target: number; born: number; gone: number;
  active: number | null; end: Missile['end']; motion: MotionData;
}
interface ShapeData {
  tree: number; leader: number;
  /** A letter a node: '-' not asked, F, S, R. */
  status: string;
  vote: number[];
  /** [node, index into texts] */
  why: [number, number][];
  /** [node, supplier of field 0, of field 1, ...] */
  supplier: number[][];
}
interface Document {
  format: number;
  about: Run['about'];
  origin: Run['origin'];
  flights: { name: string; side: Side; kind: PlayerKind; members: number[]; route: (number | null)[][]; home: number[] | null }[];
  players: PlayerData[];
  missiles: MissileData[];
  trees: { name: string; kind: PlayerKind; nodes: Omit<TreeNode, 'children'>[] }[];
  shapes: ShapeData[];
  platforms: Record<PlayerKind, { action: ActionField[]; state: StateField[] }>;
  texts: string[];
  story: StoryLine[];
}

const kStatus: Record<string, Status | null> = { '-': null, F: 'failure', S: 'success', R: 'running' };
const kIdentities = ['unknown', 'friendly', 'hostile'] as const;
const kModes = ['off', 'search', 'track'] as const;

function lazy<T>(make: () => T): () => T {
  let made: { value: T } | null = null;
  return () => (made ??= { value: make() }).value;
}

/** An object whose members are decoded when they are first asked for. */
function lazy_members<T extends object>(makers: { [K in keyof T]: () => T[K] }): T {
  const out = {};
  for (const key of Object.keys(makers) as (keyof T)[])
    Object.defineProperty(out, key, { enumerable: true, get: lazy(makers[key] as () => unknown) });
  return out as T;
}

function motion_of(columns: Columns, data: MotionData): Motion {
  return lazy_members<Motion>({
    t: () => columns.read(data.t),
    east: () => columns.read(data.east),
    north: () => columns.read(data.north),
    up: () => columns.read(data.up),
    heading: () => columns.read(data.heading),
    pitch: () => columns.read(data.pitch),
    roll: () => columns.read(data.roll),
  });
}

function decisions_of(columns: Columns, data: PlayerData['decisions'], shapes: Shape[], dt: number): Decisions {
  const step = lazy(() => columns.read(data.step));
  const shape = lazy(() => Int32Array.from(columns.read(data.shape)));
  const t = lazy(() => step().map((s) => s * dt));
  const values = new Map<string, () => Float64Array>();
  for (const [node, field, column] of data.values)
    values.set(`${node}/${field}`, lazy(() => {
      // dense over the decisions in which the node set the field itself
      const dense = columns.read(column);
      const all = new Float64Array(shape().length).fill(NaN);
      let next = 0;
      shape().forEach((s, i) => {
        if (shapes[s]!.supplier[node]?.[field] === node) all[i] = dense[next++]!;
      });
      return all;
    }));
  return {
    get t() { return t(); },
    get step() { return step(); },
    get shape() { return shape(); },
    value: (node, field) => values.get(`${node}/${field}`)?.() ?? null,
  };
}

/** Where the rows of each sight begin. */
function starts(count: Float64Array): Int32Array {
  const out = new Int32Array(count.length + 1);
  for (let i = 0; i < count.length; ++i) out[i + 1] = out[i]! + count[i]!;
  return out;
}

function sights_of(columns: Columns, data: SightData, texts: string[]): Sights {
  const t = lazy(() => columns.read(data.t));
  const state = data.state.map((column) => lazy(() => columns.read(column)));
  const table = lazy(() => {
    const read = <T extends Record<string, Column>>(part: T) =>
      Object.fromEntries(Object.entries(part).map(([k, c]) => [k, columns.read(c)])) as { [K in keyof T]: Float64Array };
    const tracks = read(data.tracks);
    const warnings = read(data.warnings);
    return {
      tracks, warnings, first_track: starts(tracks.count), first_warning: starts(warnings.count),
      scan: data.scan && read(data.scan), zone: data.zone && read(data.zone),
    };
  });
  const tracks_at = (i: number): TrackSeen[] => {
    const { tracks: c, first_track: first } = table();
    const out: TrackSeen[] = [];
    for (let k = first[i]!; k < first[i + 1]!; ++k)
      out.push({
        id: c.id[k]!, truth: c.truth[k]!, identity: kIdentities[c.identity[k]!] ?? 'unknown', is_target: c.target[k] === 1,
        place: { east: c.east[k]!, north: c.north[k]!, up: c.up[k]! }, age: c.age[k]!,
      });
    return out;
  };
  const warnings_at = (i: number): Warning[] => {
    const { warnings: c, first_warning: first } = table();
    const out: Warning[] = [];
    for (let k = first[i]!; k < first[i + 1]!; ++k)
      out.push({ kind: texts[c.kind[k]!]!, bearing: c.bearing[k]!, range: c.range[k]!, name: texts[c.name[k]!]! });
    return out;
  };
  return {
    get t() { return t(); },
    channel: (field) => state[field]!(),
    at(i): Sight {
      const { scan, zone } = table();
      return {
        t: t()[i]!,
        state: Float64Array.from(state, (column) => column()[i]!),
        tracks: tracks_at(i),
        warnings: warnings_at(i),
        scan: scan && { mode: kModes[scan.mode[i]!] ?? 'off', azimuth: scan.azimuth[i]!, elevation: scan.elevation[i]! },
        zone: zone && zone.max[i]! > 0 ? { min: zone.min[i]!, no_escape: zone.no_escape[i]!, max: zone.max[i]! } : null,
      };
    },
  };
}

function shape_of(data: ShapeData, texts: string[]): Shape {
  const status = Array.from(data.status, (letter) => kStatus[letter] ?? null);
  const why = status.map(() => '');
  for (const [node, text] of data.why) why[node] = texts[text]!;
  const supplier: (Int16Array | null)[] = status.map(() => null);
  for (const [node, ...fields] of data.supplier) supplier[node!] = Int16Array.from(fields);
  return { tree: data.tree, leader: data.leader, status, vote: data.vote, why, supplier };
}

function tree_of(data: Document['trees'][number]): Tree {
  const nodes: TreeNode[] = data.nodes.map((node) => ({ ...node, children: [] }));
  nodes.forEach((node, i) => {
    if (node.parent >= 0) nodes[node.parent]!.children.push(i);
  });
  return { name: data.name, kind: data.kind, nodes };
}

function place_of([east, north, up]: number[]): Place {
  return { east: east!, north: north!, up: up! };
}

export function run_of(document: Document, columns: Columns): Run {
  if (document.format !== kFormat)
    throw new Error(`this page reads data of format ${kFormat}, and this run is of format ${document.format}`);
  const { texts } = document;
  const shapes = document.shapes.map((s) => shape_of(s, texts));
  const waypoint = ([east, north, up, speed]: (number | null)[]): Waypoint =>
    ({ east: east!, north: north!, up: up!, speed: speed ?? NaN });
  return {
    about: document.about,
    origin: document.origin,
    flights: document.flights.map((f): Flight => ({ ...f, route: f.route.map(waypoint), home: f.home && place_of(f.home) })),
    players: document.players.map((p, index): Player => ({
      ...p,
      index,
      motion: motion_of(columns, p.motion),
      gauges: lazy_members<Gauges>({
        speed: () => columns.read(p.gauges.speed),
        mach: () => columns.read(p.gauges.mach),
        load_factor: () => columns.read(p.gauges.load_factor),
        fuel: () => columns.read(p.gauges.fuel),
      }),
      decisions: decisions_of(columns, p.decisions, shapes, document.about.dt),
      sights: sights_of(columns, p.sights, texts),
    })),
    missiles: document.missiles.map((m): Missile => ({ ...m, active: m.active ?? NaN, motion: motion_of(columns, m.motion) })),
    trees: document.trees.map(tree_of),
    shapes,
    platforms: document.platforms,
    texts,
    story: document.story,
  };
}

/** Of what src/page wrote. Throws an Error with words if it is of another format. */
export function decode(bytes: Uint8Array): Run {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const document = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as Document;
  return run_of(document, new Columns(bytes.subarray(4 + length)));
}
