// SPDX-License-Identifier: MIT
/** Units in which people give the parameters that are about a field of the action. */
import type { ActionField } from '../run/run.ts';

export interface ShownUnit {
  /** As the program reads it; "" for none. */
  symbol: string;
  /** SI units in one. */
  factor: number;
}

const kPlain: ShownUnit = { symbol: '', factor: 1 };
/** By SI unit; the factors of src/core/units.hpp. */
const kShown: Record<string, ShownUnit> = {
  rad: { symbol: 'deg', factor: Math.PI / 180 },
  m: { symbol: 'ft', factor: 0.3048 },
  'm/s': { symbol: 'kt', factor: 1852 / 3600 },
};
/** Parameters of seconds. */
const kSeconds: ReadonlySet<string> = new Set(['min_time', 'hold']);

/** "bounds.altitude.min" in its parts; null: a parameter that is about no field. */
export function about_field(name: string): { group: string; field: string; part: string } | null {
  const [, group, field, part] = /^(bounds|grid)\.(.+)\.(\w+)$/.exec(name) ?? [];
  return group && field && part ? { group, field, part } : null;
}

/** It is about limits or a grid, which are given whole. */
export function is_grouped(name: string): boolean {
  return /^(bounds|grid)\./.test(name);
}

function field_measured(name: string, fields: readonly ActionField[]): ActionField | undefined {
  const about = about_field(name);
  return about && about.part !== 'steps' ? fields.find((f) => f.name === about.field) : undefined;
}

/** Of any parameter of an arbiter. */
export function unit_of(name: string, fields: readonly ActionField[]): ShownUnit {
  const field = field_measured(name, fields);
  if (field) return kShown[field.unit] ?? { symbol: field.unit, factor: 1 };
  return kSeconds.has(name) ? { symbol: 's', factor: 1 } : kPlain;
}

/** A parameter as it flew. */
export function flown_text(name: string, value: number | string, fields: readonly ActionField[]): string {
  if (typeof value === 'string') return value;
  const unit = unit_of(name, fields);
  return si_text(value, unit, field_measured(name, fields)?.unit ?? unit.symbol);
}

/** To the twelve digits that people may have written. */
export function to_shown(si: number, { factor }: ShownUnit): number {
  return Number((si / factor).toPrecision(12));
}

/** "8000 ft"; a number in SI that is no round one in the unit stays in SI. */
function si_text(si: number, unit: ShownUnit, si_symbol: string): string {
  const shown = to_shown(si, unit);
  const is_round = Math.abs(shown * unit.factor - si) <= 2 ** -51 * Math.abs(si);
  return is_round ? with_unit(shown, unit.symbol) : with_unit(si, si_symbol);
}

export function with_unit(value: string | number, symbol: string): string {
  return `${value}${symbol ? ` ${symbol}` : ''}`;
}
