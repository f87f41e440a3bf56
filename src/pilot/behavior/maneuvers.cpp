// SPDX-License-Identifier: MIT
#include "pilot/behavior/maneuvers.hpp"

#include "pilot/gunnery.hpp"

namespace eyrie::pilot {

Status LeadPursuit::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return fails(t, "no target");
  if (target->range <= gun_range_)
    if (const auto& sight = s.gun_sight(*target)) {
      const double pull = sight->off_nose < cash_in_ ? load_factor_ : load(s, load_factor_);
      const Status status = fly(s, target, ahead_of_sight(s, *target, *sight), pull, out);
      out.action.speed = held_back(s, *target, overtake_, speed_);
      return status;
    }
  const Vec3 through_air = s.velocity_of(*target) - s.wind();
  const auto time = time_to_meet(target->ned, through_air, s.own.speed);
  return fly(s, target, time ? target->ned + *time * through_air : target->ned, out);
}

Status Snapshot::tick(const Tick& t, Proposal& out) const {
  constexpr double kBeyond = 1000;  // m, rounds fly on
  const State& s = t.state;
  const Seen* target = s.target();
  if (const char* why = why_no_gun(s, target, max_age_))
    return fails(t, why);
  const auto& sight = s.gun_sight(*target);
  if (target->range > within_)
    return fails(t, "the target is too far");
  // the aim point, and its way across the nose
  const Vec3 relative = s.velocity_of(*target) - s.velocity_ned;
  const Vec3 point = norm(target->ned + sight->time * relative) * sight->aim;
  const Vec3& nose = s.nose();
  const auto across = [&](const Vec3& v) { return v - dot(v, nose) * nose; };
  const Vec3 beside = across(point), moves = across(relative);
  if (norm(moves) <= fastest_turn(s) * norm(point))
    return fails(t, "the nose can follow the target");
  const double time = -dot(beside, moves) / norm2(moves);
  const double cone = s.library.guns[*s.type.index.gun].aim_cone;
  if (time > wait_ || (time < 0 && sight->off_nose > cone))
    return fails(t, "the target does not pass the nose soon");
  const Vec3 there = point + time * relative;
  if (friend_in_line(s, {there, 0, target->range + kBeyond, clear_cone_}))
    return fails(t, "a friend is in the line of fire");
  out.action.trigger = time <= ahead_ && s.off_nose(there) <= cone;
  return fly(s, target, there, out);
}

Status PurePursuit::tick(const Tick& t, Proposal& out) const {
  const Seen* target = t.state.target();
  return target ? fly(t.state, target, target->ned, out) : fails(t, "no target");
}

Status LagPursuit::tick(const Tick& t, Proposal& out) const {
  const Seen* target = t.state.target();
  return target ? fly(t.state, target, target->ned - lag_ * t.state.velocity_of(*target), out)
                : fails(t, "no target");
}

Status HighYoYo::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return fails(t, "no target");
  const Angles& angles = s.angles(*target);
  if (target->range > within_)
    return fails(t, "the target is too far");
  if (angles.off_tail > kPi / 2 || angles.off_nose > kPi / 2)
    return fails(t, "not behind the target");
  if (s.closing_on(*target) < closing_ || angles.crossing < crossing_)
    return fails(t, "it does not overshoot");
  return fly(s, target, raised(target->ned - s.velocity_of(*target), angle_), out);
}

Status LowYoYo::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return fails(t, "no target");
  const Angles& angles = s.angles(*target);
  if (angles.off_tail > kPi / 2)
    return fails(t, "not behind the target's wings");
  if (angles.off_nose < off_nose_ || angles.off_nose > kPi / 2)
    return fails(t, "the nose is near the target, or far behind it");
  if (s.closing_on(*target) > closing_)
    return fails(t, "it closes fast enough");
  return fly(s, target, raised(target->ned + s.velocity_of(*target), -angle_), out);
}

Status MergeTurn::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  TurnMemory& m = memory(t);
  const Seen* target = s.target();
  const auto silent = [&](const char* why) {
    m = {};
    return fails(t, why);
  };
  if (!target)
    return silent("no target");
  if (target->range > within_)
    return silent("the target is too far");
  if (s.off_nose(target->ned) < off_nose_)
    return silent("the target is before the wings");
  if (m.side == 0) {
    const double towards = angle_between(s.own.heading, bearing_of(target->ned)) >= 0 ? 1 : -1;
    const double his_speed = norm(s.velocity_of(*target));
    const bool small = s.own.speed < static_cast<double>(s.flying.energy.corner_speed) ||
                       his_speed > 1.1 * s.own.speed;
    const bool one = circle_ == Circle::one || (circle_ == Circle::best && small);
    m.side = one ? -towards : towards;
  }
  // a quarter of a circle ahead, above or below the level as the speed says
  const double heading = s.own.heading + m.side * kPi / 2;
  const auto [sine, cosine] = math::sin_cos(heading);
  return fly(s, target, raised({cosine, sine, 0}, slope_for_energy(s, floor_)), out);
}

