// SPDX-License-Identifier: MIT
#include "pilot/behavior/ways.hpp"

#include "model/environment.hpp"
#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

Status Navigate::tick(const Tick& t, Proposal& out) const {
  const Way way = go(t, out);
  if (way.status == Status::failure)
    return way.status;
  out.action.altitude = way.wanted.altitude;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::route;
  out.action.route = route_;
  out.action.target = TrackId{};
  return way.status;
}

Status FollowLead::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const auto place = go(t, out);
  if (!place)
    return Status::failure;
  const auto& [lead, offset] = *place;
  const double lead_altitude = altitude_of(s.own, to_ned(s.own, lead.position - s.own.position));
  out.action.altitude = std::max(lead_altitude - offset.z, floor_);
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::follow;
  out.action.follow = Follow{lead.position, lead.velocity, s.time, offset};
  out.action.target = TrackId{};
  return Status::running;
}

Status Egress::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const auto distance = s.home_distance();
  if (!distance)
    return fails(t, "the flight has no home");
  const Vec3& home = *s.flight.home;
  // no nearer than the circle that it will fly there; at 1 g, where there is no turn, twice the
  // square of its speed over g
  const double turn = s.own.speed * s.own.speed /
                      (model::kGravity * std::sqrt(load_factor_ * load_factor_ - 1 + 0.25));
  const double arrival = std::max({arrival_, 1.25 * s.guidance().loiter_radius, turn});
  const bool arrived = *distance <= arrival;

  // down along the slope, so that it is low when it arrives
  const double slope = math::tan(descent_);
  const double on_slope = landing_altitude_ + slope * std::max(*distance - arrival, 0.0);
  out.action.altitude = std::min(altitude_, on_slope);
  out.action.speed = speed_;
  out.action.load_factor = load_factor_;
  out.action.target = TrackId{};
  out.vote = vote_;

  // by the route, while there is one to fly
  if (!arrived && route_ && *route_ < s.flight.routes.size()) {
    const model::Route& route = s.flight.routes[*route_];
    model::NavState nav = s.flying.nav;
    if (nav.route != *route_)
      nav = {.leg = 0, .route = *route_};
    if (nav.leg < route.waypoints.size()) {
      const model::flight::GuidanceGains& gains = s.airframe().autopilot.guidance;
      const model::flight::Guidance fly = model::flight::route_guidance(
          gains, s.own, route, nav, speed_, gains.loiter_radius, s.wind());
      out.action.heading = wrap_tau(fly.heading);
      out.action.altitude = fly.altitude;
      out.action.speed = fly.speed;
      out.action.mode = model::AutopilotMode::route;
      out.action.route = *route_;
      return Status::running;
    }
  }

  const double bearing = bearing_of(to_ned(s.own, home - s.own.position));
  out.action.heading = wrap_tau(model::flight::crab(bearing, speed_, s.wind()));
  if (!arrived) {
    out.action.mode = model::AutopilotMode::hold;
    return Status::running;
  }

  // over home: circle down; a tenth above the landing altitude is low, as the autopilot comes to
  // it from above
  out.action.mode = model::AutopilotMode::loiter;
  out.action.follow = Follow{.position = home, .velocity = {}, .time = s.time, .offset = {}};
  if (s.own.altitude > landing_altitude_ * 1.1 + 50)
    return Status::running;
  out.action.call = Call::land;
  return Status::success;
}

Status AvoidGround::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const double sink = std::max(s.velocity_ned.z, 0.0);
  const double speed = std::max(s.own.speed, 1.0);
  const double sine = std::min(sink / speed, 1.0);
  const double radius = speed * speed / (model::kGravity * (pull_ - 1));
  const double pull_out = radius * (1 - std::sqrt(1 - sine * sine));
  if (s.own.altitude - sink * warning_time_ - pull_out >= floor_)
    return fails(t, "high enough");
  out.action.heading = wrap_tau(s.own.heading);
  out.action.altitude = std::max(s.own.altitude, floor_) + climb_;
  out.action.load_factor = pull_;
  out.action.mode = model::AutopilotMode::hold;
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
