// SPDX-License-Identifier: MIT
#include "model/flight/autopilot.hpp"

#include <algorithm>

namespace eyrie::model::flight {
namespace {

/// Heading of a velocity over the ground, `fallback` below walking speed.
double track_of(const Kinematics& own, const Vec3& velocity, double fallback) {
  const double north = dot(own.north, velocity), east = dot(own.east, velocity);
  return north * north + east * east > 1 ? math::atan2(east, north) : fallback;
}

Guidance follow(const Autopilot& autopilot, const Kinematics& own, const Command& command,
                Flying& memory, const Vec3& wind_ned, double time, double dt) {
  const double raw = track_of(own, command.reference_velocity, own.heading);
  memory.lead_heading = memory.following ? low_pass_heading(memory.lead_heading, raw, dt,
                                                            autopilot.guidance.lead_heading_time)
                                         : raw;
  memory.following = 1;
  const FollowOrder order{.position = command.reference_position +
                                      (time - command.reference_time) * command.reference_velocity,
                          .velocity = command.reference_velocity,
                          .lead_heading = memory.lead_heading,
                          .offset = command.offset,
                          .altitude = command.altitude};
  return follow_guidance(autopilot.guidance, own, order, wind_ned);
}

}  // namespace

Guidance guide(const Autopilot& autopilot, const Kinematics& own, const Command& command,
               std::span<const Route> routes, double turn_radius, Flying& memory,
               const Vec3& wind_ned, double time, double dt) {
  const GuidanceGains& gains = autopilot.guidance;

  // which leg: another route starts at its first
  if (command.mode == AutopilotMode::route && command.route != memory.nav.route)
    memory.nav = {.leg = 0, .route = command.route};
  const Route* route = memory.nav.route < routes.size() ? &routes[memory.nav.route] : nullptr;
  if (route)
    memory.nav = advance_leg(gains, own, *route, memory.nav, turn_radius);
  if (command.mode != AutopilotMode::follow)
    memory.following = 0;
  const double asked = command.loiter_radius > 0 ? command.loiter_radius : gains.loiter_radius;
  const double radius = std::max(asked, turn_radius);  // a circle that it can fly

  switch (command.mode) {
    case AutopilotMode::route:
      if (route)
        return route_guidance(gains, own, *route, memory.nav, command.speed, radius, wind_ned);
      break;
    case AutopilotMode::follow:
      return follow(autopilot, own, command, memory, wind_ned, time, dt);
    case AutopilotMode::loiter:
      return loiter_guidance(gains, own, command.reference_position, radius, command.altitude,
                             command.speed, wind_ned);
    case AutopilotMode::aim:
      return {.heading = command.heading,
              .altitude = own.altitude,
              .speed = command.speed,
              .climb = command.climb};
    case AutopilotMode::hold:
      break;
  }
  return {.heading = command.heading, .altitude = command.altitude, .speed = command.speed};
}

}  // namespace eyrie::model::flight
