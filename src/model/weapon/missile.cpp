// SPDX-License-Identifier: MIT
#include "model/weapon/missile.hpp"

#include "model/environment.hpp"
#include "model/weapon/flyout.hpp"
#include "model/weapon/kept_zones.hpp"

namespace eyrie::model::weapon {

Newborn launched(const Launch& launch, const Kinematics& shooter, const Track& track) {
  Newborn missile{.kinematics = shooter, .state = {}};
  Kinematics& k = missile.kinematics;
  k.velocity += launch.type.ejection_speed * body_axes(shooter).down;
  k.roll = 0;
  k.load_factor = 0;

  MissileState& s = missile.state;
  s.target_position = track.position;
  s.target_velocity = track.velocity;
  s.target_time = track.time;
  const LineOfSight los =
      line_of_sight(position_at(track, launch.time) - k.position, track.velocity - k.velocity);
  s.sight = los.direction;
  s.sight_rate = los.rate;
  s.sight_time = launch.time;
  s.closing_speed = los.closing;
  s.launch_time = launch.time;
  s.shooter = launch.shooter;
  s.intended = track.truth;
  s.track = track.id;
  s.type = launch.type_index;
  s.side = launch.side;
  s.active = launch.type.locks_before_launch() ? 1 : 0;
  return missile;
}

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
