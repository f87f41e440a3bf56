// SPDX-License-Identifier: MIT
/** How the models are lit: by the sky from above, by the ground from below, and by a sun. */

export const kSky = 0xffffff;
export const kGround = 0x56606b;
/** Of sky and ground. */
export const kDiffuse = 1.6;
export const kSunlight = 1.9;
/** To the sun, in the scene. */
export const kSun = [-0.6, 1, 0.5] as const;
