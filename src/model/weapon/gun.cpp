// SPDX-License-Identifier: MIT
#include "model/weapon/gun.hpp"

#include <algorithm>

#include "model/environment.hpp"

namespace eyrie::model::weapon {

GunState loaded(const GunType& gun) {
  return {.rounds = gun.rounds};
}

double time_of_flight(const GunType& gun, double density, double speed, double distance) {
  const double k = density * gun.drag / 2;
  const double kx = k * distance;
  // below 1e-6 the exponential loses more digits than the drag takes speed
  return kx < 1e-6 ? distance / speed : (math::exp(kx) - 1) / (k * speed);
}

Lead lead_on(const GunType& gun, double density, const Kinematics& own, const Vec3& nose,
             const Kinematics& target) {
  const Vec3 apart = target.position - own.position;
  Lead lead{.range = norm(apart)};
  // the round starts with the shooter's velocity: in still air it flies at their sum
  Vec3 aim = apart;
  for (int i = 0; i < 3; ++i) {
    const double speed = norm(gun.muzzle_velocity * normalized(aim, nose) + own.velocity);
    const double distance = norm(apart + lead.flight_time * target.velocity);
    lead.flight_time = time_of_flight(gun, density, speed, distance);
    // where the target will be, less what the shooter's velocity does for the round, plus its drop
    const double t = lead.flight_time;
    aim = apart + t * (target.velocity - own.velocity) - (kGravity * t * t / 2) * own.down;
  }
  lead.direction = normalized(aim, nose);
  lead.off_bore = angle_between(lead.direction, nose);
  return lead;
}

double hit_probability(const GunType& gun, const Lead& lead, const Signature& size,
                       const Kinematics& target) {
  if (lead.range > gun.greatest_range || lead.off_bore > gun.aim_cone || lead.range < 1)
    return 0;
  const double n = target.load_factor;
  const double turning = kGravity * std::sqrt(std::max(n * n - 1, 0.0));
  const double t = lead.flight_time;
  const double unpredicted = gun.maneuver_error * turning * t * t / (2 * lead.range);
  const double sigma2 =
      gun.dispersion * gun.dispersion + gun.aim_error * gun.aim_error + unpredicted * unpredicted;
  const double area = silhouette(size, body_axes(target), -lead.direction);
  return 1 - math::exp(-area / (2 * kPi * sigma2 * lead.range * lead.range));
}

std::uint32_t fire(const GunType& gun, double dt, GunState& state) {
  state.owed += gun.rate * dt;
  const double whole = std::floor(state.owed + 1e-9);
  state.owed = std::max(state.owed - whole, 0.0);
  const auto rounds = std::min(static_cast<std::uint32_t>(whole), state.rounds);
  state.rounds -= rounds;
  state.burst_rounds += rounds;
  return rounds;
}

}  // namespace eyrie::model::weapon
