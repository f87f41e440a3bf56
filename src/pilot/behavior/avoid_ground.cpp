// SPDX-License-Identifier: MIT
#include "pilot/behavior/avoid_ground.hpp"

namespace eyrie::pilot {

Status AvoidGround::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const double sink = s.velocity_ned.z;
  // a circular pull-out of radius V^2 / (g (n - 1)) from a dive angle with sine sink / V loses
  // R (1 - cos) of height
  const double speed = std::max(s.own.speed, 1.0);
  const double sine = std::clamp(sink / speed, 0.0, 1.0);
  const double radius = speed * speed / (kGravity * (pull_ - 1));
  const double pull_out = radius * (1 - std::sqrt(1 - sine * sine));
  const double lowest = s.own.altitude - std::max(sink, 0.0) * warning_time_ - pull_out;
  if (lowest >= floor_ || (sink <= 0 && s.own.altitude >= floor_))
    return Status::failure;
  out.action.heading = wrap_tau(s.own.heading);
  out.action.altitude = std::max(s.own.altitude, floor_) + 500;
  out.action.load_factor = pull_;
  out.action.mode = model::AutopilotMode::hold;
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
