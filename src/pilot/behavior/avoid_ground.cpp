// SPDX-License-Identifier: MIT
#include "pilot/behavior/avoid_ground.hpp"

#include <algorithm>

#include "model/environment.hpp"

namespace eyrie::pilot {

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
