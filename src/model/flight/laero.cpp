// SPDX-License-Identifier: MIT
#include "model/flight/laero.hpp"

#include <algorithm>

namespace eyrie::model::flight {
namespace {

/// Adams-Bashforth of order two: what one step adds.
double increment(double rate, double last_rate, double dt) {
  return dt * (1.5 * rate - 0.5 * last_rate);
}

/// Time constant of the climb angle, s: the loop around Adams-Bashforth needs a few steps.
constexpr double kPitchTime = 0.25;

}  // namespace

double Laero::turn_rate_limit(double speed, double load_factor) const {
  const double sideways =
      std::min(math::tan(max_bank), std::sqrt(std::max(load_factor * load_factor - 1, 0.0)));
  return std::min(max_turn_rate, kGravity * sideways / std::max(speed, 1.0));
}

void Laero::step(Kinematics& k, Flying& memory, const Guidance& wanted, double turn_limit,
                 const Propulsion& engines, const Air& air, const Vec3& wind_ned, double dt) const {
  const bool powered = fuel_flow == 0 || engines.fuel > 0;
  const double speed = std::max(k.speed, 1.0);

  // heading: the short way, no faster than the turn rate, the bank and the load factor allow
  const double heading_rate =
      std::clamp(angle_between(k.heading, wanted.heading) / heading_time + wanted.turn_rate,
                 -turn_limit, turn_limit);

  // altitude by climb angle
  const double climb = powered ? std::clamp((wanted.altitude - k.altitude) / altitude_time,
                                            -max_climb_rate, max_climb_rate)
                               : -max_climb_rate;
  const double wanted_pitch = std::clamp(climb / speed, -1.0, 1.0);
  const double pitch_change =
      std::clamp((wanted_pitch - k.pitch) / kPitchTime, -pitch_rate, pitch_rate);

  // speed
  const double wanted_speed = powered ? std::clamp(wanted.speed, min_speed, max_speed) : min_speed;
  const double acceleration =
      std::clamp((wanted_speed - k.speed) / speed_time, -max_acceleration, max_acceleration);

  const auto remember = [&] {
    memory.started = 1;
    memory.last_heading_rate = heading_rate;
    memory.last_pitch_rate = pitch_change;
    memory.last_acceleration = acceleration;
    memory.last_velocity = k.velocity;
  };
  if (!memory.started)  // the first step has no step before it
    remember();
  k.position += dt * (1.5 * k.velocity - 0.5 * memory.last_velocity);
  k.heading = wrap_pi(k.heading + increment(heading_rate, memory.last_heading_rate, dt));
  k.pitch += increment(pitch_change, memory.last_pitch_rate, dt);
  k.speed = std::max(k.speed + increment(acceleration, memory.last_acceleration, dt), 0.0);
  remember();

  // the bank of a coordinated turn, for show
  const double bank = math::atan(speed * heading_rate / kGravity);
  k.roll += std::clamp(bank - k.roll, -roll_rate * dt, roll_rate * dt);

  const auto [sin_heading, cos_heading] = math::sin_cos(k.heading);
  const auto [sin_pitch, cos_pitch] = math::sin_cos(k.pitch);
  const double level = k.speed * cos_pitch;
  k.velocity = (level * cos_heading + wind_ned.x) * k.north +
               (level * sin_heading + wind_ned.y) * k.east + (-k.speed * sin_pitch) * k.down;
  k.mach = k.speed / air.speed_of_sound;
  k.load_factor = 1 / math::cos(k.roll);
}

}  // namespace eyrie::model::flight
