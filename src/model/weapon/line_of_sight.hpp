// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one player sees of another: direction, how fast it turns, range and closing speed.
#include "core/vec.hpp"

namespace eyrie::model::weapon {

/// Geometry of a relative position and velocity; rates are exact for the instant.
struct LineOfSight {
  Vec3 direction{1, 0, 0};  ///< unit vector from the observer to the other
  Vec3 rate;                ///< rad/s, angular velocity of `direction`, perpendicular to it
  double range = 0;         ///< m
  double closing = 0;       ///< m/s, positive when the range shrinks
};

/// `relative_position` and `relative_velocity` are other minus observer, m and m/s, any one frame.
/// rate = r x v / r^2 (Zarchan, Tactical and Strategic Missile Guidance, 6th ed., ch. 2). At no
/// distance the direction is the x axis and nothing turns.
[[nodiscard]] inline LineOfSight line_of_sight(const Vec3& relative_position,
                                               const Vec3& relative_velocity) {
  const Vec3& r = relative_position;
  const Vec3& v = relative_velocity;
  const double range2 = norm2(r);
  if (!(range2 > 1e-12))
    return {};
  const double range = std::sqrt(range2);
  const double a = 1 / range, b = 1 / range2;
  // built in place: copies of freshly written vectors stall the processor
  return {.direction = {a * r.x, a * r.y, a * r.z},
          .rate = {b * (r.y * v.z - r.z * v.y), b * (r.z * v.x - r.x * v.z),
                   b * (r.x * v.y - r.y * v.x)},
          .range = range,
          .closing = -a * dot(r, v)};
}

/// Proportional navigation: the acceleration (m/s^2) perpendicular to the line of sight that turns
/// it back, N times a speed times its rate. With the closing speed it is true proportional
/// navigation (Zarchan, eq. 2.1: n_c = N' V_c dl/dt), with the own speed the pure form.
[[nodiscard]] inline Vec3 proportional_navigation(double gain, double speed,
                                                  const LineOfSight& los) {
  return gain * speed * cross(los.rate, los.direction);
}

/// The part of `v` perpendicular to the unit vector `axis`.
[[nodiscard]] constexpr Vec3 perpendicular(const Vec3& v, const Vec3& axis) {
  return v - dot(v, axis) * axis;
}

/// `v` shortened to the length `limit` if it is longer.
[[nodiscard]] inline Vec3 limited(const Vec3& v, double limit) {
  const double length2 = norm2(v);
  return length2 > limit * limit ? v * (limit / std::sqrt(length2)) : v;
}

}  // namespace eyrie::model::weapon
