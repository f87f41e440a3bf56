// SPDX-License-Identifier: MIT
/** The units that people read: those of aviation, or metric ones. One choice for the whole page. */

/** In SI as a fraction, then the decimals it is written with, and where it begins. */
export type Unit = readonly [symbol: string, numerator: number, denominator?: number, decimals?: number, offset?: number];

interface System {
  /** Of lengths: from one of the first on, that; below, and for heights, the other. */
  far: Unit;
  near: Unit;
  /** By unit of SI. */
  others: Readonly<Record<string, Unit>>;
}

const kBoth: Record<string, Unit> = {
  rad: ['°', Math.PI / 180], 'rad/s': ['°/s', Math.PI / 180, 1, 1], 'm/s2': ['g', 980665, 100000, 1], Pa: ['hPa', 100, 1, 1], K: ['°C', 1, 1, 0, 273.15],
};

/** As in src/core/units.cpp: tests/quantities.txt holds both to it. */
export const kSystems = {
  aviation: {
    far: ['nmi', 1852, 1, 1], near: ['ft', 3048, 10000],
    others: { ...kBoth, 'm/s': ['kt', 1852, 3600], kg: ['lb', 45359237, 1e8], 'kg/s': ['lb/h', 45359237, 3600e8], N: ['lbf', 44482216152605, 1e13] },
  },
  metric: {
    far: ['km', 1000, 1, 1], near: ['m', 1],
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
