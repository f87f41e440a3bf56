// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: players over a flat piece of Earth, and the mirror image of a scene.
#include "core/math.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model::test {

inline constexpr double kHigh = -6096;  ///< m, local z of 20 000 ft
inline constexpr double kMile = 1852;   ///< m

/// Flies level or as pitched, at `speed` along its nose, over local axes that are north-east-down.
inline Kinematics flying(const Vec3& position, double heading, double speed, double pitch = 0,
                         double roll = 0) {
  Kinematics k;
  k.position = position;
  k.north = {1, 0, 0};
  k.east = {0, 1, 0};
  k.down = {0, 0, 1};
  k.altitude = -position.z;
  k.heading = heading;
  k.pitch = pitch;
  k.roll = roll;
  k.speed = speed;
  const auto [sh, ch] = math::sin_cos(heading);
  const auto [sp, cp] = math::sin_cos(pitch);
  k.velocity = speed * Vec3{cp * ch, cp * sh, -sp};
  return k;
}

inline Vec3 mirrored(const Vec3& v) {
  return {v.x, -v.y, v.z};
}

/// The same scene with east and west exchanged.
inline Kinematics mirrored(const Kinematics& k) {
  Kinematics m = k;
  m.position = mirrored(k.position);
  m.velocity = mirrored(k.velocity);
  m.heading = -k.heading;
  m.roll = -k.roll;
  return m;
}

}  // namespace eyrie::model::test
