// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the pilot asked of the aircraft: written in decide, read in act and move.
#include "core/field.hpp"

namespace eyrie::model {

/// What the autopilot does with a Command.
enum class AutopilotMode : std::uint8_t {
  hold,    ///< heading, altitude and speed
  route,   ///< a route of the flight
  follow,  ///< a place beside somebody
  loiter,  ///< a circle
  aim,     ///< a direction of flight, whichever way up: the lift vector goes to it
};
constexpr auto names_of(AutopilotMode) {
  return names_from_zero<AutopilotMode>("hold", "route", "follow", "loiter", "aim");
}

/// g: who may use less could neither turn nor end a descent.
inline constexpr double kLeastLoadFactor = 1.2;

/// The flight command of one aircraft, executed by the autopilot at the rate of the kinematics.
struct Command {
  double heading = 0;   ///< rad, true: hold, aim
  double altitude = 0;  ///< m: hold, loiter, follow (the reference's altitude + offset)
  double speed = 0;     ///< m/s true airspeed: hold, loiter, aim; route where a waypoint says none
  double climb = 0;     ///< rad above the horizontal: aim
  double load_factor = 5;  ///< g, the most that turning may use; kLeastLoadFactor is always free
  /// follow: last known position of who is followed (local frame, m), valid at reference_time.
  /// loiter: the center.
  Vec3 reference_position = {};
  Vec3 reference_velocity = {};  ///< m/s, local frame
  double reference_time = 0;     ///< s
  Vec3 offset = {};              ///< follow: m, forward / right / down of the reference's heading
  double loiter_radius = 0;      ///< m
  AutopilotMode mode = AutopilotMode::hold;
  std::uint8_t route = 0;  ///< route: which route of the flight, an index into Flight::routes
  std::uint8_t reserved[6] = {};

  static constexpr auto fields() {
    return field_list(
        field("heading", &Command::heading, "rad"), field("altitude", &Command::altitude, "m"),
        field("speed", &Command::speed, "m/s"), field("climb", &Command::climb, "rad"),
        field("load_factor", &Command::load_factor),
        field("reference_position", &Command::reference_position, "m"),
        field("reference_velocity", &Command::reference_velocity, "m/s"),
        field("reference_time", &Command::reference_time, "s"),
        field("offset", &Command::offset, "m"),
        field("loiter_radius", &Command::loiter_radius, "m"), field("mode", &Command::mode),
        field("route", &Command::route), field("reserved", &Command::reserved));
  }
};

/// What a pilot throws out against missiles, as bits.
enum class Dispense : std::uint8_t { none, chaff, flares, both };
constexpr auto names_of(Dispense) {
  return names_from_zero<Dispense>("none", "chaff", "flares", "both");
}

/// Everything an aircraft is asked to do besides flying. Zero means nothing is asked.
struct Request {
  TrackId target;               ///< the chosen target: radar lock, Tacview, first shooter rule
  TrackId shoot_at;             ///< release a weapon at this track
  std::uint8_t store = 0;       ///< 1 + index of the store type to release
  std::uint8_t trigger = 0;     ///< 1: gun trigger pressed
  std::uint8_t radar_off = 0;   ///< 1: silent
  std::uint8_t radar_lock = 0;  ///< 1: the radar tracks `target` and nothing else
  Dispense dispense = Dispense::none;
  std::uint8_t reserved[3] = {};

  static constexpr auto fields() {
    return field_list(field("target", &Request::target), field("shoot_at", &Request::shoot_at),
                      field("store", &Request::store), field("trigger", &Request::trigger),
                      field("radar_off", &Request::radar_off),
                      field("radar_lock", &Request::radar_lock),
                      field("dispense", &Request::dispense), field("reserved", &Request::reserved));
  }
};

}  // namespace eyrie::model
