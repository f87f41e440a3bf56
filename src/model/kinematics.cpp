// SPDX-License-Identifier: MIT
#include "model/kinematics.hpp"

#include <algorithm>

namespace eyrie::model {
namespace {

Vec3 from_ned(const Kinematics& k, double north, double east, double down) {
  return north * k.north + east * k.east + down * k.down;
}

double tangent_length(double altitude, double radius) {
  const double h = std::max(altitude, 0.0);
  return std::sqrt(h * (2 * radius + h));
}

}  // namespace

Axes body_axes(const Kinematics& k) {
  const auto [sh, ch] = math::sin_cos(k.heading);
  const auto [sp, cp] = math::sin_cos(k.pitch);
  const auto [sr, cr] = math::sin_cos(k.roll);
  return {from_ned(k, cp * ch, cp * sh, -sp),
          from_ned(k, sr * sp * ch - cr * sh, sr * sp * sh + cr * ch, sr * cp),
          from_ned(k, cr * sp * ch + sr * sh, cr * sp * sh - sr * ch, cr * cp)};
}

Axes level_axes(const Kinematics& k, double heading) {
  const auto [s, c] = math::sin_cos(heading);
  return {from_ned(k, c, s, 0), from_ned(k, -s, c, 0), k.down};
}

Bearing bearing_of(const Kinematics& from, const Vec3& unit) {
  return {math::atan2(dot(unit, from.east), dot(unit, from.north)),
          math::asin(std::clamp(-dot(unit, from.down), -1.0, 1.0))};
}

double horizon_range(double altitude_a, double altitude_b, double earth_factor) {
  const double radius = earth_factor * kEarthRadius;
  return tangent_length(altitude_a, radius) + tangent_length(altitude_b, radius);
}

}  // namespace eyrie::model
