// SPDX-License-Identifier: MIT
/** What colour a face of a model has in the light, as a renderer that knows of light in linear shares makes it. */
import { kDiffuse, kGround, kSky, kSun, kSunlight } from '../light.ts';
import { css, shares } from '../palette.ts';

const kLevels = 24;
/** What is brighter is white already. */
const kBrightest = (kDiffuse + kSunlight) / Math.PI;

function to_linear(share: number): number {
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}
function to_screen(light: number): number {
  const share = Math.min(1, light <= 0.0031308 ? light * 12.92 : 1.055 * light ** (1 / 2.4) - 0.055);
  return Math.round(share * 255);
}
function grey_of(tint: number): number {
  return shares(tint).reduce((sum, share) => sum + to_linear(share), 0) / 3;
}

const sky = grey_of(kSky);
const ground = grey_of(kGround);
const sun_length = Math.hypot(...kSun);

/** The level of light on a face with that normal. */
export function level_of(x: number, y: number, z: number): number {
  const above = 0.5 + 0.5 * y;
  const sun = Math.max(0, (x * kSun[0] + y * kSun[1] + z * kSun[2]) / sun_length);
  const light = (kDiffuse * (ground + (sky - ground) * above) + kSunlight * sun) / Math.PI;
  return Math.min(kLevels, Math.round((light / kBrightest) * kLevels));
}

const shades = new Map<number, string[]>();

/** Of a colour at each level. */
export function shades_of(tint: number): string[] {
  let all = shades.get(tint);
  if (!all) {
    const linear = shares(tint).map(to_linear);
    all = Array.from({ length: kLevels + 1 }, (_, level) => {
      const [r, g, b] = linear.map((share) => to_screen((share * level * kBrightest) / kLevels)) as [number, number, number];
      return css((r << 16) | (g << 8) | b);
    });
    shades.set(tint, all);
  }
  return all;
}
