// SPDX-License-Identifier: MIT
#pragma once
/// \file  laero: the simple model that the paper's aircraft flew. Heading, altitude and speed
/// follow what is asked within rate limits; no forces, no stall, no ceiling. docs/models/flight.md.
#include "model/environment.hpp"
#include "model/flight/flying.hpp"
#include "model/flight/guidance.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model::flight {

/// Rate limits and time constants. Const and shared.
struct Laero {
  double max_turn_rate = si(3, "deg/s");       ///< rad/s
  double max_bank = si(30, "deg");             ///< rad
  double max_climb_rate = si(2000, "ft/min");  ///< m/s
  double max_acceleration = si(5, "kt");       ///< m/s^2
  double roll_rate = si(10, "deg/s");          ///< rad/s
  double pitch_rate = si(10, "deg/s");         ///< rad/s
  double heading_time = 1;                     ///< s
  double altitude_time = 4;                    ///< s
  double speed_time = 1;                       ///< s
  double min_speed = si(100, "kt");            ///< m/s
  double max_speed = si(1200, "kt");           ///< m/s
  double fuel_flow = 0;                        ///< kg/s

  static constexpr std::string_view type_name = "laero";
  static constexpr std::string_view help = "rate limits of heading, altitude and speed";
  static constexpr auto params() {
    using L = Laero;
    return Lines{
        param("max_turn_rate", &L::max_turn_rate, "rad/s", range(0.05, 60, "deg/s"),
              "of the heading"),
        param("max_bank", &L::max_bank, "rad", range(0.5, 85, "deg"),
              "turns no tighter than a level turn at this bank"),
        param("max_climb_rate", &L::max_climb_rate, "m/s", range(0.1, 500), "up and down"),
        param("max_acceleration", &L::max_acceleration, "m/s2", range(0.01, 100),
              "faster and slower"),
        param("roll_rate", &L::roll_rate, "rad/s", range(0.5, 600, "deg/s"),
              "of the bank, which is for show"),
        param("pitch_rate", &L::pitch_rate, "rad/s", range(0.5, 600, "deg/s"),
              "of the climb angle"),
        param("heading_time", &L::heading_time, "s", range(0.05, 60), "heading error over rate"),
        param("altitude_time", &L::altitude_time, "s", range(0.05, 60),
              "altitude error over climb rate"),
        param("speed_time", &L::speed_time, "s", range(0.05, 60), "speed error over acceleration"),
        param("min_speed", &L::min_speed, "m/s", range(1, 1000), "flies no slower"),
        param("max_speed", &L::max_speed, "m/s", range(1, 2000), "flies no faster"),
        param("fuel_flow", &L::fuel_flow, "kg/s", range(0, 100), "constant; 0: fuel never ends")};
  }

  /// rad/s, the largest at a speed (m/s) and a load factor (g): turn rate, bank and load factor.
  [[nodiscard]] double turn_rate_limit(double speed, double load_factor) const;

  /// One step of `dt` (s) towards what is asked, turning at most at `turn_limit` (rad/s). Without
  /// fuel it can neither accelerate nor climb: it sinks at the largest climb rate and slows down.
  /// Integration is Adams-Bashforth of two steps, the first one Euler. Leaves position, velocity,
  /// heading, pitch, roll, speed, mach and load factor; the caller sets the vertical axes and the
  /// altitude of the new position.
  void step(Kinematics& k, Flying& memory, const Guidance& wanted, double turn_limit,
            const Propulsion& engines, const Air& air, const Vec3& wind_ned, double dt) const;
};

}  // namespace eyrie::model::flight
