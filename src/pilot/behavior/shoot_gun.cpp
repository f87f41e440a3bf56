// SPDX-License-Identifier: MIT
#include "pilot/behavior/shoot_gun.hpp"

namespace eyrie::pilot {
Status ShootGun::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target || !target->hostile() || s.gun.rounds == 0 || target->range > range_)
    return Status::failure;
  const double flight_time = target->range / kBulletSpeed;
  const Vec3 aim = target->ned + flight_time * (target->velocity - s.velocity_ned);
  if (s.off_nose(aim) > tolerance_)
    return Status::failure;
  out.action.target = target->id();
  out.action.trigger = true;
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
