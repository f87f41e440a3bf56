// SPDX-License-Identifier: MIT
/** Quantities over time for the strips, in the units people fly by. */
import { made } from '../made.ts';
import type { Player, Run } from '../run/run.ts';
import { size_of_unit, spoken, type Unit } from '../words/text.ts';

export type QuantityKey = 'altitude' | 'mach' | 'g' | 'fuel' | 'energy' | 'range' | 'closure' | 'vote';

export interface Quantity {
  key: QuantityKey;
  label: string;
  unit: () => Unit;
  digits: number;
  steps: boolean;  // Between two samples it stays what it was.
  least: number;  // Of the unit: a smaller span is not made larger.
  /** In SI. */
  of(run: Run, player: Player): Series | null;
}
export interface Series {
  t: Float64Array;
  v: Float64Array;
}

/** m/s^2 */
const kGravity = 9.80665;

function seen(run: Run, player: Player, name: string): Series | null {
  const field = run.platforms[player.kind].state.findIndex((f) => f.name === name);
  return field < 0 ? null : { t: player.sights.t, v: player.sights.channel(field) };
}
function flown({ motion }: Player, v: Float64Array): Series | null {
  return v.every(Number.isNaN) ? null : { t: motion.t, v };
}
const none = (): Unit => ['', 1];
const near = (): Unit => spoken().near;

export const kQuantities: Quantity[] = [
  { key: 'altitude', label: 'altitude', unit: near, digits: 0, steps: false, least: 500, of: (_, p) => (p.kind === 'vehicle' ? null : flown(p, p.motion.up)) },
  { key: 'mach', label: 'Mach', unit: none, digits: 2, steps: false, least: 0.1, of: (_, p) => flown(p, p.gauges.mach) },
  { key: 'g', label: 'load factor', unit: () => ['g', 1], digits: 1, steps: false, least: 1, of: (_, p) => flown(p, p.gauges.load_factor) },
  { key: 'fuel', label: 'fuel', unit: () => spoken().others['kg']!, digits: 0, steps: false, least: 100, of: (_, p) => flown(p, p.gauges.fuel) },
  {
    key: 'energy', label: 'energy height', unit: near, digits: 0, steps: false, least: 500,
    of: (_, p) => flown(p, p.motion.up.map((h, i) => h + p.gauges.speed[i]! ** 2 / (2 * kGravity))),
  },
  { key: 'range', label: 'range to target', unit: () => spoken().far, digits: 1, steps: false, least: 0.5, of: (run, p) => seen(run, p, 'range') },
  { key: 'closure', label: 'closure', unit: () => spoken().others['m/s']!, digits: 0, steps: false, least: 20, of: (run, p) => seen(run, p, 'closing') },
  {
    key: 'vote', label: 'vote of who leads', unit: none, digits: 0, steps: true, least: 10,
    of: (run, p) => ({ t: p.decisions.t, v: Float64Array.from(p.decisions.shape, (s) => run.shapes[s]!.vote[0]!) }),
  },
];

const kMade = new WeakMap<Player, Map<string, Series | null>>();

/** In the unit that people read, made once for each player; null if there is no such thing for it. */
export function series_of(run: Run, player: Player, quantity: Quantity): Series | null {
  const unit = quantity.unit();
  return made(made(kMade, player, () => new Map()), `${quantity.key} ${unit[0]}`, () => {
    const series = quantity.of(run, player);
    return !series || series.v.every(Number.isNaN) ? null : { t: series.t, v: series.v.map((x) => x / size_of_unit(unit)) };
  });
}

/** s: a gap in what was seen that is longer than this is drawn as one. */
const kGap = 5;

/** The values at the times of `grid`, null where there is none. */
export function resample({ t, v }: Series, grid: number[], steps: boolean, until: number): (number | null)[] {
  const out: (number | null)[] = [];
  let i = -1;
  for (const time of grid) {
    while (i + 1 < t.length && t[i + 1]! <= time + 1e-9) ++i;
    out.push(i < 0 || time > until + 1e-9 ? null : between(t, v, i, time, steps));
  }
  return out;
}

function between(t: Float64Array, v: Float64Array, i: number, time: number, steps: boolean): number | null {
  const a = v[i]!;
  if (Number.isNaN(a)) return null;
  const b = v[i + 1];
  if (steps || b === undefined || Number.isNaN(b)) return time - t[i]! > kGap && !steps ? null : a;
  const part = (time - t[i]!) / (t[i + 1]! - t[i]!);
  return a + (b - a) * part;
}
