// SPDX-License-Identifier: MIT
#include "model/flight/performance.hpp"

#include "model/flight/equations.hpp"

namespace eyrie::model::flight {
namespace {

constexpr double kMilitary = 1;  // throttle

double thrust_of(const FlightCondition& c, Power power) {
  return power == Power::military ? c.thrust.military : c.thrust.afterburner;
}

/// Where a function of the altitude or the Mach number, true below and false above, changes.
template <class Holds>
double last(double low, double high, Holds holds) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

FlightCondition Performance::at(double mach, double altitude) const {
  const Air air = standard_air(altitude);
  Kinematics k;
  k.speed = mach * air.speed_of_sound;
  k.altitude = altitude;
  return Equations<double>({&model}).condition(k, air, fuel, load);
}

double Performance::excess_power(double mach, double altitude, Power power,
                                 double load_factor) const {
  const FlightCondition c = at(mach, altitude);
  if (c.lift_limit < load_factor)
    return -math::kInfinity;
  return (thrust_of(c, power) - c.drag(load_factor)) / (c.mass * kGravity) * mach *
         c.speed_of_sound;
}

double Performance::greatest_load_factor(double mach, double altitude) const {
  return std::min(at(mach, altitude).lift_limit, model.airframe().limits.max_load_factor);
}

double Performance::sustained_load_factor(double mach, double altitude, Power power) const {
  const FlightCondition c = at(mach, altitude);
  const double thrust = thrust_of(c, power);
  const double most = std::min(c.lift_limit, model.airframe().limits.max_load_factor);
  if (most < 1 || c.drag(1) > thrust)
    return 0;
  return last(1, most, [&](double g) { return c.drag(g) <= thrust; });
}

double Performance::top_mach(double altitude, Power power) const {
  for (double mach = 3; mach > 0.3; mach -= 0.005)
    if (excess_power(mach, altitude, power) > 0)
      return mach;
  return 0;
}

double Performance::ceiling(double climb_rate, Power power) const {
  const auto climbs = [&](double altitude) {
    for (double mach = 0.5; mach < model.airframe().limits.max_mach; mach += 0.02)
      if (excess_power(mach, altitude, power) > climb_rate)
        return true;
    return false;
  };
  return last(0, 30e3, climbs);
}

double Performance::acceleration_time(double altitude, double from, double to) const {
  double time = 0;
  const int steps = static_cast<int>(std::lround((to - from) / 0.01));
  for (int i = 0; i < steps; ++i) {
    const FlightCondition c = at(from + 0.01 * (i + 0.5), altitude);
    const double acceleration = (c.thrust.afterburner - c.drag(1)) / c.mass;
    if (acceleration <= 0)
      return math::kInfinity;
    time += 0.01 * c.speed_of_sound / acceleration;
  }
  return time;
}

double Performance::flow(const FlightCondition& c, double throttle) const {
  return Equations<double>({&model}).flow_of(c.thrust, throttle, c.mach, c.temperature);
}

double Performance::cruise_flow(double mach, double altitude) const {
  const FlightCondition c = at(mach, altitude);
  const double drag = c.drag(1);
  return drag <= c.thrust.military && c.lift_limit >= 1
             ? flow(c, Engine::throttle_for(c.thrust, drag, false))
             : math::kInfinity;
}

Cruise Performance::best_cruise(double lowest, double highest) const {
  constexpr double kStep = 100;  // m
  const FlightCondition ground = at(0, 0);
  const double left = 0.07 * fuel;
  Performance now = *this;
  now.fuel -= 120 * flow(ground, kMilitary);

  Cruise best;
  double over_ground = 0;
  for (double altitude = 0; altitude <= highest; altitude += kStep) {
    // cruise here, in ten pieces of equal fuel
    for (double mach = 0.4; altitude >= lowest && mach < 0.98; mach += 0.01) {
      Performance piece = now;
      const double share = (now.fuel - left) / 10;
      double range = over_ground, seconds = 0;
      for (int i = 0; i < 10; ++i) {
        piece.fuel = now.fuel - (i + 0.5) * share;
        const double burnt = piece.cruise_flow(mach, altitude);
        seconds += share / burnt;
        range += share / burnt * mach * standard_air(altitude).speed_of_sound;
        if (burnt == math::kInfinity)
          range = -math::kInfinity;
      }
      if (range > best.range)
        best = {.range = range, .altitude = altitude, .mach = mach, .flow = 10 * share / seconds};
    }
    // climb on
    const double mach = std::min(0.85, 300 / standard_air(altitude).speed_of_sound);
    const FlightCondition c = now.at(mach, altitude);
    const double rate = now.excess_power(mach, altitude, Power::military);
    if (rate < 1)
      break;
    now.fuel -= kStep / rate * flow(c, kMilitary);
    over_ground += kStep / rate * mach * c.speed_of_sound;
  }
  return best;
}

double turn_rate(double load_factor, double speed) {
  return load_factor > 1 ? kGravity * std::sqrt(load_factor * load_factor - 1) / speed : 0;
}

}  // namespace eyrie::model::flight
