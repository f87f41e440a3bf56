// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot works out in his head: where things are, and where to point to meet them.
#include <optional>

#include "core/angle.hpp"
#include "core/vec.hpp"
#include "model/kinematics.hpp"

namespace eyrie::pilot {

/// m; mean radius of the Earth (R1 of WGS-84), for the drop of the horizon only.
inline constexpr double kEarthRadius = 6371008.8;

/// A vector of the scenario's local frame in the north-east-down axes at the ownship.
[[nodiscard]] constexpr Vec3 to_ned(const model::Kinematics& own, const Vec3& local) {
  return {dot(own.north, local), dot(own.east, local), dot(own.down, local)};
}
/// And back.
[[nodiscard]] constexpr Vec3 from_ned(const model::Kinematics& own, const Vec3& ned) {
  return ned.x * own.north + ned.y * own.east + ned.z * own.down;
}

/// True bearing in (-pi, pi] of a NED vector; 0 if it has no horizontal part.
[[nodiscard]] inline double bearing_of(const Vec3& ned) {
  return wrap_pi(math::atan2(ned.y, ned.x));
}
/// Angle above the horizontal, rad in [-pi/2, pi/2].
[[nodiscard]] inline double elevation_of(const Vec3& ned) {
  return math::atan2(-ned.z, std::sqrt(ned.x * ned.x + ned.y * ned.y));
}

/// m above the ellipsoid of a place `ned` metres away from the ownship. The Earth curves away below
/// the tangent plane by d2 / 2R: 0.5 m at 2.5 km, 970 m at 60 nmi.
[[nodiscard]] inline double altitude_of(const model::Kinematics& own, const Vec3& ned) {
  return own.altitude - ned.z + (ned.x * ned.x + ned.y * ned.y) / (2 * kEarthRadius);
}

/// Unit vector of the nose in NED axes; the velocity through the air points there too.
[[nodiscard]] inline Vec3 nose_of(const model::Kinematics& own) {
  const auto heading = math::sin_cos(own.heading);
  const auto pitch = math::sin_cos(own.pitch);
  return {pitch.cos * heading.cos, pitch.cos * heading.sin, -pitch.sin};
}

/// Seconds until something that moves at `speed` from the origin, straight, can be where something
/// that starts at `offset` and keeps `velocity` will be; nothing if it can never be there.
/// The collision triangle |offset + velocity t| = speed t: Shneydor, Missile Guidance and Pursuit
/// (1998), ch. 4, parallel navigation. The smaller positive root of
/// (v2 - speed2) t2 + 2 (offset . v) t + offset2 = 0, in the form that never cancels.
[[nodiscard]] inline std::optional<double> time_to_meet(const Vec3& offset, const Vec3& velocity,
                                                        double speed) {
  const double a = norm2(velocity) - speed * speed;
  const double b = dot(offset, velocity);
  const double c = norm2(offset);
  const double square = b * b - a * c;
  if (!(square >= 0))
    return std::nullopt;
  const double divisor = std::sqrt(square) - b;
  if (!(divisor > 1e-9 * (1 + std::fabs(b))))
    return std::nullopt;
  return c / divisor;
}

}  // namespace eyrie::pilot
