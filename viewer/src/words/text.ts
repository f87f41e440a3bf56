// SPDX-License-Identifier: MIT
/** Values, numbers and times in words, as the terminal writes them: src/team/decision.hpp, and {:.Nf} and {:g} of fmt, which
 * round halves to even. */
import { last_at, type Player, type Run, type StateField } from '../run/run.ts';

// The units that people read: those of aviation, or metric ones. One choice for the whole page.

/** In SI as a fraction, then the decimals it is written with, and where it begins. */
export type Unit = readonly [symbol: string, numerator: number, denominator?: number, decimals?: number, offset?: number];

interface System {
  /** Of lengths: from one of the first on, that; below, and for heights, the other. */
  far: Unit;
  near: Unit;
  climb: Unit;  // Of speeds up and down.
  others: Readonly<Record<string, Unit>>;  // By unit of SI.
}

const kBoth: Record<string, Unit> = {
  rad: ['°', Math.PI / 180], 'rad/s': ['°/s', Math.PI / 180, 1, 1], 'm/s2': ['g', 980665, 100000, 1], Pa: ['hPa', 100, 1, 1], K: ['°C', 1, 1, 0, 273.15],
};

/** As in src/core/units.cpp: tests/quantities.txt holds both to it. */
const kSystems = {
  aviation: {
    far: ['nmi', 1852, 1, 1], near: ['ft', 3048, 10000], climb: ['ft/min', 3048, 600000],
    others: { ...kBoth, 'm/s': ['kt', 1852, 3600], kg: ['lb', 45359237, 1e8], 'kg/s': ['lb/h', 45359237, 3600e8], N: ['lbf', 44482216152605, 1e13] },
  },
  metric: {
    far: ['km', 1000, 1, 1], near: ['m', 1], climb: ['m/s', 1],
    others: { ...kBoth, 'm/s': ['km/h', 1000, 3600], kg: ['kg', 1], 'kg/s': ['kg/h', 1, 3600], N: ['kN', 1000] },
  },
} satisfies Record<string, System>;

let system: System = kSystems.aviation;

/** What is written from now on is in these. */
export function speak(units: keyof typeof kSystems): void {
  system = kSystems[units];
}
export function spoken(): System {
  return system;
}
/** How much of SI one of the unit is. */
export function size_of_unit([, numerator, denominator = 1]: Unit): number {
  return numerator / denominator;
}

/** What value_text needs of an ActionField or a StateField; only a field of the state has choices. */
export type FieldInfo = Pick<StateField, 'unit' | 'form'> & Partial<Pick<StateField, 'choices'>> & { kind: string };

function in_unit(si: number, [symbol, numerator, denominator = 1, decimals = 0, offset = 0]: Unit): string {
  const number = fixed(((si - offset) * denominator) / numerator, decimals);
  return `${/^-[0.]*$/.test(number) ? number.slice(1) : number}${symbol.startsWith('°') ? '' : ' '}${symbol}`;
}

/** "10.0 nmi", "467 kt", "45°", "5.29"; "-" for NaN. `unit` is that of SI. */
export function quantity_text(si: number, unit: string): string {
  if (Number.isNaN(si)) return '-';
  if (!Number.isFinite(si)) return 'never';
  const { far, near, others } = spoken();
  const u = unit === 'm' ? (Math.abs(si) < size_of_unit(far) ? near : far) : others[unit];
  if (u) return in_unit(si, u);
  const size = Math.abs(si);
  const number = size >= 100 && size < 1e9 ? fixed(si, 0) : general(si, 3);
  return unit ? `${number} ${unit}` : number;
}

/** "6000 ft" however large it is. */
export function height_text(m: number): string {
  return in_unit(m, spoken().near);
}

/** "087°": from north, always three digits from 000 to 359, as on the radio. */
export function heading_text(rad: number): string {
  const degrees = ((Math.round((rad * 180) / Math.PI) % 360) + 360) % 360;
  return `${String(degrees).padStart(3, '0')}°`;
}

/** "35° right": from the nose. */
export function side_text(rad: number): string {
  const turn = Math.atan2(Math.sin(rad), Math.cos(rad));
  const size = quantity_text(Math.abs(turn), 'rad');
  return size === '0°' || size === '180°' ? size : `${size} ${turn < 0 ? 'left' : 'right'}`;
}

/** How files and the engine write units: of which kind each is. */
const kWritten = new Map<string, [kind: string, unit: Unit]>(Object.values(kSystems).flatMap(({ others, ...own }) =>
  [...Object.entries({ ...own, ...others, rad: ['deg', Math.PI / 180] as const, 'rad/s': ['deg/s', Math.PI / 180] as const }),
    ...['m/s', 'm/s2', 'rad', 'rad/s'].map((si): [string, Unit] => [si, [si, 1]])]
    .map(([kind, unit]): [string, [string, Unit]] => [unit[0], [kind, unit]])));
const kQuantity = new RegExp(`(\\d+(?:\\.\\d+)?) (${[...kWritten.keys()].join('|')})(?![\\w/])`, 'g');

