// SPDX-License-Identifier: MIT
/** Numbers and times as the page writes them: as the terminal does. */

/** "05:48.2" */
export function clock_text(time: number): string {
  const tenths = Math.floor(time * 10 + 0.5);
  const minutes = Math.floor(tenths / 600);
  const seconds = Math.floor(tenths / 10) % 60;
  return `${String(minutes).padStart(2, '0')}:${String(seconds).padStart(2, '0')}.${tenths % 10}`;
}

/** "5:48" for axes; with tenths where the ticks are closer than a second. */
export function tick_text(time: number, step: number): string {
  const text = clock_text(time).replace(/^0(?=\d)/, '');
  return step < 1 ? text : text.replace(/\.\d$/, '');
}

/** At least 1 digit, no trailing zeros: "40", "0.75". */
export function number_text(value: number, digits = 2): string {
  return String(Number(value.toFixed(digits)));
}

/** "1,234" */
export function count_text(value: number): string {
  return value.toLocaleString('en-US');
}

export const kFeet = 0.3048;
export const kNauticalMile = 1852;
export const kKnot = 1852 / 3600;
export const kPound = 0.45359237;
