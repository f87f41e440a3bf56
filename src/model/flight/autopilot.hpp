// SPDX-License-Identifier: MIT
#pragma once
/// \file  The autopilot: from a Command to what the inner loops hold. Const gains; the memory is in
/// the Flying row.
#include "model/command.hpp"
#include "model/flight/guidance.hpp"

namespace eyrie::model::flight {

/// Gains and limits. The guidance serves both dynamics, the rest is for point_mass (laero has its
/// own rate limits). Const and shared.
struct Autopilot {
  GuidanceGains guidance;
  double heading_time = 1.2;               ///< s
  double aim_time = 0.6;                   ///< s
  double altitude_time = 5;                ///< s
  double climb_time = 1;                   ///< s
  double speed_time = 4;                   ///< s
  double max_climb_angle = si(35, "deg");  ///< rad
  double max_dive_angle = si(40, "deg");   ///< rad
  double push_limit = 0;
  double stall_margin = 1.3;
  double acceleration_share = 0.5;
  double dive_overspeed = 50;     ///< m/s
  double afterburner_error = 15;  ///< m/s

  static constexpr std::string_view type_name = "autopilot";
  static constexpr std::string_view help = "holds heading, altitude and speed; routes, formation";
  static constexpr auto params() {
    using A = Autopilot;
    return Lines{
        param("guidance", &A::guidance, "gains of route, follow and loiter guidance"),
        param("heading_time", &A::heading_time, "s", range(0.1, 60),
              "heading error over turn rate"),
        param("aim_time", &A::aim_time, "s", range(0.1, 60),
              "aim: error of the direction of flight over its rate of turn"),
        param("altitude_time", &A::altitude_time, "s", range(0.5, 60),
              "altitude error over climb rate"),
        param("climb_time", &A::climb_time, "s", range(0.1, 60),
              "time constant of the climb angle"),
        param("speed_time", &A::speed_time, "s", range(0.2, 60), "speed error over acceleration"),
        param("max_climb_angle", &A::max_climb_angle, "rad", range(0.5, 80, "deg"),
              "climbs no steeper"),
        param("max_dive_angle", &A::max_dive_angle, "rad", range(0.5, 80, "deg"),
              "dives no steeper"),
        param("push_limit", &A::push_limit, range(-3, 1), "g, least load factor it asks for"),
        param("stall_margin", &A::stall_margin, range(1.02, 4),
              "g that the wing must be able to give at the slowest speed it flies"),
        param("acceleration_share", &A::acceleration_share, range(0, 1),
              "part of the excess thrust that goes into speed when it should also climb"),
        param("dive_overspeed", &A::dive_overspeed, "m/s", range(0, 300),
              "by so much a dive may exceed the speed asked for"),
        param("afterburner_error", &A::afterburner_error, "m/s", range(1, 300),
              "lights the afterburner when it is slower than asked by more")};
  }
};

/// Turns a command into heading, altitude and speed. Keeps the leg, and the low-passed heading of
/// who is followed, in `memory`; `time` and `dt` in s. The leg counts on in every mode, so that a
/// wingman who becomes the lead knows where the flight is going. `routes` are those of the flight;
/// at `turn_radius` (m, of its tightest turn) turns onto a leg begin, and no circle is tighter.
[[nodiscard]] Guidance guide(const Autopilot& autopilot, const Kinematics& own,
                             const Command& command, std::span<const Route> routes,
                             double turn_radius, Flying& memory, const Vec3& wind_ned, double time,
                             double dt);

}  // namespace eyrie::model::flight
