// SPDX-License-Identifier: MIT
#include "model/attitude.hpp"

#include "core/math.hpp"

namespace eyrie::model {

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
  const auto [sb, cb] = math::sin_cos(euler.y);
  const auto [sc, cc] = math::sin_cos(euler.z);
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

}  // namespace eyrie::model
