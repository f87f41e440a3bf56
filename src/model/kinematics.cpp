// SPDX-License-Identifier: MIT
#include "model/kinematics.hpp"

#include <algorithm>

namespace eyrie::model {
namespace {

double tangent_length(double altitude, double radius) {
  const double h = std::max(altitude, 0.0);
  return std::sqrt(h * (2 * radius + h));
}

}  // namespace

Mat3 turn(const Vec3& spin, double time) {
  const double rate = norm(spin);
  if (rate * std::fabs(time) < 1e-12)
    return {};
  const auto [s, c] = math::sin_cos(rate * time);
  const Vec3 n = spin / rate;
  const auto row = [&](const Vec3& axis) {  // of (1 - c) n n^T + c I - s [n x]
    return (1 - c) * dot(n, axis) * n + c * axis - s * cross(axis, n);
  };
  return {row({1, 0, 0}), row({0, 1, 0}), row({0, 0, 1})};
}

Mat3 attitude_of(const Vec3& euler) {
  const auto [sa, ca] = math::sin_cos(euler.x);
  const auto [b, c] = math::sin_cos(euler.y, euler.z);
  const auto [sb, cb] = b;
  const auto [sc, cc] = c;
  return {{cb * ca, cb * sa, -sb},
          {sc * sb * ca - cc * sa, sc * sb * sa + cc * ca, sc * cb},
          {cc * sb * ca + sc * sa, cc * sb * sa - sc * ca, cc * cb}};
}

Vec3 euler_of(const Mat3& attitude) {
  const Vec3 &forward = attitude.row_x, &right = attitude.row_y, &down = attitude.row_z;
  const double level = std::sqrt(forward.x * forward.x + forward.y * forward.y);
  if (level < 1e-9)  // along the Earth's axis: the other two angles are one
    return {math::atan2(-right.x, right.y), math::atan2(-forward.z, level), 0};
  return {math::atan2(forward.y, forward.x), math::atan2(-forward.z, level),
          math::atan2(right.z, down.z)};
}

Axes body_axes(const Kinematics& k) {
  const Mat3 in_ned = attitude_of({k.heading, k.pitch, k.roll});
  return {from_ned(k, in_ned.row_x), from_ned(k, in_ned.row_y), from_ned(k, in_ned.row_z)};
}

Axes level_axes(const Kinematics& k, double heading) {
  const auto [s, c] = math::sin_cos(heading);
  return {from_ned(k, {c, s, 0}), from_ned(k, {-s, c, 0}), k.down};
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
