// SPDX-License-Identifier: MIT
#include "pilot/behavior/crank.hpp"

#include "pilot/danger.hpp"
#include "pilot/sort.hpp"

namespace eyrie::pilot {

Status Crank::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  CrankMemory& m = memory(t);
  const Seen* target = s.target();
  const auto ends = [&](const char* why) {
    m = {};
    return fails(t, why);
  };
  if (!target)
    return ends("no target");
  if (claims_on(s, *target).own_shots == 0)
    return ends("no own missile flies to the target");
  if (support_ && !support_needed(s))
    return ends("the missile's own seeker is on");
  if (m.going == 0)
    m = {.began = s.own.altitude, .going = 1};
  double angle = angle_;
  if (s.type.index.radar)
    angle = std::min(angle, s.library.radars[*s.type.index.radar].gimbal - margin_);
  const double bearing = bearing_of(target->ned);
  const double side = angle_between(bearing, s.own.heading) >= 0 ? 1 : -1;
  out.vote = vote_;
  out.action.target = target->id();
  out.action.heading = wrap_tau(bearing + side * std::max(angle, 0.0));
  out.action.altitude = std::max(m.began - descend_, std::min(floor_, m.began));
  out.action.speed = speed_;
  out.action.load_factor = load(s, load_factor_);
  out.action.mode = model::AutopilotMode::hold;
  return Status::running;
}

}  // namespace eyrie::pilot
