// SPDX-License-Identifier: MIT
/**
 * From the data of the page to a Run. src/page writes it, in the program or in the engine of the page:
 *
 *   u32 length of the document | document (JSON) | columns
 *
 * A column stands in the document as [offset, count, quantum, order] and in the columns as `count`
 * numbers, each a zigzag varint: the value over `quantum`, rounded, as its `order`-th difference. The
 * number kNothing stands for NaN, kNever for infinity.
 */
import type {
  Decisions, Flight, Gauges, Missile, Motion, Place, Player, Run, Shape, Sights, Status, Tree, TreeNode,
} from './run.ts';

const kFormat = 2;
const kNothing = -2147483648;
const kNever = 2147483647;

export type Column = [offset: number, count: number, quantum: number, order: number];
/** Of a column as it is packed, or kept otherwise (live/grown.ts). */
type Read<C> = (column: C) => Float64Array;
/** What a table of numbers is in the document. */
export type Packed<K extends string, C = Column> = Record<K, C>;

export function read_column(bytes: Uint8Array, [offset, count, quantum, order]: Column): Float64Array {
  const out = new Float64Array(count);
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
    slope += value;
    last = order === 2 ? last + slope : order === 1 ? last + value : value;
    out[i] = last === kNothing ? NaN : last === kNever ? Infinity : last * quantum;
  }
  return out;
}

export interface PlayerData<C = Column> extends Omit<Player, 'index' | 'motion' | 'gauges' | 'decisions' | 'sights'> {
  motion: Packed<keyof Motion, C>;
  gauges: Packed<keyof Gauges, C>;
  decisions: { step: C; shape: C; why_not: C; values: [node: number, field: number, column: C][] };
  sights: {
    t: C;
    state: C[];
    tracks: Packed<'count' | 'id' | 'truth' | 'identity' | 'target' | 'east' | 'north' | 'up' | 'age', C>;
    warnings: Packed<'count' | 'kind' | 'bearing' | 'range' | 'name', C>;
    scan: Packed<'mode' | 'azimuth' | 'elevation', C> | null;
    zone: Packed<'min' | 'no_escape' | 'max', C> | null;
  };
}
export interface MissileData<C = Column> extends Omit<Missile, 'active' | 'motion'> {
  active: number | null;
  motion: Packed<keyof Motion, C>;
}
export interface ShapeData extends Pick<Shape, 'tree' | 'leader' | 'vote'> {
  status: string;  // a letter a node: '-' not asked, F, S, R
  why: [node: number, text: number][];
  won: [field: number, winner: number, reason: number, rivals: [node: number, vote: number][]][];
  supplier: number[][];  // [node, supplier of field 0, of field 1, ...]; -2 - supplier: held from an earlier decision
}
export interface Document extends Pick<Run, 'about' | 'origin' | 'platforms' | 'texts' | 'stores' | 'story'> {
  format: number;
  flights: (Omit<Flight, 'route' | 'home'> & { route: (number | null)[][]; home: number[] | null })[];
  players: PlayerData[];
  missiles: MissileData[];
  trees: (Omit<Tree, 'nodes'> & { nodes: Omit<TreeNode, 'children'>[] })[];
  shapes: ShapeData[];
}

const kStatus: Record<string, Status | null> = { '-': null, F: 'failure', S: 'success', R: 'running' };
const kIdentities = ['unknown', 'friendly', 'hostile'] as const;
const kModes = ['off', 'search', 'track'] as const;

/** An object whose members are made when they are first asked for. */
function lazy<T extends object>(makers: { [K in keyof T]: () => T[K] }): T {
  const out = {} as T;
  for (const key of Object.keys(makers) as (keyof T)[]) {
    const get = (): T[keyof T] => {
      const value = makers[key]();
      Object.defineProperty(out, key, { value });
      return value;
    };
    Object.defineProperty(out, key, { enumerable: true, configurable: true, get });
  }
  return out;
}

function table<K extends string, C>(read: Read<C>, data: Packed<K, C>): Record<K, Float64Array> {
  const makers = Object.entries<C>(data).map(([key, column]) => [key, () => read(column)]);
  return lazy(Object.fromEntries(makers) as Record<K, () => Float64Array>);
}

function decisions_of<C>(read: Read<C>, data: PlayerData<C>['decisions'], shapes: Shape[], dt: number): Decisions {
  const own: Omit<Decisions, 'value'> = lazy({
    step: () => read(data.step),
    shape: () => Int32Array.from(read(data.shape)),
    why_not: () => Int32Array.from(read(data.why_not)),
    t: () => own.step.map((s) => s * dt),
  });
  // dense over the decisions in which the node set the field itself, or the root holds what nobody set this time
  const spread = (node: number, field: number, dense: Float64Array): Float64Array => {
    const sets = ({ supplier, held }: Shape): boolean => (held[node]?.[field] ? node === 0 : supplier[node]?.[field] === node);
    let next = 0;
    return Float64Array.from(own.shape, (s) => (sets(shapes[s]!) ? dense[next++]! : NaN));
  };
  const values = lazy<Record<string, Float64Array>>(Object.fromEntries(
    data.values.map(([node, field, column]) => [`${node}/${field}`, () => spread(node, field, read(column))])));
  return Object.assign(own, { value: (node: number, field: number) => values[`${node}/${field}`] ?? null });
}

