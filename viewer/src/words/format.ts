// SPDX-License-Identifier: MIT
/** Numbers as the program writes them: {:.Nf} and {:g} of fmt, which round halves to even. */

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
