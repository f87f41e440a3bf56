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

}  // namespace eyrie::pilot
