// SPDX-License-Identifier: MIT
#pragma once
/// \file  When a missile's proximity fuze fires, and what its warhead does then.
#include "core/math.hpp"
#include "core/vec.hpp"
#include "model/weapon/closest_approach.hpp"
#include "model/weapon/missile_type.hpp"

namespace eyrie::model::weapon {

/// The closest approach in the step of `dt` s that has just been made, from where both are now
/// (relative position, m) and how they move (relative velocity, m/s): time in [-dt, 0]. `passing`
/// if they have come closest in this step and now part; the step before may have ended a hair
/// earlier, because velocities change from step to step.
struct Passage {
  ClosestApproach nearest;
  bool passing = false;
};
[[nodiscard]] inline Passage passage(const Vec3& relative_position, const Vec3& relative_velocity,
                                     double dt) {
  Passage result{.nearest = closest_approach(relative_position, relative_velocity, -dt, 0)};
  const double now = dot(relative_position, relative_velocity);
  const double before = now - 1.5 * dt * norm2(relative_velocity);
  result.passing = now >= 0 && before <= 0;
  return result;
}

/// The probability that the warhead kills at a miss distance (m): the diffuse Gaussian damage
/// function exp(-miss^2 / (2 b^2)) with b^2 = lethal_radius^2 / 2, scaled by the reliability, so
/// that the lethal area 2 pi b^2 is that of a disk of the lethal radius. Washburn & Kress, Combat
/// Modeling (2009), ch. 2; Driels, Weaponeering, has it as the circular Carleton function.
[[nodiscard]] inline double kill_probability(const Warhead& warhead, double miss) {
  const double x = miss / warhead.lethal_radius;
  return warhead.best_kill * math::exp(-x * x);
}

}  // namespace eyrie::model::weapon
