// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where two players that move in straight lines during a step come closest.
#include <algorithm>

#include "core/vec.hpp"

namespace eyrie::model::weapon {

/// The nearest point of a relative motion.
struct ClosestApproach {
  double time = 0;      ///< s, after the instant that the positions are given for
  double distance = 0;  ///< m
  Vec3 separation;      ///< m, other minus own at that time
};

/// Exact for linear motion over [begin, end] (s): the minimum of |r + v t| lies at
/// t = -(r . v) / (v . v), clamped to the interval.
[[nodiscard]] inline ClosestApproach closest_approach(const Vec3& relative_position,
                                                      const Vec3& relative_velocity, double begin,
                                                      double end) {
  const double speed2 = norm2(relative_velocity);
  const double free = speed2 > 1e-12 ? -dot(relative_position, relative_velocity) / speed2 : begin;
  const double time = std::clamp(free, begin, end);
  const Vec3 separation = relative_position + time * relative_velocity;
  return {.time = time, .distance = norm(separation), .separation = separation};
}

}  // namespace eyrie::model::weapon
