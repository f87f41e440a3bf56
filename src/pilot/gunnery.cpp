// SPDX-License-Identifier: MIT
#include "pilot/gunnery.hpp"

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

const char* why_no_gun(const State& s, const Seen* target, double max_age) {
  if (!target || !target->hostile())
    return "no hostile target";
  if (s.time - target->track->time > max_age)
    return "the target is out of sight";
  return s.gun.rounds == 0 || !s.type.index.gun ? "no rounds" : nullptr;
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
