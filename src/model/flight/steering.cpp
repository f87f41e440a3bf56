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

/// Lift that is wanted, in g: upwards across the path, and to the right.
struct Lift {
  double upwards = 0, sideways = 0;
};

/// Lift that turns the path towards a direction: what turns it, and what carries the weight. Of
/// what is too much the turn is cut, so that the path goes on bending straight at the direction:
/// |turn e + carry| = most is solved for the turn.
Lift lift_towards(const Kinematics& k, const math::SinCos& pitch, const Guidance& wanted,
                  double most, double least, double time) {
  const auto [sin_climb, cos_climb] = pitch;
  const auto [climb, heading] =
      math::sin_cos(*wanted.climb, angle_between(k.heading, wanted.heading));
  const auto [sin_wanted, cos_wanted] = climb;
  const auto [sin_turn, cos_turn] = heading;
  // the direction in the axes of the path: ahead, to the right, up
  const double ahead = cos_climb * cos_wanted * cos_turn + sin_climb * sin_wanted;
  const double right = cos_wanted * sin_turn;
  const double up = cos_climb * sin_wanted - sin_climb * cos_wanted * cos_turn;
  const double across = std::sqrt(right * right + up * up);
  const double angle = math::atan2(across, ahead);
  // straight behind: over the top
  const double e_right = across > 1e-9 ? right / across : 0, e_up = across > 1e-9 ? up / across : 1;
  const double carry = cos_climb, along = e_up * carry;
  const double room = along * along - carry * carry + most * most;
  const double largest = room > 0 ? std::max(std::sqrt(room) - along, 0.0) : 0;
  const double turn = std::min(std::max(k.speed, 1.0) * angle / (time * kGravity), largest);
  Lift lift{carry + turn * e_up, turn * e_right};
  // a little downwards is flown by letting go, not by rolling over
  if (lift.upwards < least && angle < radians(15))
    lift.upwards = least;
  return lift;
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

  const double most = std::max(std::min({load_factor, limits.max_load_factor, c.lift_limit}),
                               std::max(a.push_limit, 0.0));
  const auto [pitch, roll] = math::sin_cos(k.pitch, k.roll);
  const auto [sin_climb, cos_climb] = pitch;
  Lift lift;
  if (wanted.climb) {
    lift = lift_towards(k, pitch, wanted, most, a.push_limit, a.aim_time);
  } else {  // upwards first
    const double climb = wanted_climb(model, k, c, wanted, speed_wanted, slowest, fastest, power);
    const double climb_rate = (climb - sin_climb) / (a.climb_time * std::max(cos_climb, 0.1));
    lift.upwards = std::clamp(cos_climb + speed * climb_rate / kGravity, a.push_limit, most);
    const double turn_rate =
        angle_between(k.heading, wanted.heading) / a.heading_time + wanted.turn_rate;
    const double room = std::sqrt(std::max(most * most - lift.upwards * lift.upwards, 0.0));
    lift.sideways = std::clamp(speed * cos_climb * turn_rate / kGravity, -room, room);
  }

  // bank to that lift; while rolling, pull only what lies along the lift axis already
  Controls controls;
  controls.bank = math::atan2(lift.sideways, lift.upwards);
  controls.load_factor =
      std::clamp(lift.upwards * roll.cos + lift.sideways * roll.sin, a.push_limit, most);

  // thrust for the speed, at the climb angle and load factor that are flown
  const double acceleration = (speed_wanted - k.speed) / a.speed_time;
  const double thrust = c.mass * (acceleration + kGravity * sin_climb) + c.drag(k.load_factor);
  if (thrust < c.thrust.military)
    afterburner = 0;
  controls.throttle = Engine::throttle_for(c.thrust, thrust, afterburner != 0);
  return controls;
}

}  // namespace eyrie::model::flight
