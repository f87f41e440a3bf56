// SPDX-License-Identifier: MIT
#include "pilot/behavior/follow_lead.hpp"

#include <algorithm>

namespace eyrie::pilot {

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

}  // namespace eyrie::pilot
