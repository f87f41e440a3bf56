// SPDX-License-Identifier: MIT
#include "pilot/behavior/follow_lead.hpp"

#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

Status FollowLead::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const model::Mate* lead = s.lead();
  if (s.leads() || !lead || !lead->reported)
    return Status::failure;
  const Vec3 offset = formation_offset(s.plan.formation, s.rank);
  const Vec3 velocity{static_cast<double>(lead->velocity[0]),
                      static_cast<double>(lead->velocity[1]),
                      static_cast<double>(lead->velocity[2])};
  const Vec3 position = model::position_at(*lead, s.time);
  const Vec3 ned = to_ned(s.own, position - s.own.position);
  const model::FollowOrder order{.position = position,
                                 .velocity = velocity,
                                 .lead_heading = bearing_of(to_ned(s.own, velocity)),
                                 .offset = offset,
                                 .altitude = std::max(altitude_of(s.own, ned) - offset.z, 0.0)};
  const auto& gains = s.library.airframes[s.type.index.airframe].autopilot.guidance;
  const model::Guidance fly =
      model::follow_guidance(gains, s.own, order, s.library.environment.wind.at(s.own.altitude));
  out.action.heading = fly.heading;
  out.action.altitude = fly.altitude;
  out.action.speed = fly.speed;
  out.action.mode = model::AutopilotMode::follow;
  out.action.follow = Follow{position, velocity, s.time, offset};
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
