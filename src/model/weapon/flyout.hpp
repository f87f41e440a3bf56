// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a missile flies: a point mass with thrust, drag, lift and weight.
#include "core/vec.hpp"
#include "model/environment.hpp"
#include "model/weapon/missile_type.hpp"

namespace eyrie::model::weapon {

/// What flying changes.
struct Flyout {
  Vec3 position{};  ///< m
  Vec3 velocity{};  ///< m/s over the ground
  Vec3 lift{};      ///< m/s^2, achieved aerodynamic acceleration across the flight path
};

/// What the air gives and takes at one moment.
struct FlyoutForces {
  double along = 0;       ///< m/s^2, thrust less drag at no lift
  double lift_limit = 0;  ///< m/s^2, the greatest acceleration across the flight path
  double induced = 0;     ///< 1/(m/s^2): drag deceleration per lift acceleration squared
};

/// Forces at `speed` (m/s through the air) and `age` (s since launch).
[[nodiscard]] FlyoutForces flyout_forces(const MissileType& type, const Air& air, double speed,
                                         double age);

/// One step of `dt` s. `wanted` (m/s^2) is what guidance asks for; its part along the flight path
/// is ignored, the rest is limited by load factor and greatest lift and follows with the
/// autopilot's lag. `wind` is the velocity of the air, `down` the unit vector of gravity.
void fly(const MissileType& type, const Air& air, const Vec3& wind, const Vec3& down, double age,
         double dt, const Vec3& wanted, Flyout& state);

}  // namespace eyrie::model::weapon
