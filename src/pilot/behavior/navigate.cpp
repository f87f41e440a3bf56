// SPDX-License-Identifier: MIT
#include "pilot/behavior/navigate.hpp"

#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

Status Navigate::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  if (route_ >= s.flight.routes.size() || s.flight.routes[route_].waypoints.empty())
    return Status::failure;
  const model::Route& route = s.flight.routes[route_];
  model::NavState nav = s.flying.nav;
  if (nav.route != route_)
    nav = {.leg = 0, .route = route_};

  const model::GuidanceGains& gains = s.airframe().autopilot.guidance;
  const model::Guidance fly =
      model::route_guidance(gains, s.own, route, nav, speed_, gains.loiter_radius, s.wind());
  out.action.heading = wrap_tau(fly.heading);
  out.action.altitude = fly.altitude;
  out.action.speed = fly.speed;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::route;
  out.action.route = route_;
  out.action.target = TrackId{};
  out.vote = vote_;
  return nav.leg >= route.waypoints.size() ? Status::success : Status::running;
}

}  // namespace eyrie::pilot
