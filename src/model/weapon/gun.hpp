// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a gun's rounds fly and how likely they are to hit.
#include <cstdint>
#include <optional>

#include "core/vec.hpp"
#include "model/kinematics.hpp"
#include "model/signature.hpp"
#include "model/weapon/gun_state.hpp"
#include "model/weapon/gun_type.hpp"

namespace eyrie::model::weapon {

/// A full drum.
[[nodiscard]] GunState loaded(const GunType& gun);

/// s, of a round over `distance` m through still air of `density` kg/m^3 from `speed` m/s: with
/// quadratic drag v = v0 exp(-k x) and t = (exp(k x) - 1) / (k v0), k = density C_D A / (2 m).
/// McCoy, Modern Exterior Ballistics, 2nd ed., ch. 5 (flat fire, constant drag coefficient).
[[nodiscard]] double time_of_flight(const GunType& gun, double density, double speed,
                                    double distance);

/// Where to shoot at a target.
struct Lead {
  Vec3 direction{1, 0, 0};  ///< unit vector: where the bore must point
  double range = 0;         ///< m, to the target now
  double flight_time = 0;   ///< s
  double off_bore = 0;      ///< rad, between `direction` and the nose
};
/// The lead on a target that keeps its velocity, gravity drop of the round included.
[[nodiscard]] Lead lead_on(const GunType& gun, double density, const Kinematics& own,
                           const Vec3& nose, const Kinematics& target);

/// The chance that one round hits. Aim and dispersion are circular normal errors, so a round passes
/// within r of the aim point with probability 1 - exp(-r^2 / (2 sigma^2)) (Rayleigh; Driels,
/// Weaponeering, ch. 3); r is that of a disk as big as the target's silhouette. What the sight does
/// not predict of the target's acceleration adds a t^2 / 2 to the aim error. Nothing beyond the
/// greatest range or when the nose is farther off than the pilot's fine aim.
[[nodiscard]] double hit_probability(const GunType& gun, const Lead& lead, const Signature& size,
                                     const Kinematics& target);

/// Rounds that leave in a step of `dt` s while the trigger is pressed; counts them.
[[nodiscard]] std::uint32_t fire(const GunType& gun, double dt, GunState& state);

}  // namespace eyrie::model::weapon
