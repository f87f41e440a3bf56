// SPDX-License-Identifier: MIT
#include "pilot/behavior/release_weapon.hpp"

#include <bitset>

#include "model/weapon/stores.hpp"
#include "pilot/gunnery.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

std::optional<std::uint16_t> ReleaseWeapon::choose_store(const State& s, const Seen& target) const {
  const model::weapon::LaunchSituation situation = s.launch_situation(target);
  std::optional<std::uint16_t> best;
  double best_reach = 0;
  std::bitset<256> tried;
  for (const model::Station& station : s.stores.stations) {
    if (station.store == 0 || station.count == 0 || tried[station.store])
      continue;
    tried.set(station.store);
    const auto store = static_cast<std::uint16_t>(station.store - 1);
    const model::MissileType& missile = s.library.missiles[store];
    const bool sees =
        !missile.locks_before_launch() || target.range < missile.seeker.greatest_range;
    // a missile that is sent blind goes where the track is
    const bool knows = missile.locks_before_launch() || target.track->position_sigma <= max_error_;
    if (!sees || !knows || !model::weapon::can_release(s.stores, store, s.time))
      continue;
    const model::weapon::EmploymentZone zone = missile.zone.at(situation);
    const double reach = zone.r_ne + zone_ * (zone.r_max - zone.r_ne);
    if (!zone.possible() || target.range < zone.r_min || target.range > reach ||
        (best && reach >= best_reach))
      continue;
    // whoever stands where the seeker looks on its way may be taken for the target
    const double looks_from =
        missile.locks_before_launch() ? 0 : target.range - missile.seeker.activation_range;
    if (friend_in_line(s, {.direction = target.ned,
                           .from = looks_from,
                           .to = target.range + clear_radius_,
                           .half_angle = clear_cone_}))
      continue;
    best = store;
    best_reach = reach;
  }
  return best;
}

const char* ReleaseWeapon::why_not(const State& s, const Seen& target) const {
  if (!target.hostile())
    return "the target is not identified as hostile";
  if (s.time - target.track->time > max_age_)
    return "the track is too old";
  if (s.stores.pending_track)
    return "a missile is leaving";
  if (s.off_nose(target.ned) > off_boresight_)
    return "the target is too far off the nose";
  // two standard deviations: a target whose place is badly known may be where the friend is
  const double unsure = 2 * static_cast<double>(target.track->position_sigma);
  return friend_near(s, target.ned, clear_radius_ + unsure) ? "a friend is near the target"
                                                            : nullptr;
}

bool ReleaseWeapon::is_covered(const State& s, const Claims& claims) const {
  const std::uint32_t mates = s.alive & ~(1U << s.datalink.self);
  return claims.own_shots >= salvo_ || (one_shooter_ && (claims.shot & mates) != 0);
}

bool ReleaseWeapon::leaves_it(const State& s, const Seen& target, const Claims& claims,
                              HoldMemory& m) const {
  if (!one_shooter_ || claims.own_shots > 0 || shoots_first(s, target)) {
    m = {};
    return false;
  }
  if (m.track != target.id())
    m = {.since = s.time, .track = target.id()};
  return !ubf::passed(s.time, m.since, patience_);
}

Status ReleaseWeapon::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  HoldMemory& m = memory(t);
  const auto holds_fire = [&](const char* why) {
    m = {};
    return fails(t, why);
  };
  const Seen* target = s.target();
  if (!target)
    return holds_fire("no target");
  if (const char* why = why_not(s, *target))
    return holds_fire(why);
  const Claims claims = claims_on(s, *target);
  if (is_covered(s, claims))
    return holds_fire("enough missiles are on their way to the target");
  const auto store = choose_store(s, *target);
  if (!store)
    return holds_fire("the target is in no missile's zone, or a friend is near the line");
  if (leaves_it(s, *target, claims, m))
    return fails(t, "a mate shoots first");
  out.action.target = target->id();
  out.action.release = Release{target->id(), *store};
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