/** Gives the rows of a table that belong to a sight, each made by `row`; `count` has how many they are. */
function rows_of<T>({ count }: { count: Float64Array }, row: (k: number) => T): (sight: number) => T[] {
  const first = new Int32Array(count.length + 1);
  count.forEach((n, i) => (first[i + 1] = first[i]! + n));
  return (i) => Array.from({ length: count[i]! }, (_, k) => row(first[i]! + k));
}

function sights_of<C>(read: Read<C>, data: PlayerData<C>['sights'], texts: string[]): Sights {
  const [c, w] = [table(read, data.tracks), table(read, data.warnings)];
  const scan = data.scan && table(read, data.scan);
  const zone = data.zone && table(read, data.zone);
  const rows = lazy({
    tracks: () => rows_of(c, (k) => ({
      id: c.id[k]!, truth: c.truth[k]!, identity: kIdentities[c.identity[k]!]!, is_target: c.target[k] === 1,
      place: { east: c.east[k]!, north: c.north[k]!, up: c.up[k]! }, age: c.age[k]!,
    })),
    warnings: () => rows_of(w, (k) => (
      { kind: texts[w.kind[k]!]!, bearing: w.bearing[k]!, range: w.range[k]!, name: texts[w.name[k]!]! })),
  });
  const state = lazy<Record<number, Float64Array>>(data.state.map((column) => () => read(column)));
  const own = lazy<Pick<Sights, 't'>>({ t: () => read(data.t) });
  return Object.assign(own, {
    channel: (field: number) => (state[field] ?? new Float64Array(0)).map((x) => (Number.isFinite(x) ? x : NaN)),
    at: (i: number) => ({
      t: own.t[i]!,
      state: Float64Array.from(data.state, (_, field) => state[field]![i]!),
      tracks: rows.tracks(i),
      warnings: rows.warnings(i),
      scan: scan && { mode: kModes[scan.mode[i]!]!, azimuth: scan.azimuth[i]!, elevation: scan.elevation[i]! },
      zone: zone && zone.max[i]! > 0 ? { min: zone.min[i]!, no_escape: zone.no_escape[i]!, max: zone.max[i]! } : null,
    }),
  });
}

export function shape_of(data: ShapeData, texts: string[]): Shape {
  const status = Array.from(data.status, (letter) => kStatus[letter] ?? null);
  const why = status.map(() => '');
  for (const [node, text] of data.why) why[node] = texts[text]!;
  const supplier: (Int16Array | null)[] = status.map(() => null);
  const held: (boolean[] | null)[] = status.map(() => null);
  for (const [node, ...fields] of data.supplier) {
    supplier[node!] = Int16Array.from(fields, (from) => (from <= -2 ? -2 - from : from));
    held[node!] = fields.map((from) => from <= -2);
  }
  const won = data.won.map(([field, winner, reason, rivals]) => (
    { field, winner, reason: texts[reason]!, rivals: rivals.map(([node, vote]) => ({ node, vote })) }));
  return { ...data, status, why, supplier, held, won };
}

function tree_of(data: Document['trees'][number]): Tree {
  const nodes: TreeNode[] = data.nodes.map((node) => ({ ...node, children: [] }));
  nodes.forEach((node, i) => nodes[node.parent]?.children.push(i));
  return { ...data, nodes };
}

function place_of([east, north, up]: (number | null)[]): Place {
  return { east: east!, north: north!, up: up! };
}

type Known = Pick<Run, 'about' | 'shapes' | 'texts'>;

export function player_of<C>(read: Read<C>, p: PlayerData<C>, index: number, { about, shapes, texts }: Known): Player {
  return {
    ...p,
    index,
    motion: table(read, p.motion),
    gauges: table(read, p.gauges),
    decisions: decisions_of(read, p.decisions, shapes, about.dt),
    sights: sights_of(read, p.sights, texts),
  };
}

export function missile_of<C>(read: Read<C>, m: MissileData<C>): Missile {
  return { ...m, active: m.active ?? NaN, motion: table(read, m.motion) };
}

/** The document and the bytes of its columns. */
export function taken_apart<D = Document>(bytes: Uint8Array): [D, Uint8Array] {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  return [JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as D, bytes.subarray(4 + length)];
}

/** Of what src/page wrote. Throws an Error with words if it is of another format. */
export function decode(bytes: Uint8Array): Run {
  const [document, columns] = taken_apart(bytes);
  const read = (column: Column): Float64Array => read_column(columns, column);
  if (document.format !== kFormat)
    throw new Error(`this page reads data of format ${kFormat}, and this run is of format ${document.format}`);
  const { about, texts } = document;
  const shapes = document.shapes.map((s) => shape_of(s, texts));
  return {
    ...document,
    flights: document.flights.map((f): Flight => (
      { ...f, route: f.route.map((stop) => ({ ...place_of(stop), speed: stop[3] ?? NaN })), home: f.home && place_of(f.home) })),
    players: document.players.map((p, index) => player_of(read, p, index, { about, shapes, texts })),
    missiles: document.missiles.map((m) => missile_of(read, m)),
    trees: document.trees.map(tree_of),
    shapes,
  };
}
