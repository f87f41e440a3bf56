// SPDX-License-Identifier: MIT
#pragma once
/// \file  What an aircraft can do, from the same forces that fly it: what tests and plots compare
/// with published figures. In still standard air; nothing here runs in a step.
#include "model/flight/point_mass.hpp"

namespace eyrie::model::flight {

enum class Power : std::uint8_t { military, afterburner };

/// Least fuel burnt over a distance in level flight.
struct Cruise {
  double range = 0;     ///< m, climb included
  double altitude = 0;  ///< m
  double mach = 0;
  double flow = 0;  ///< kg/s, mean of the cruise
};

/// One aircraft with its stores and fuel (kg).
struct Performance {
  const PointMass& model;
  Load load{};
  double fuel = 0;

  [[nodiscard]] FlightCondition at(double mach, double altitude) const;
  /// Thrust less drag over weight times speed, m/s; -infinity beyond the lift limit.
  [[nodiscard]] double excess_power(double mach, double altitude, Power power,
                                    double load_factor = 1) const;
  /// g that it can hold at constant speed and altitude; 0 where it cannot fly level.
  [[nodiscard]] double sustained_load_factor(double mach, double altitude,
                                             Power power = Power::afterburner) const;
  /// g that wing and structure allow.
  [[nodiscard]] double greatest_load_factor(double mach, double altitude) const;
  /// Fastest level flight, found downwards from Mach 3; 0 if there is none.
  [[nodiscard]] double top_mach(double altitude, Power power) const;
  /// m, the highest at which it climbs at `climb_rate` (m/s) below `limits.max_mach`.
  [[nodiscard]] double ceiling(double climb_rate, Power power) const;
  /// s in level flight with full afterburner; infinity if it does not get there.
  [[nodiscard]] double acceleration_time(double altitude, double from, double to) const;
  /// kg/s at a throttle of 0 to 2, where 1 is military power and more is afterburner.
  [[nodiscard]] double flow(const FlightCondition& condition, double throttle) const;
  /// kg/s in level flight; infinity where military power does not hold it.
  [[nodiscard]] double cruise_flow(double mach, double altitude) const;
  /// How far it flies on its fuel between `lowest` and `highest` altitude: two minutes at military
  /// power on the ground, a climb with it at Mach 0.85 or 300 m/s, a cruise at the best altitude
  /// and speed, 7 % of the fuel left. The stores stay on board.
  [[nodiscard]] Cruise best_cruise(double lowest, double highest) const;
};

/// rad/s of a level turn.
[[nodiscard]] double turn_rate(double load_factor, double speed);

}  // namespace eyrie::model::flight
