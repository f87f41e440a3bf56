// SPDX-License-Identifier: MIT
#include "model/weapon/birth.hpp"

#include "model/kinematics.hpp"
#include "model/weapon/line_of_sight.hpp"

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

}  // namespace eyrie::model::weapon
