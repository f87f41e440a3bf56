// SPDX-License-Identifier: MIT
/** Quantities over time for the strips, in the units people fly by. */
import type { Player, Run } from '../run/run.ts';

export type QuantityKey = 'altitude' | 'mach' | 'g' | 'fuel' | 'energy' | 'range' | 'closure' | 'vote';

export interface Quantity {
  key: QuantityKey;
  label: string;
  unit: string;
  digits: number;
  steps: boolean;  // Between two samples it stays what it was.
  of(run: Run, player: Player): Series | null;
}
export interface Series {
  t: Float64Array;
  v: Float64Array;
}

/** m/s^2; and what a foot, a nautical mile, a knot and a pound are in SI. */
const kGravity = 9.80665;
const [kFoot, kMile, kKnot, kPound] = [0.3048, 1852, 1852 / 3600, 0.45359237] as const;

function seen(run: Run, player: Player, name: string, unit: number): Series | null {
  const field = run.platforms[player.kind].state.findIndex((f) => f.name === name);
  if (field < 0) return null;
  return { t: player.sights.t, v: player.sights.channel(field).map((x) => x / unit) };
}
function flown(player: Player, values: Float64Array, unit: number): Series | null {
  return values.every(Number.isNaN) ? null : { t: player.motion.t, v: values.map((x) => x / unit) };
}

export const kQuantities: Quantity[] = [
  { key: 'altitude', label: 'altitude', unit: 'ft', digits: 0, steps: false, of: (_, p) => flown(p, p.motion.up, kFoot) },
  { key: 'mach', label: 'Mach', unit: '', digits: 2, steps: false, of: (_, p) => flown(p, p.gauges.mach, 1) },
  { key: 'g', label: 'load factor', unit: 'g', digits: 1, steps: false, of: (_, p) => flown(p, p.gauges.load_factor, 1) },
  { key: 'fuel', label: 'fuel', unit: 'lb', digits: 0, steps: false, of: (_, p) => flown(p, p.gauges.fuel, kPound) },
  {
    key: 'energy', label: 'energy height', unit: 'ft', digits: 0, steps: false,
    of: (_, p) => flown(p, p.motion.up.map((h, i) => h + p.gauges.speed[i]! ** 2 / (2 * kGravity)), kFoot),
  },
  { key: 'range', label: 'range to target', unit: 'nmi', digits: 1, steps: false, of: (run, p) => seen(run, p, 'range', kMile) },
  { key: 'closure', label: 'closure', unit: 'kt', digits: 0, steps: false, of: (run, p) => seen(run, p, 'closing', kKnot) },
  {
    key: 'vote', label: 'vote of who leads', unit: '', digits: 0, steps: true,
    of: (run, p) => ({ t: p.decisions.t, v: Float64Array.from(p.decisions.shape, (s) => run.shapes[s]!.vote[0]!) }),
  },
];

const kMade = new WeakMap<Player, Map<QuantityKey, Series | null>>();

/** Made once for each player; null if there is no such thing for it. */
export function series_of(run: Run, player: Player, quantity: Quantity): Series | null {
  let made = kMade.get(player);
  if (!made) kMade.set(player, (made = new Map()));
  let series = made.get(quantity.key);
  if (series === undefined) made.set(quantity.key, (series = quantity.of(run, player)));
  return series;
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
