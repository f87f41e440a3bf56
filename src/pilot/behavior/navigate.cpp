// SPDX-License-Identifier: MIT
#include "pilot/behavior/navigate.hpp"

#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

Status Navigate::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  if (s.flight.routes.empty() || s.flight.routes[0].waypoints.empty())
    return Status::failure;
  const auto& gains = s.library.airframes[s.type.index.airframe].autopilot.guidance;
  const model::Guidance fly =
      model::route_guidance(gains, s.own, s.flight.routes[0], s.flying.nav, speed_,
                            gains.loiter_radius, s.library.environment.wind.at(s.own.altitude));
  out.action.heading = fly.heading;
  out.action.altitude = fly.altitude;
  out.action.speed = fly.speed;
  out.action.mode = model::AutopilotMode::route;
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
