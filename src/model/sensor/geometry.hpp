// SPDX-License-Identifier: MIT
#pragma once
/// \file  Axes and lines of sight that all sensors share.
#include "core/math.hpp"
#include "core/vec.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model {

/// Three orthonormal axes in the local frame.
struct Axes {
  Vec3 forward{1, 0, 0}, right{0, 1, 0}, down{0, 0, 1};
};

/// Nose, right wing and belly of a player. Stevens, Lewis & Johnson, Aircraft Control and
/// Simulation, 3rd ed., eq. 1.3-20 (3-2-1 Euler angles).
[[nodiscard]] Axes body_axes(const Kinematics& k);

/// The level axes at a player, turned by `heading` (rad, true).
[[nodiscard]] Axes level_axes(const Kinematics& k, double heading);

/// Where a direction of the local frame points to, seen from a player.
struct Bearing {
  double azimuth = 0;    ///< rad, true, clockwise from north, in (-pi, pi]
  double elevation = 0;  ///< rad, above the horizontal
};
[[nodiscard]] Bearing bearing_of(const Kinematics& from, const Vec3& unit);

/// A slant range (m) up to which two players at these altitudes (m above the ellipsoid) see each
/// other over a smooth sphere: the tangents of both to it. `earth_factor` scales the radius of the
/// Earth: 1 for the eye; 4/3 for radio waves, which bend with the air (Skolnik, Introduction to
/// Radar Systems, 3rd ed., sec. 8.2; Federal Standard 1037C, "radar line-of-sight equation").
/// Altitudes below zero count as zero.
[[nodiscard]] double horizon_range(double altitude_a, double altitude_b, double earth_factor);

inline constexpr double kRadioEarth = 4.0 / 3.0;
inline constexpr double kEarthRadius = 6371008.8;  ///< m, mean radius R1 of WGS-84 (Moritz 2000)

/// 0 below `low`, 1 above `high`, a cubic with level ends between.
[[nodiscard]] constexpr double smooth_step(double low, double high, double x) {
  if (x <= low)
    return 0;
  if (x >= high)
    return 1;
  const double t = (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

}  // namespace eyrie::model
