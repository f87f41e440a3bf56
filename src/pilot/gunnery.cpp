// SPDX-License-Identifier: MIT
#include "pilot/gunnery.hpp"

#include "pilot/fight.hpp"

namespace eyrie::pilot {

bool in_gun(const State& s) {
  const Seen* target = s.target();
  const std::optional<Sight> sight =
      target && s.gun.rounds > 0 ? s.gun_sight(*target) : std::nullopt;
  if (!sight)
    return false;
  const model::GunType& gun = s.library.guns[*s.type.index.gun];
  return sight->range <= gun.greatest_range && sight->off_nose <= gun.aim_cone;
}

Vec3 ahead_of_sight(const State& s, const Seen& target, const Sight& sight) {
  const Vec3 relative = s.velocity_of(target) - s.velocity_ned;
  const Vec3 rate = cross(target.ned, relative) / std::max(norm2(target.ned), 1.0);  // rad/s
  const double followed = std::min(norm(rate), fastest_turn(s));
  const auto [sine, cosine] = math::sin_cos(s.airframe().autopilot.aim_time * followed);
  const Vec3 across = normalized(cross(rate, sight.aim), {});
  return cosine * sight.aim + sine * across;
}

const char* why_no_gun(const State& s, const Seen* target, double max_age) {
  if (!target || !target->hostile())
    return "no hostile target";
  if (s.time - target->track->time > max_age)
    return "the target is out of sight";
  return s.gun.rounds == 0 || !s.type.index.gun ? "no rounds" : nullptr;
}

bool is_a_mate(const State& s, const Seen& seen) {
  constexpr double kNear = 100;  // m, that he may have turned away since he told it
  const double within = 3 * static_cast<double>(seen.track->position_sigma) + kNear;
  const Vec3 place = position_at(*seen.track, s.time);
  return seen.track->identity == model::Identity::friendly &&
         any_mate(s.datalink, [&](const model::Mate& mate) {
           return norm2(position_at(mate, s.time) - place) < within * within;
         });
}

bool friend_in_line(const State& s, const LineOfFire& line) {
  const Vec3 direction = normalized(line.direction, {1, 0, 0});
  const double cosine = math::cos(line.half_angle);
  return any_friend(s, [&](const Friend& one) {
    const double distance = norm(one.ned);
    return distance >= line.from && distance < line.to &&
           dot(one.ned, direction) >= cosine * distance;
  });
}

bool friend_near(const State& s, const Vec3& place, double radius) {
  return any_friend(s, [&](const Friend& one) { return norm2(one.ned - place) < radius * radius; });
}

double time_of_flight(const State& state, const Seen& target, const model::MissileType& missile) {
  // along the line of sight, over the ground; the wind carries the missile, too
  const auto along = [&](const Vec3& ned) {
    return target.range > 0 ? dot(target.ned, ned) / target.range : 0;
  };
  const double own = along(state.velocity_ned);
  const double mean_speed =
      state.own.speed + missile.motor.ideal_speed_gain() / 2 + along(state.wind());
  const double closing = std::max(mean_speed + state.closing_on(target) - own, 50.0);
  return std::min(target.range / closing, missile.greatest_time);
}

double f_pole(const State& state, const Seen& target, const model::MissileType& missile) {
  const double time = time_of_flight(state, target, missile);
  return norm(target.ned + time * (state.velocity_of(target) - state.velocity_ned));
}

bool friend_in_basket(const State& s, const Seen& target, const model::MissileType& missile,
                      const Clearance& clearance) {
  constexpr int kMoments = 4;  // from switching on to arrival
  const double flight = std::max(time_of_flight(s, target, missile), 0.1);
  const double share = std::min(missile.seeker.activation_range / std::max(target.range, 1.0), 1.0);
  const double on = missile.locks_before_launch() ? 0 : flight * (1 - share);
  const Vec3 target_velocity = s.velocity_of(target);
  const Vec3 meeting = target.ned + flight * target_velocity;
  const double half_angle = std::max(clearance.half_angle, missile.seeker.field_of_view / 2);
  const auto [sine, cosine] = math::sin_cos(half_angle);

  for (int i = 0; i < kMoments; ++i) {
    const double time = on + (flight - on) * i / kMoments;
    const Vec3 missile_at = (time / flight) * meeting;
    const Vec3 sight = target.ned + time * target_velocity - missile_at;
    const double reach = norm(sight) + clearance.beyond;
    const Vec3 ahead = normalized(sight, {1, 0, 0});
    const bool found = any_friend(s, [&](const Friend& one) {
      // how far from its straight course it may be: a turn, but no farther than it flies
      const double turned = 0.5 * clearance.turn * model::kGravity * time * time;
      const double unsure = one.unsure + std::min(turned, norm(one.velocity) * time);
      const Vec3 apart = one.ned + time * one.velocity - missile_at;
      const double along = dot(apart, ahead);
      const double across = norm(apart - along * ahead);
      // the distance of a point to the surface of the cone
      return along > 0 && along < reach && across * cosine - along * sine <= unsure;
    });
    if (found)
      return true;
  }
  return false;
}

}  // namespace eyrie::pilot
