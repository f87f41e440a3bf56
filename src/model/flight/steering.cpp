// SPDX-License-Identifier: MIT
#include "model/flight/steering.hpp"

namespace eyrie::model::flight {
namespace {

/// Sine of the climb angle that leads to the altitude, as far as energy allows.
double wanted_climb(const PointMass& model, const Kinematics& k, const FlightCondition& c,
                    const Guidance& wanted, double speed_wanted, double slowest, double fastest,
                    double thrust) {
  const Autopilot& a = model.airframe().autopilot;
  const double speed = std::max(k.speed, 1.0);
  const double asked = (wanted.altitude - k.altitude) / (a.altitude_time * speed);
  const double drag = c.drag(1);
  const double excess = (thrust - drag) / c.mass;
  const double too_slow = (speed_wanted - k.speed) / a.speed_time;

  // upwards: excess thrust and excess speed, less the share that goes into speed
  const double for_speed = std::min(too_slow, a.acceleration_share * std::max(excess, 0.0));
  double highest = std::max((excess - for_speed) / kGravity, 0.0);
  highest = std::min(highest, model.steepest_climb());
  // near the slowest speed the nose goes down, whatever was asked
  highest = std::min(highest, (excess + (k.speed - slowest) / a.speed_time) / kGravity);

  // downwards: as steep as the overspeed permits
  const double most = std::min(speed_wanted + a.dive_overspeed, fastest);
  const double too_fast = (k.speed - most) / a.speed_time;
  const double lowest = std::max(
      std::min((c.thrust.idle - drag) / c.mass + too_fast, 0.0) / kGravity, -model.steepest_dive());
  return std::min(std::max(asked, lowest), highest);
}

}  // namespace

double slowest_speed(const Autopilot& autopilot, const Kinematics& k,
                     const FlightCondition& condition) {
  return std::max(k.speed, 1.0) * std::sqrt(autopilot.stall_margin / condition.lift_limit);
}

double fastest_speed(const FlightLimits& limits, const FlightCondition& condition) {
  return std::min(limits.max_mach * condition.speed_of_sound,
                  limits.max_equivalent_airspeed / condition.density_root);
}

Controls steer(const PointMass& model, const Kinematics& k, const FlightCondition& c,
               const Guidance& wanted, double load_factor, std::uint8_t& afterburner) {
  const Autopilot& a = model.airframe().autopilot;
  const FlightLimits& limits = model.airframe().limits;
  const double speed = std::max(k.speed, 1.0);
  const double slowest = slowest_speed(a, k, c);
  const double fastest = fastest_speed(limits, c);
  const double speed_wanted = std::min(std::max(wanted.speed, slowest), fastest);

  // the afterburner is allowed while military power has left it behind
  if (speed_wanted - k.speed > a.afterburner_error)
    afterburner = 1;
  const double power = afterburner ? c.thrust.afterburner : c.thrust.military;

  // wanted lift, upwards and sideways, in g; upwards first
  const auto [sin_climb, cos_climb] = math::sin_cos(k.pitch);
  const double climb = wanted_climb(model, k, c, wanted, speed_wanted, slowest, fastest, power);
  const double climb_rate = (climb - sin_climb) / (a.climb_time * std::max(cos_climb, 0.1));
  const double most = std::max(std::min({load_factor, limits.max_load_factor, c.lift_limit}),
                               std::max(a.push_limit, 0.0));
  const double upwards = std::clamp(cos_climb + speed * climb_rate / kGravity, a.push_limit, most);
  const double turn_rate =
      angle_between(k.heading, wanted.heading) / a.heading_time + wanted.turn_rate;
  const double room = std::sqrt(std::max(most * most - upwards * upwards, 0.0));
  const double sideways = std::clamp(speed * cos_climb * turn_rate / kGravity, -room, room);

  // bank to that lift; while rolling, pull only what lies along the lift axis already
  Controls controls;
  controls.bank = math::atan2(sideways, upwards);
  const auto [sin_roll, cos_roll] = math::sin_cos(k.roll);
  controls.load_factor = std::clamp(upwards * cos_roll + sideways * sin_roll, a.push_limit, most);

  // thrust for the speed, at the climb angle and load factor that are flown
  const double acceleration = (speed_wanted - k.speed) / a.speed_time;
  const double thrust = c.mass * (acceleration + kGravity * sin_climb) + c.drag(k.load_factor);
  if (thrust < c.thrust.military)
    afterburner = 0;
  controls.throttle = Engine::throttle_for(c.thrust, thrust, afterburner != 0);
  return controls;
}

}  // namespace eyrie::model::flight
