// SPDX-License-Identifier: MIT
#include "core/math.hpp"
#include "model/environment.hpp"
#include "model/weapon/kept_zones.hpp"
#include "model/weapon/missile_type.hpp"

namespace eyrie::model::weapon {

double Motor::total_impulse() const {
  const auto time = thrust.breakpoints();
  const auto force = thrust.values();
  double impulse = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    impulse += (time[i] - time[i - 1]) * (force[i] + force[i - 1]) / 2;
  return impulse;
}

double Motor::specific_impulse() const {
  const double burnt = launch_mass() - burnout_mass();
  return burnt > 0 ? total_impulse() / (kGravity * burnt) : 0;
}

double Motor::ideal_speed_gain() const {
  return specific_impulse() * kGravity * math::log(launch_mass() / burnout_mass());
}

void MissileType::prepare() {
  zone = kept_zones().of(*this);
}

}  // namespace eyrie::model::weapon
