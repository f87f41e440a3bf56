// SPDX-License-Identifier: MIT
#include "pilot/behavior/pursue.hpp"

namespace eyrie::pilot {
Status Pursue::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return Status::failure;
  const double bearing = bearing_of(target->ned);
  double heading = bearing;
  if (mode_ == Pursuit::intercept) {
    if (const auto meet = time_to_meet(target->ned, target->velocity, speed_))
      heading = bearing_of(target->ned + *meet * target->velocity);
  } else if (mode_ == Pursuit::lead) {
    heading = bearing_of(target->ned + target->range / kBulletSpeed * target->velocity);
  }
  if (crank_ > 0 && s.own_shot_flies(target->id())) {
    // to the side on which the nose already is, so that it never crosses the target
    const double side = wrap_pi(s.own.heading - bearing) >= 0 ? 1 : -1;
    heading = wrap_pi(bearing + side * crank_);
  }
  double altitude = altitude_of(s.own, target->ned);
  if (altitude_ && target->range > level_range_)
    altitude = *altitude_;

  out.action.heading = wrap_tau(heading);
  out.action.altitude = std::max(altitude, floor_);
  out.action.speed = speed_;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::hold;
  out.action.target = target->id();
  if (mode_ == Pursuit::follow) {
    out.action.mode = model::AutopilotMode::follow;
    out.action.follow = Follow{model::position_at(*target->track, s.time),
                               target->track->velocity,
                               s.time,
                               {-behind_, 0, 0}};
  }
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
