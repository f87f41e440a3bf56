// SPDX-License-Identifier: MIT
#include "pilot/fight.hpp"

namespace eyrie::pilot {

double speed_of(const State& s, double mach) {
  return mach * s.library.environment.atmosphere.at(s.own.altitude).speed_of_sound;
}

double load_for_energy(const State& s, double slowest, double most) {
  if (slowest <= 0)
    return most;
  const auto& energy = s.flying.energy;
  const double available = static_cast<double>(energy.available);
  const double sustained = std::max(static_cast<double>(energy.sustained), 1.0);
  const double corner = std::max(static_cast<double>(energy.corner_speed), slowest * 1.01);
  double load = sustained;
  if (s.own.speed >= slowest)
    load += std::max(available - sustained, 0.0) *
            std::min((s.own.speed - slowest) / (corner - slowest), 1.0);
  else  // half of what would hold the speed, at nine tenths of the slowest
    load *= std::max(1 - 5 * (1 - s.own.speed / slowest), 0.5);
  return std::clamp(load, 1.0, std::max(most, 1.0));
}

double slope_for_energy(const State& s, double floor) {
  const double corner = std::max(static_cast<double>(s.flying.energy.corner_speed), 1.0);
  const double excess = s.own.speed / corner - 1;
  // 45 degrees at twenty percent away from it
  const double slope = std::clamp(excess * (kPi / 4 / 0.2), -kPi / 4, kPi / 4);
  // on the way down an arc of three radii is left
  const double radius = s.own.speed * s.own.speed / (3 * model::kGravity);
  const double room = std::clamp((s.own.altitude - floor) / radius, 0.0, 1.0);
  return slope < 0 ? slope * room : slope;
}

Vec3 raised(const Vec3& ned, double angle) {
  const Vec3 unit = normalized(ned, {1, 0, 0});
  const double level = std::sqrt(unit.x * unit.x + unit.y * unit.y);
  if (level < 1e-9)
    return unit;
  // up, across the direction
  const Vec3 up{-unit.x * -unit.z / level, -unit.y * -unit.z / level, -level};
  const auto [sine, cosine] = math::sin_cos(angle);
  return cosine * unit + sine * up;
}

double steepest_above(const State& s, double floor, double load_factor) {
  constexpr double kReaction = 0.8;  // s, to the next decision and until its load is there
  constexpr double kHeld = 0.8;      // of the load, while the speed changes
  const double load = kHeld * std::min(load_factor, static_cast<double>(s.flying.energy.available));
  // a dive of angle c is pulled out of within V2 (1 - cos c) / (g (n - 1))
  const double radius = s.own.speed * s.own.speed / (model::kGravity * std::max(load - 1, 0.1));
  const double upright = std::fabs(s.own.roll) / s.airframe().limits.roll_rate;
  const double sunk = std::max(s.velocity_ned.z, 0.0) * (kReaction + upright);
  return math::acos(1 - std::clamp((s.own.altitude - sunk - floor) / radius, 0.0, 1.0));
}

double fastest_turn(const State& s) {
  return static_cast<double>(s.flying.energy.available) * model::kGravity /
         std::max(s.own.speed, 1.0);
}

double held_back(const State& s, const Seen& target, std::optional<double> overtake, double speed) {
  if (!overtake)
    return speed;
  const double his = norm(s.velocity_of(target) - s.wind());
  return std::clamp(his + *overtake, speed / 2, speed);
}

void aim(const State& s, const Vec3& direction, const Pull& pull, Action& action) {
  constexpr double kBack = 5;             // s, to come back to the floor from below
  constexpr double kSteepestBack = 0.35;  // rad
  const double steepest = steepest_above(s, pull.floor, pull.most);
  const double below = (pull.floor - s.own.altitude) / (kBack * std::max(s.own.speed, 1.0));
  const double lowest = below > 0 ? std::min(below, kSteepestBack) : -steepest;
  action.heading = wrap_tau(bearing_of(direction));
  action.climb = std::max(elevation_of(direction), lowest);
  action.load_factor = pull.load_factor;
  if (s.own.pitch < -steepest) {  // out of the dive first
    action.heading = wrap_tau(s.own.heading);
    action.climb = std::max(lowest, 0.0);
    action.load_factor = pull.most;
  } else if (elevation_of(normalized(direction, {}) + s.nose()) < lowest) {
    // the straight way there leads too low: round the side
    const double side = angle_between(s.own.heading, *action.heading) >= 0 ? 1 : -1;
    action.heading = wrap_tau(s.own.heading + side * kPi / 2);
  }
  action.altitude = std::max(s.altitude_for(*action.climb), pull.floor);  // for who blends it
  action.speed = pull.speed;
  action.mode = model::AutopilotMode::aim;
}

Status Maneuver::fly(const State& s, const Seen* target, const Vec3& direction, double load_factor,
                     Proposal& out) const {
  aim(s, direction, {load_factor, load_factor_, speed_, floor_}, out.action);
  if (target)
    out.action.target = target->id();
  out.vote = vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
