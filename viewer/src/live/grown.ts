// SPDX-License-Identifier: MIT
/** A run that grows while it is flown: what the engine draws with each advance() is put behind what there is. Arrays of the run are views
 * of buffers that only grow, so what was read before stays as it was; players and missiles are new objects when there is more of them. */
import {
  decode, missile_of, player_of, read_column, shape_of, taken_apart,
  type Column, type Document, type MissileData, type Packed, type PlayerData,
} from '../run/decode.ts';
import type { Gauges, Motion, Run } from '../run/run.ts';

const kMotion = ['t', 'east', 'north', 'up', 'heading', 'pitch', 'roll'] as const satisfies readonly (keyof Motion)[];
const kGauges = ['speed', 'mach', 'load_factor', 'fuel'] as const satisfies readonly (keyof Gauges)[];

/** A column with room for more, and maybe one number that holds until the next comes. */
export class Growing {
  private buffer = new Float64Array(16);
  private length = 0;
  private more = 0;

  add(values: Float64Array): void {
    this.reserve(this.length + values.length);
    this.buffer.set(values, this.length);
    this.length += values.length;
    this.more = 0;
  }
  now(value: number | null): void {
    this.reserve(this.length + 1);
    this.buffer[this.length] = value ?? NaN;
    this.more = 1;
  }
  get last(): number {
    return this.length ? this.buffer[this.length - 1]! : -Infinity;
  }
  read(): Float64Array {
    return this.buffer.subarray(0, this.length + this.more);
  }
  private reserve(length: number): void {
    if (length <= this.buffer.length) return;
    const wider = new Float64Array(2 * length);
    wider.set(this.buffer.subarray(0, this.length));
    this.buffer = wider;
  }
}
const read = (column: Growing): Float64Array => column.read();

/** As Packer::take() writes it. */
interface Part extends Omit<Document, 'players'> {
  players: (Omit<PlayerData, 'decisions' | 'sights'> & { decisions: PlayerData['decisions'] | null; sights: PlayerData['sights'] | null })[];
  now: { players: (number[] | null)[]; missiles: number[][] };
}
type Table<K extends string> = Packed<K, Growing>;
type Rest<T extends string> = Partial<Table<T>>;

/** Puts columns behind those of the same name, which are made if there are none. */
function put<K extends string>(at: Rest<K>, from: Packed<K>, bytes: Uint8Array): Table<K> {
  for (const key of Object.keys(from) as K[]) (at[key] ??= new Growing()).add(read_column(bytes, from[key]));
  return at as Table<K>;
}

/** Where it is now, behind its samples, until the next one. */
function stand<K extends string>(at: Table<K>, keys: readonly K[], values: (number | null)[]): void {
  keys.forEach((key, i) => at[key].now(values[i]!));
}

type Held = PlayerData<Growing> & { pairs: Map<string, Growing> };

export class GrownRun {
  readonly run: Run;  // The same object all the time.
  private readonly players: Held[] = [];
  private readonly missiles = new Map<number, { place: number; data: MissileData<Growing> }>();

  /** Of the first that was drawn, which has all of the scenario in it. */
  constructor(bytes: Uint8Array, engine: Run['engine']) {
    const { players, ...whole } = decode(bytes);
    this.run = { ...whole, players: [], missiles: [], shapes: [], texts: [], story: [], ...(engine && { engine }) };
    this.add(bytes);
  }

  /** Everything that was drawn since. */
  add(bytes: Uint8Array): void {
    const [part, columns] = taken_apart<Part>(bytes);
    const { run } = this;
    Object.assign(run.about, part.about);  // pages have copies of the run, which hold it
    run.texts.push(...part.texts);
    run.story.push(...part.story);
    for (const shape of part.shapes) run.shapes.push(shape_of(shape, run.texts));
    part.players.forEach((player, i) => this.add_player(player, i, columns, part.now.players[i] ?? null));
    for (const missile of part.missiles) this.add_missile(missile, columns);
    for (const [id, ...motion] of part.now.missiles) {
      const held = this.missiles.get(id!);
      if (held && motion[0]! > held.data.motion.t.last) stand(held.data.motion, kMotion, motion);
    }
    for (const { place, data } of this.missiles.values()) if (data.end === 'flying' || !run.missiles[place] || run.missiles[place].end === 'flying')
      run.missiles[place] = missile_of(read, { ...data, gone: data.end === 'flying' ? run.about.duration : data.gone });
  }

  private add_player(part: Part['players'][number], i: number, columns: Uint8Array, now: number[] | null): void {
    const before = this.players[i];
    const held: Held = { ...(before ?? { pairs: new Map<string, Growing>() }), ...part } as unknown as Held;
    held.motion = put(before?.motion ?? {}, part.motion, columns);
    held.gauges = put(before?.gauges ?? {}, part.gauges, columns);
    held.decisions = before?.decisions ?? { step: new Growing(), shape: new Growing(), why_not: new Growing(), values: [] };
    held.sights = before?.sights ?? { t: new Growing(), state: [], tracks: {} as never, warnings: {} as never, scan: null, zone: null };
    if (part.decisions) this.add_decisions(held, part.decisions, columns);
    if (part.sights) this.add_sights(held, part.sights, columns);
    if (now && now[0]! > held.motion.t.last) {
      stand(held.motion, kMotion, now);
      stand(held.gauges, kGauges, now.slice(kMotion.length));
    }
    // what is there is there until now, to the last bit
    if (!held.end) held.gone = Math.max(held.gone, this.run.about.duration);
    this.players[i] = held;
    this.run.players[i] = player_of(read, held, i, this.run);
  }

  private add_decisions(held: Held, part: NonNullable<Part['players'][number]['decisions']>, columns: Uint8Array): void {
    held.decisions.step.add(read_column(columns, part.step));
    held.decisions.shape.add(read_column(columns, part.shape));
    held.decisions.why_not.add(read_column(columns, part.why_not));
    for (const [node, field, column] of part.values) {
      const key = `${node}/${field}`;
      let pair = held.pairs.get(key);
      if (!pair) {
        held.pairs.set(key, (pair = new Growing()));
        held.decisions.values.push([node, field, pair]);
      }
      pair.add(read_column(columns, column));
    }
  }

  private add_sights({ sights }: Held, part: NonNullable<Part['players'][number]['sights']>, columns: Uint8Array): void {
    sights.t.add(read_column(columns, part.t));
    part.state.forEach((column: Column, field) => (sights.state[field] ??= new Growing()).add(read_column(columns, column)));
    sights.tracks = put(sights.tracks, part.tracks, columns);
    sights.warnings = put(sights.warnings, part.warnings, columns);
    if (part.scan) sights.scan = put(sights.scan ?? {}, part.scan, columns);
    if (part.zone) sights.zone = put(sights.zone ?? {}, part.zone, columns);
  }

  private add_missile(part: MissileData, columns: Uint8Array): void {
    const before = this.missiles.get(part.id);
    const data: MissileData<Growing> = { ...part, motion: put(before?.data.motion ?? {}, part.motion, columns) };
    this.missiles.set(part.id, { place: before?.place ?? this.missiles.size, data });
  }
}
