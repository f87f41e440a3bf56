// SPDX-License-Identifier: MIT
#pragma once
/// \file  What structure, wing and full power allow, of one aircraft or of several side by side.
#include "model/flight/point_mass.hpp"

namespace eyrie::model::flight {

/// Energy in lanes, with the same members.
template <class Real>
struct EnergyOf {
  Real available, sustained, corner_speed, excess_power;
};

/// In that condition, at the true airspeed `speed` (m/s).
/// Corner speed: where lift 1/2 rho V^2 S C_Lmax(M) is the structure's limit times the weight.
template <class Real>
EnergyOf<Real> energy_of(const std::array<const PointMass*, math::kLanes<Real>>& models,
                         const FlightConditionOf<Real>& c, const Real& speed) {
  const Real most = math::each_lane<Real>(
      [&](std::size_t i) { return models[i]->airframe().limits.max_load_factor; });
  const auto lift_at = [&](const Real& mach) {
    return math::each_lane<Real>(
        [&](std::size_t i) { return models[i]->max_lift(math::lane(mach, i)); });
  };
  const Real excess = c.thrust.afterburner - c.zero_lift_drag;
  // n at which the drag is the thrust: below the separation D = D0 + D1 n2, beyond it
  // D0 + D1 n2 + D2 (n - ns)2
  const Real attached = math::sqrt(math::max(excess, 0) / c.induced_drag);
  const Real a = c.induced_drag + c.separation_drag, b = c.separation_drag * c.separation;
  const Real separated =
      (b + math::sqrt(math::max(b * b - a * (b * c.separation - excess), 0))) / a;
  const Real sustained = math::select(attached > c.separation, separated, attached);
  const Real mach_per_speed = 1 / c.speed_of_sound;
  // V2 C_L(M) is proportional to the lift limit: a few rounds of a fixed point are within 1 %
  const Real here = speed * speed * lift_at(c.mach) / c.lift_limit;
  Real corner = speed * math::sqrt(most / c.lift_limit);
  for (int round = 0; round < 3; ++round)
    corner = math::sqrt(most * here / lift_at(corner * mach_per_speed));
  const Real available = math::min(most, c.lift_limit);
  return {.available = available,
          .sustained = math::min(sustained, available),
          .corner_speed = corner,
          .excess_power = (c.thrust.afterburner - c.drag(1)) * speed / (c.mass * kGravity)};
}

}  // namespace eyrie::model::flight
