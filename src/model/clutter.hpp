// SPDX-License-Identifier: MIT
#pragma once
/// \file  The echo of the ground behind a target that a radar looks down on.
#include <algorithm>
#include <cmath>

namespace eyrie::model {

/// Of flat land, -20 dB: the ground scatters gamma times the sine of the grazing angle per area
/// (Barton, Proc. IEEE 73 (1985) 198, as the documentation of MathWorks' surfaceReflectivity has
/// it; farmland and woods scatter more, a calm sea less).
inline constexpr double kGroundGamma = 0.01;

/// Where a radar looks down on a target.
struct LookDown {
  double altitude = 0;  ///< m, of the radar above the ground
  double sine = 0;      ///< of the angle of the line of sight below the horizontal
  double beam = 0;      ///< rad, width
  double cell = 0;      ///< m, width of its range cell
};

/// m^2: what one range cell holds of the ground, R_g beam cell / cos (Skolnik, Introduction to
/// Radar Systems, 3rd ed., ch. 7; not seen), no longer than the beam's footprint, over R_g^4, the
/// range of that ground to the fourth power. Flat Earth.
[[nodiscard]] inline double clutter_at(const LookDown& look) {
  const double ground = look.altitude / look.sine;
  const double cosine = std::sqrt(std::max(1 - look.sine * look.sine, 0.0));
  const double footprint = ground * look.beam / look.sine;
  const double length = look.cell < cosine * footprint ? look.cell / cosine : footprint;
  const double ground2 = ground * ground;
  return kGroundGamma * look.sine * ground * look.beam * length / (ground2 * ground2);
}

/// Echo of a cross section (m^2) at `range` (m) over that of the ground behind it. The radar sends
/// so many pulses that the ground, farther away along the beam, answers in the same range cell. The
/// stronger counts of what the middle of the beam meets, and its lower edge, 6 dB down both ways.
[[nodiscard]] inline double signal_to_clutter(const LookDown& look, double section, double range) {
  if (look.altitude <= 0 || look.sine <= 0)
    return 0;
  LookDown edge = look;
  edge.sine = std::min(look.sine + look.beam / 2, 1.0);
  const double clutter = std::max(clutter_at(look), clutter_at(edge) / 4);
  const double range2 = range * range;
  return section / (range2 * range2 * std::max(clutter, 1e-30));
}

}  // namespace eyrie::model
