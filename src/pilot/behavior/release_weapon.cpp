// SPDX-License-Identifier: MIT
#include "pilot/behavior/release_weapon.hpp"

#include <bitset>

#include "model/weapon/stores.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

const char* ReleaseWeapon::why_not(const State& s, const Seen& target,
                                   const model::MissileType& missile,
                                   const model::weapon::EmploymentZone& zone) const {
  if (!zone.possible() || target.range > zone.range_at(zone_, of_))
    return "the target is in no missile's zone";
  if (target.range < zone.r_min)
    return "the target is too near";
  if (target.range > zone.r_ne) {
    if (s.own.mach < least_mach_)
      return "too slow for a shot that the target can escape";
    if (least_f_pole_ > 0 && f_pole(s, target, missile) < least_f_pole_)
      return "the target would be too near when the missile arrives";
  }
  // a mate close ahead may turn before the missile has flown past him
  if (friend_in_line(s, {s.nose(), 10, si(1, "nmi"), si(45, "deg")}))
    return "a friend is close before the nose";
  return friend_in_basket(s, target, missile,
                          {.half_angle = clear_cone_, .beyond = clear_radius_, .turn = clear_turn_})
             ? "a friend may be where the seeker will look"
             : nullptr;
}

ReleaseWeapon::Choice ReleaseWeapon::choose_store(const State& s, const Seen& target) const {
  const model::weapon::LaunchSituation situation = s.launch_situation(target);
  Choice best;
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
    const double reach = zone.range_at(zone_, of_);
    if (best.store && reach >= best_reach)
      continue;
    if (const char* why = why_not(s, target, missile, zone)) {
      best.why_none = why;
      continue;
    }
    best.store = store;
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

namespace {

/// s, when an own sensor or an own eye last saw it. What mates say of a track does not count: they
/// may have carried on one that nobody sees.
double last_look(const model::Track& track) {
  return (track.sources & model::kFromTruth) != 0 ? track.time
                                                  : std::max(track.sensed_time, track.seen_time);
}

}  // namespace

const char* ReleaseWeapon::why_wait(const State& s, const Seen& target, const Claims& claims,
                                    HoldMemory& m) const {
  const std::uint32_t mates = s.alive & ~(1U << s.datalink.self);
  const auto theirs =
      one_shooter_ ? static_cast<std::uint32_t>(std::popcount(claims.shot & mates)) : 0;
  // a missile is no longer on its way: has it hit? A ripple goes on without asking
  const bool flies = claims.own_shots + theirs > 0;
  if (flies) {
    m.busy = target.id();
    m.arrived = s.time;
  }
  if (claims.own_shots >= ripple_ || (theirs > 0 && claims.own_shots + theirs >= flight_ripple_))
    return "enough missiles are on their way to the target";
  if (claims.own_shots > 0)
    return s.time - claims.last_left < ripple_interval_ ? "the ripple goes on later" : nullptr;
  const double arrived =
      std::max(claims.last_arrived, m.busy == target.id() ? m.arrived : model::kNever);
  return !flies && last_look(*target.track) < arrived + assess_
             ? "looks whether the missile has hit"
             : nullptr;
}

bool ReleaseWeapon::leaves_it(const State& s, const Seen& target, const Claims& claims,
                              HoldMemory& m) const {
  if (!one_shooter_ || claims.own_shots > 0 || shoots_first(s, target)) {
    m.track = {};
    return false;
  }
  if (m.track != target.id()) {
    m.track = target.id();
    m.since = s.time;
  }
  return !ubf::passed(s.time, m.since, patience_);
}

Status ReleaseWeapon::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  HoldMemory& m = memory(t);
  const auto holds_fire = [&](const char* why) {
    m.track = {};
    return fails(t, why);
  };
  const Seen* target = s.target();
  if (!target)
    return holds_fire("no target");
  const Claims claims = claims_on(s, *target);
  const char* const wait = why_wait(s, *target, claims, m);
  if (const char* why = why_not(s, *target))
    return holds_fire(why);
  if (wait)
    return holds_fire(wait);
  const Choice choice = choose_store(s, *target);
  if (!choice.store)
    return holds_fire(choice.why_none);
  if (leaves_it(s, *target, claims, m))
    return fails(t, "a mate shoots first");
  out.action.target = target->id();
  out.action.release = Release{target->id(), *choice.store};
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
