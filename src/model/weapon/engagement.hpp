// SPDX-License-Identifier: MIT
#pragma once
/// \file  One missile against one target over a flat Earth, with perfect knowledge: how the launch
/// zone is found, and a laboratory for tests.
#include <limits>

#include "model/environment.hpp"
#include "model/weapon/launch_zone.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/seeker_type.hpp"

namespace eyrie::model::weapon {

/// A target that escapes turns with this load factor.
inline constexpr double kEscapeLoadFactor = 5;

/// What the target does from launch on, or from when it is warned. Every turn is level with 5 g
/// until the new course is reached, at constant speed.
enum class Escape : std::uint8_t {
  none,  ///< keeps its course
  run,   ///< flies straight away from where the shooter was
  beam,  ///< flies across the line of sight at launch, to the side that is nearer
  dive,  ///< as run, and 30 degrees down to 1000 m, where the missile has more air to go through
};

/// A launch at the origin, target `range` m away. x lies along the line of sight on the ground.
struct Engagement {
  LaunchSituation situation;
  double range = 10e3;  ///< m, slant
  Escape escape = Escape::none;
  /// m, of the missile, at which the target learns of it and begins to escape; else at launch.
  double warned = std::numeric_limits<double>::infinity();
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

/// A radar missile and a target of constant velocity that meet head-on, in level flight: what
/// closed forms of the miss by noise are about. Nothing limits the missile but the lag of its
/// autopilot, which is so long that the filter of 5 ms and the looks hardly lag beside it.
struct NoisyApproach {
  SeekerType errors;      ///< of which angle noise and glint count
  double lag = 5;         ///< s
  double closing = 1300;  ///< m/s
  double step = 0.01;     ///< s, of the flight and between two looks
  double gain = 4;
};

/// m, the standard deviation of the miss along an axis, over 400 flights of ten lags each through
/// measurement, filter, guidance and autopilot (docs/models/missile.md, What is checked).
[[nodiscard]] double spread_of_miss(const NoisyApproach& approach);

}  // namespace eyrie::model::weapon
