// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one aircraft's autopilot remembers, what its engines do and how much fuel is left.
#include "core/field.hpp"

namespace eyrie::model::flight {

/// How far along its flight's routes an aircraft is.
struct NavState {
  std::uint16_t leg = 0;   ///< index of the waypoint flown to; their number: past the last
  std::uint8_t route = 0;  ///< index into Flight::routes
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(field("leg", &NavState::leg), field("route", &NavState::route),
                      field("reserved", &NavState::reserved));
  }
};

/// What the wing and the engines allow, as a pilot knows it of his aircraft when he decides.
struct Energy {
  float available = 0;     ///< g, the most that structure and wing give
  float sustained = 0;     ///< g that full power holds without losing speed or height
  float corner_speed = 0;  ///< m/s true airspeed: the slowest at which the structure's limit is had
  float excess_power = 0;  ///< m/s of climb at full power in straight flight

  static constexpr auto fields() {
    return field_list(field("available", &Energy::available),
                      field("sustained", &Energy::sustained),
                      field("corner_speed", &Energy::corner_speed, "m/s"),
                      field("excess_power", &Energy::excess_power, "m/s"));
  }
};

/// Written in move.
struct Flying {
  double lead_heading = 0;       ///< rad, low-passed heading of who is followed
  double last_heading_rate = 0;  ///< rad/s, laero: of the step before (Adams-Bashforth)
  double last_pitch_rate = 0;    ///< rad/s, laero
  double last_acceleration = 0;  ///< m/s2, laero
  Vec3 last_velocity = {};       ///< m/s, laero
  Energy energy = {};
  NavState nav = {};
  std::uint8_t started = 0;      ///< laero: 1 once the rates of the step before are there
  std::uint8_t following = 0;    ///< 1 while lead_heading is being tracked
  std::uint8_t afterburner = 0;  ///< point_mass: 1 while the autopilot lets itself use it
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(field("lead_heading", &Flying::lead_heading, "rad"),
                      field("last_heading_rate", &Flying::last_heading_rate, "rad/s"),
                      field("last_pitch_rate", &Flying::last_pitch_rate, "rad/s"),
                      field("last_acceleration", &Flying::last_acceleration, "m/s2"),
                      field("last_velocity", &Flying::last_velocity, "m/s"),
                      field("energy", &Flying::energy), field("nav", &Flying::nav),
                      field("started", &Flying::started), field("following", &Flying::following),
                      field("afterburner", &Flying::afterburner),
                      field("reserved", &Flying::reserved));
  }
};

/// Written in move.
struct Propulsion {
  double fuel = 0;      ///< kg on board
  double flow = 0;      ///< kg/s burned
  double throttle = 0;  ///< 0 idle .. 1 military power .. 2 full afterburner
  double thrust = 0;    ///< N

  static constexpr auto fields() {
    return field_list(
        field("fuel", &Propulsion::fuel, "kg"), field("flow", &Propulsion::flow, "kg/s"),
        field("throttle", &Propulsion::throttle), field("thrust", &Propulsion::thrust, "N"));
  }
};

/// Takes what `flow` burns in `dt` seconds out of the tanks. True when they run dry right now.
[[nodiscard]] auto burn(auto& p, double dt) {
  const auto left = p.fuel - p.flow * dt;
  const auto empty = p.fuel <= 0, is_left = left > 0;
  p.fuel = math::select(empty, p.fuel, math::select(is_left, left, 0));
  return !(empty | is_left);
}

}  // namespace eyrie::model::flight
