// SPDX-License-Identifier: MIT
#include "pilot/behavior/egress.hpp"

namespace eyrie::pilot {

Status Egress::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  if (!s.flight.home)
    return Status::failure;
  const Vec3 ned = to_ned(s.own, *s.flight.home - s.own.position);
  const double distance = std::sqrt(ned.x * ned.x + ned.y * ned.y);
  out.action.heading = wrap_tau(bearing_of(ned));
  out.action.altitude = distance < descent_range_ ? landing_altitude_ : altitude_;
  out.action.speed = speed_;
  out.action.mode = model::AutopilotMode::hold;
  // a tenth above the landing altitude is down: the autopilot comes to it from above
  if (distance < arrival_ && s.own.altitude <= landing_altitude_ * 1.1 + 50)
    out.action.call = Call::land;
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