Status Reacquire::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  LostMemory& m = memory(t);
  if (const Seen* target = s.target()) {
    m = target->range > within_
            ? LostMemory{}
            : LostMemory{target->track->time, target->track->position, target->track->velocity};
    return fails(t, "the target is known");
  }
  if (m.time == 0 || ubf::passed(s.time, m.time, memory_)) {
    m = {};
    if (const model::RwrWarning* tracks = radar_ ? spike(s) : nullptr) {
      const auto [sine, cosine] = math::sin_cos(tracks->bearing);
      return fly(s, nullptr, {cosine, sine, 0}, out);
    }
    return fails(t, "no target was lost lately");
  }
  const double on = std::min(s.time - m.time, extrapolated_);
  return fly(s, nullptr, to_ned(s.own, m.position + on * m.velocity - s.own.position), out);
}

Status Jink::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  JinkMemory& m = memory(t);
  for (const Seen& seen : s.tracks_seen()) {
    if (!seen.hostile() || seen.range > within_ || s.off_nose(seen.ned) < kPi / 2)
      continue;
    if (angle_between(s.velocity_of(seen) - s.wind(), -seen.ned) > cone_)
      continue;
    if (m.side == 0 || ubf::passed(s.time, m.since, period_))
      m = {.since = s.time, .side = m.side > 0 ? -1.0 : 1.0};
    // across the line to him, out of the level
    const Vec3 across = normalized(cross(seen.ned, {0, 0, 1}), s.nose());
    const double right = dot(across, s.nose()) >= 0 ? 1 : -1;
    return fly(s, &seen, raised(right * across, m.side * kPi / 4), out);
  }
  m = {};
  return fails(t, "nobody behind has his nose here within gun range");
}

Status Extend::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target)
    return fails(t, "no target");
  Vec3 away = -target->ned;
  away.z = 0;
  // the turn away is flown with what the energy gives; then it is unloaded
  const bool turned = s.off_nose(away) < kPi / 6;
  return fly(s, target, raised(away, -dive_), turned ? 1 : load(s, load_factor_), out);
}

Status AvoidCollision::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  CollisionMemory& m = memory(t);
  // who is beside is left behind by somewhat more, or he would soon be as near again
  const double clear = 1.2 * miss_, least = m.time == 0 ? miss_ : clear;
  double soonest = warning_, nearest2 = least * least;
  std::optional<Vec3> pass;    // from here to the other at the closest approach
  std::optional<Vec3> beside;  // to who is too near and does not come here soon
  Vec3 comes{};                // to who will pass, now
  const auto look = [&](const Vec3& ned, const Vec3& velocity_ned) {
    const Vec3 relative = velocity_ned - s.velocity_ned;
    const double approach = -dot(ned, relative);
    const double time = approach > 0 ? approach / norm2(relative) : warning_;
    if (const Vec3 there = ned + time * relative; time < soonest && norm2(there) < miss_ * miss_) {
      soonest = time;
      pass = there;
      comes = ned;
    }
    if (norm2(ned) < nearest2) {
      nearest2 = norm2(ned);
      beside = ned;
    }
  };
  // most are too far away to come near in time, however they fly
  const double own_speed = norm(s.own.velocity);
  const auto in_reach = [&](double range2, const Vec3& velocity) {
    const double reach = (least + soonest * (own_speed + norm(velocity))) * (1 + 1e-9);
    return range2 <= reach * reach;
  };
  for (const Seen& seen : s.tracks_seen())
    if (seen.track->confirmed && in_reach(seen.range * seen.range, seen.track->velocity) &&
        !is_a_mate(s, seen))
      look(seen.ned, s.velocity_of(seen));
  any_mate(s.datalink, [&](const model::Mate& mate) {
    const Vec3 apart = position_at(mate, s.time) - s.own.position;
    if (in_reach(norm2(apart), velocity_of(mate)))
      look(to_ned(s.own, apart), to_ned(s.own, velocity_of(mate)));
    return false;
  });
  if (pass || beside) {
    // away from where he will be, as seen along the own path; from where he is, if he is abreast or
    // behind or comes no nearer. To the right if that says nothing; to the left if he is behind.
    constexpr double kAbreast = kPi / 3;
    const Vec3& nose = s.nose();
    const Vec3 he = pass ? comes : *beside;
    const Vec3 from = pass && s.off_nose(he) < kAbreast ? *pass : he;
    const Vec3 aside = from - dot(from, nose) * nose;
    const double side = s.off_nose(he) > kPi / 2 ? -kPi / 2 : kPi / 2;
    const auto [sine, cosine] = math::sin_cos(s.own.heading + side);
    const Vec3 away = norm(aside) > 0.1 * miss_ ? -normalized(aside, {}) : Vec3{cosine, sine, 0};
    // of who comes no nearer the more, the nearer he is
    m = {s.time, nose + (pass ? 1 : 1 - norm(he) / clear) * away};
  } else if (m.time == 0 || ubf::passed(s.time, m.time, recovery_)) {
    m = {};
    return fails(t, "nobody comes too near");
  }
  aim(s, m.away, {load_factor_, load_factor_, s.own.speed, floor_}, out.action);
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