/** Words of the engine, and of files, in the units that people read. */
export function reworded(text: string): string {
  const { others, ...own } = spoken();
  const spoken_of: Readonly<Record<string, Unit>> = { ...own, ...others };
  return text.replace(kQuantity, (said, number: string, symbol: string) => {
    const [kind, unit] = kWritten.get(symbol)!;
    const wanted = spoken_of[kind]!;
    return wanted[0] === symbol ? said : in_unit(Number(number) * size_of_unit(unit), wanted);
  });
}

/** A value in SI of a field of an action or of a state; NaN: not set. */
export function value_text(run: Run, { unit, form, kind, choices }: FieldInfo, value: number): string {
  if (kind === 'flag' && choices) return value === 1 ? 'yes' : 'no';
  if (Number.isNaN(value)) return '-';
  if (!Number.isFinite(value)) return 'never';
  switch (kind) {
    case 'flag':
      return value ? 'true' : 'false';
    case 'text':
      return reworded(run.texts[value] ?? '-');
    case 'choice':
      return choices?.[value] ?? '-';
    case 'id':
      return value ? `#${value}` : 'nobody';
  }
  switch (form) {
    case 'direction':
      return heading_text(value);
    case 'climb':
      return in_unit(value, spoken().climb);
    case 'height':
      return height_text(value);
    default:
      return quantity_text(value, unit);
  }
}

/** A value of an action of a player at a time (s): stores and tracks by name, and who a track really was. */
export function told_text(run: Run, player: Player, time: number, field: FieldInfo, value: number): string {
  const text = value_text(run, field, value).replace(/^store (\d+)(?= at #)/, (_, store: string) => run.stores[Number(store)] ?? '?');
  const number = /#(\d+)$/.exec(text)?.[1];
  const sight = number ? last_at(player.sights.t, time) : -1;
  const track = sight < 0 ? undefined : player.sights.at(sight).tracks.find(({ id }) => id === Number(number));
  const truth = track && run.players[track.truth];
  return truth ? `${text} (${truth.name})` : text;
}

/** As {:.Nf}. JavaScript's own toFixed rounds an exact half up. */
export function fixed(x: number, decimals: number): string {
  const size = Math.abs(x);
  const twice = size * 2 ** (decimals + 1); // exact: an odd integer just if x lies halfway
  if (!(Number.isInteger(twice) && twice % 2 === 1)) return x.toFixed(decimals);
  const below = Math.floor(size * 10 ** decimals);
  const even = below % 2 === 0 ? below : below + 1;
  return `${x < 0 ? '-' : ''}${(even / 10 ** decimals).toFixed(decimals)}`;
}

/** As {:g}, or {:.3g} with three digits. */
export function general(x: number, digits = 6): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'nan' : x < 0 ? '-inf' : 'inf';
  if (x === 0) return '0';
  const [mantissa, power] = x.toExponential(digits - 1).split('e') as [string, string];
  const exponent = Number(power);
  if (exponent >= -4 && exponent < digits) return without_zeros(fixed(x, digits - 1 - exponent));
  const size = String(Math.abs(exponent)).padStart(2, '0');
  return `${without_zeros(mantissa)}e${exponent < 0 ? '-' : '+'}${size}`;
}

function without_zeros(text: string): string {
  return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

/** "05:48.2" */
export function clock_text(time: number): string {
  const tenths = Math.floor(time * 10 + 0.5);
  const minutes = Math.floor(tenths / 600);
  const seconds = Math.floor(tenths / 10) % 60;
  return `${String(minutes).padStart(2, '0')}:${String(seconds).padStart(2, '0')}.${tenths % 10}`;
}

/** s of "8:20.5", "08:20" or "500.5" in a run of so many s; or in words why there is no such time. */
export function read_clock(text: string, end: number): number | string {
  const [found, minutes, rest] = /^(?:(\d+):)?(\d+(?:\.\d*)?)\s*s?$/.exec(text.trim()) ?? [];
  if (!found) return 'not a time such as 8:20.5 or 500.5';
  if (minutes && Number(rest) >= 60) return 'a minute has 60 seconds';
  const time = 60 * Number(minutes ?? 0) + Number(rest);
  return time > end + 0.1 ? `it ends at ${clock_text(end)}` : time;
}

/** A vote as files have it, or in words why it is none. */
export function read_vote(text: string): number | string {
  const vote = /^\+?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text.trim()) ? Number(text) : NaN;
  return vote <= 1000 ? vote : `'${text.trim()}' is no vote from 0 to 1000, such as 40 or 12.5`;
}

/** "5:48" for axes; with tenths where the ticks are closer than a second. */
export function tick_text(time: number, step: number): string {
  const text = clock_text(time).replace(/^0(?=\d)/, '');
  return step < 1 ? text : text.replace(/\.\d$/, '');
}

/** Why a mission was over, of src/scenario/mission.hpp: "blue home", "time is up". */
export function outcome_text(outcome: string): string {
  return outcome === 'time' ? 'time is up' : outcome.replaceAll('_', ' ');
}

/** At least 1 digit, no trailing zeros: "40", "0.75". */
export function number_text(value: number, digits = 2): string {
  return String(Number(value.toFixed(digits)));
}

/** "1,234" */
export function count_text(value: number): string {
  return value.toLocaleString('en-US');
}
