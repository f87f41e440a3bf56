// SPDX-License-Identifier: MIT
/** Values of fields in words, as the terminal writes them: src/debrief/values.hpp. */
import type { PlayerKind, Run } from '../run/run.ts';
import { fixed, general } from './format.ts';

/** What value_text needs of an ActionField or a StateField; only a field of the state has choices. */
export interface FieldInfo {
  name: string;
  unit: string;
  kind: string;
  choices?: string[];
}

interface AviationUnit {
  symbol: string;
  numerator: number;
  denominator: number;
  offset: number;
  decimals: number;
}

function unit(symbol: string, numerator: number, denominator = 1, decimals = 0, offset = 0): AviationUnit {
  return { symbol, numerator, denominator, offset, decimals };
}

/** The factors of src/core/units.hpp. */
const kFeet = unit('ft', 3048, 10000);
const kMiles = unit('nmi', 1852, 1, 1);
const kUnits: Record<string, AviationUnit> = {
  'm/s': unit('kt', 1852, 3600),
  'm/s2': unit('g', 980665, 100000, 1),
  rad: unit('deg', Math.PI / 180),
  'rad/s': unit('deg/s', Math.PI / 180, 1, 1),
  kg: unit('lb', 45359237, 1e8),
  'kg/s': unit('lb/h', 45359237, 3600e8),
  N: unit('lbf', 44482216152605, 1e13),
  Pa: unit('hPa', 100, 1, 1),
  K: unit('degC', 1, 1, 0, 273.15),
};

function in_unit(si: number, u: AviationUnit): string {
  const number = fixed(((si - u.offset) * u.denominator) / u.numerator, u.decimals);
  return `${/^-[0.]*$/.test(number) ? number.slice(1) : number} ${u.symbol}`;
}

function quantity(si: number, symbol: string): string {
  const u = symbol === 'm' ? (Math.abs(si) < 1852 ? kFeet : kMiles) : kUnits[symbol];
  if (u) return in_unit(si, u);
  const size = Math.abs(si);
  const number = size >= 100 && size < 1e9 ? fixed(si, 0) : general(si, 3);
  return symbol ? `${number} ${symbol}` : number;
}

/** "45 deg", "6000 ft", "467 kt"; "-" for no value. Heights are in feet however large they are. */
function number_text(field: FieldInfo, value: number): string {
  const is_height = field.name.includes('altitude') || field.name.includes('above');
  return is_height ? in_unit(value, kFeet) : quantity(value, field.unit);
}

/** A value in SI of a field of an action or of a state; NaN: not set. */
export function value_text(run: Run, _kind: PlayerKind, field: FieldInfo, value: number): string {
  const is_state = field.choices !== undefined;
  if (field.kind === 'flag' && is_state) return value === 1 ? 'yes' : 'no';
  if (Number.isNaN(value)) return '-';
  switch (field.kind) {
    case 'flag':
      return value ? 'true' : 'false';
    case 'text':
      return run.texts[value] ?? '-';
    case 'choice':
      return field.choices?.[value] ?? '-';
    case 'id':
      return value ? `#${value}` : 'nobody';
    default:
      return number_text(field, value);
  }
}
