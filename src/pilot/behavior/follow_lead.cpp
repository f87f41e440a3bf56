// SPDX-License-Identifier: MIT
#include "pilot/behavior/follow_lead.hpp"

#include <algorithm>

#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

Status FollowLead::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  if (s.leads())
    return Status::failure;
  const auto lead = s.leader();
  if (!lead)
    return Status::failure;

  const Vec3 offset = formation_offset(s.plan.formation, s.rank);
  const double lead_altitude = altitude_of(s.own, to_ned(s.own, lead->position - s.own.position));
  const model::FollowOrder order{.position = lead->position,
                                 .velocity = lead->velocity,
                                 .lead_heading = bearing_of(to_ned(s.own, lead->velocity)),
                                 .offset = offset,
                                 .altitude = std::max(lead_altitude - offset.z, floor_)};
  const model::Guidance fly =
      model::follow_guidance(s.airframe().autopilot.guidance, s.own, order, s.wind());
  out.action.heading = wrap_tau(fly.heading);
  out.action.altitude = fly.altitude;
  out.action.speed = fly.speed;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::follow;
  out.action.follow = Follow{lead->position, lead->velocity, s.time, offset};
  out.action.target = TrackId{};
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
