// SPDX-License-Identifier: MIT
#include "pilot/behavior/pursue.hpp"

#include "model/flight/guidance.hpp"
#include "model/weapon/stores.hpp"
#include "pilot/gunnery.hpp"
#include "pilot/sort.hpp"

namespace eyrie::pilot {
namespace {

/// How much of the target's velocity is believed, 0 to 1: half when it is known to an eighth of the
/// own speed. Who leads a target of unknown velocity turns with every look.
double trust(const State& s, const Seen& target) {
  const double unsure = 8 * static_cast<double>(target.track->velocity_sigma);
  return s.own.speed * s.own.speed / (s.own.speed * s.own.speed + unsure * unsure);
}

/// Where to fly through the air to meet the target (NED, any length): the collision course at the
/// present airspeed with as much of his velocity as is known; straight at it if there is none. The
/// target drifts with the same wind.
Vec3 collision_course(const State& s, const Seen& target) {
  const Vec3 through_air = trust(s, target) * (s.velocity_of(target) - s.wind());
  const auto time = time_to_meet(target.ned, through_air, s.own.speed);
  return time ? target.ned + *time * through_air : target.ned;
}

}  // namespace

double Pursue::heading_of_choice(const State& s, const Seen& target) const {
  const double course = bearing_of(collision_course(s, target)), bearing = bearing_of(target.ned);
  const double lead = angle_between(bearing, course);
  const bool is_near = target.range <= level_range_ && model::weapon::missiles_left(s.stores) > 0;
  return is_near ? bearing + std::clamp(lead, -near_lead_, near_lead_) : course;
}

double Pursue::altitude_of_choice(const State& s, const Seen& target) const {
  if (altitude_ && target.range > level_range_)
    return *altitude_;
  return altitude_of(s.own, target.ned);
}

double Pursue::speed_of_choice(const State& s, const Seen& target) const {
  return target.range > level_range_ ? speed_ : held_back(s, target, overtake_, speed_);
}

/// m, to go up (or down, from below) to stay clear of a mate who has the right of way.
double Pursue::clearance(const State& s) const {
  for (std::uint32_t i = 0; i < s.datalink.self; ++i) {
    const model::Mate& mate = s.datalink.members[i];
    if (!mate.alive || !mate.reported)
      continue;
    const Vec3 apart = to_ned(s.own, position_at(mate, s.time) - s.own.position);
    if (norm2(apart) < separation_ * separation_)
      return apart.z >= 0 ? separation_ : -separation_;
  }
  return 0;
}

void Pursue::follow(const State& s, const Seen& target, double altitude, Action& action) const {
  const Vec3 velocity = s.velocity_of(target);
  // who stands has no heading: follow him from where we are
  const double heading = bearing_of(norm2(velocity) > 0 ? velocity : target.ned);
  const Follow follow{.position = position_at(*target.track, s.time),
                      .velocity = target.track->velocity,
                      .time = s.time,
                      .offset = {-behind_, 0, 0}};
  const model::flight::FollowOrder order{.position = follow.position,
                                         .velocity = follow.velocity,
                                         .lead_heading = heading,
                                         .offset = follow.offset,
                                         .altitude = altitude};
  const model::flight::Guidance fly =
      model::flight::follow_guidance(s.airframe().autopilot.guidance, s.own, order, s.wind());
  action.heading = wrap_tau(fly.heading);
  action.altitude = fly.altitude;
  action.speed = fly.speed;
  action.mode = model::AutopilotMode::follow;
  action.follow = follow;
}

double Pursue::steadied(const State& s, const Seen& target, double heading) const {
  // what the error of his velocity makes of the collision course
  const double unsure =
      static_cast<double>(target.track->velocity_sigma) / std::max(s.own.speed, 1.0);
  const auto near = [&](double flown) {
    return std::fabs(angle_between(flown, heading)) < dead_band_ + unsure;
  };
  if (target.range <= level_range_ || s.command.mode != model::AutopilotMode::hold)
    return wrap_tau(heading);
  // nor is it one to turn back from a turn that has just begun: that is only ended
  return wrap_tau(near(s.command.heading) ? s.command.heading
                  : near(s.own.heading)   ? s.own.heading
                                          : heading);
}

Status Pursue::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return fails(t, "no target");
  Action& action = out.action;
  out.vote = vote_;
  action.target = target->id();
  const double slowest = speed_of(s, least_mach_);
  const double most =
      target->range > level_range_ ? std::min(far_load_factor_, load_factor_) : load_factor_;
  action.load_factor = load(s, most);
  double altitude = altitude_of_choice(s, *target);
  if (s.own.speed < slowest)
    altitude = std::min(altitude, s.own.altitude);
  const double clear = clearance(s);
  altitude = std::max(altitude + clear, floor_);

  const bool crank = crank_ > 0 && claims_on(s, *target).own_shots > 0;
  if (mode_ == Pursuit::follow && !crank) {
    follow(s, *target, altitude, action);
    return Status::running;
  }

  action.mode = model::AutopilotMode::hold;
  action.speed = speed_of_choice(s, *target);
  action.altitude = altitude;
  if (crank) {
    // to the side on which the nose already is, so that it never crosses the target
    const double bearing = bearing_of(target->ned);
    const double side = angle_between(bearing, s.own.heading) >= 0 ? 1 : -1;
    action.heading = steadied(s, *target, bearing + side * crank_);
    return Status::running;
  }
  action.heading = steadied(s, *target, heading_of_choice(s, *target));
  if (mode_ == Pursuit::lead && target->range <= gun_range_ && clear == 0)
    if (const auto& sight = s.gun_sight(*target))
      aim(s, ahead_of_sight(s, *target, *sight),
          {*action.load_factor, load_factor_, *action.speed, floor_}, action);
  return Status::running;
}

}  // namespace eyrie::pilot
