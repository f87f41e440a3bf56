// SPDX-License-Identifier: MIT
#pragma once
/// \file  One missile against one target over a flat Earth, with perfect knowledge: how the launch
/// zone is found, and a laboratory for tests.
#include "model/environment.hpp"
#include "model/weapon/launch_zone.hpp"
#include "model/weapon/missile.hpp"

namespace eyrie::model::weapon {

/// A launch at the origin, target `range` m away. x lies along the line of sight on the ground.
struct Engagement {
  LaunchSituation situation;
  double range = 10e3;  ///< m, slant
  /// g, level turn of the target from launch on until it flies straight away from the shooter;
  /// 1 or less: it keeps its course.
  double escape_load_factor = 1;
  double shortest_step = 0.02;  ///< s
  double longest_step = 0.5;    ///< s; steps are a tenth of the time to go, between the two
};

struct EngagementResult {
  double miss = 0;               ///< m, closest approach; infinite if it never came near
  double time = 0;               ///< s, of flight until then
  double speed = 0;              ///< m/s, of the missile then
  double greatest_speed = 0;     ///< m/s, on the way
  double greatest_lift = 0;      ///< m/s^2
  double greatest_altitude = 0;  ///< m
  bool armed = false;            ///< time was beyond arming and the missile steered by then

  /// Whether the warhead would have had a fair chance.
  [[nodiscard]] bool success(const MissileType& type) const {
    return armed && miss <= type.warhead.lethal_radius && speed >= type.least_speed;
  }
};

/// Flies it until the closest approach, or until the missile is out of time, speed or altitude.
[[nodiscard]] EngagementResult engage(const MissileType& type, const Atmosphere& atmosphere,
                                      const Engagement& engagement);

}  // namespace eyrie::model::weapon
