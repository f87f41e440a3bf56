// SPDX-License-Identifier: MIT
#include "pilot/behavior/shoot_gun.hpp"

#include "pilot/fight.hpp"
#include "pilot/gunnery.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

bool ShootGun::trigger(double time, BurstMemory& m) const {
  if (m.phase == 1 && ubf::passed(time, m.since, burst_))
    m = {.since = time, .phase = 2};
  if (m.phase == 2 && ubf::passed(time, m.since, pause_))
    m = {};
  if (m.phase == 0)
    m = {.since = time, .phase = 1};
  return m.phase == 1;
}

Status ShootGun::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  BurstMemory& m = memory(t);
  const Seen* target = s.target();
  const auto holds_fire = [&](const char* why) {
    m = {};
    return fails(t, why);
  };
  if (const char* why = why_no_gun(s, target, max_age_))
    return holds_fire(why);
  const model::GunType& gun = s.library.guns[*s.type.index.gun];
  const double reach = std::min(range_.value_or(gun.greatest_range), gun.greatest_range);
  if (target->range > reach)
    return holds_fire("the target is out of reach");
  const auto& sight = s.gun_sight(*target);
  if (sight->off_nose > tolerance_.value_or(gun.aim_cone))
    return holds_fire("the nose is not on the aim point");
  if (friend_in_line(s, {.direction = sight->aim,
                         .to = target->range + clear_beyond_,
                         .half_angle = clear_cone_}))
    return holds_fire("a friend is in the line of fire");
  out.action.target = target->id();
  out.action.trigger = trigger(s.time, m);
  aim(s, ahead_of_sight(s, *target, *sight),
      {load_factor_, load_factor_, held_back(s, *target, overtake_, speed_), floor_}, out.action);
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
