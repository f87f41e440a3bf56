// SPDX-License-Identifier: MIT
#pragma once
/// \file  A type of ground vehicle: how it drives, who looks out of it, by what radio it talks.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/units.hpp"
#include "model/flight/guidance.hpp"

namespace eyrie::model::vehicle {

/// Const and shared. docs/models/vehicle.md has the equations and what they are worth.
struct VehicleType {
  std::string label;  ///< what the story and Tacview call it: "M939"
  double wheelbase = 4.5;
  double top_speed = si(85, "km/h");
  double acceleration = 1;
  double braking = 3;
  double side_acceleration = 2.5;
  double steering_angle = si(32, "deg");
  double steering_rate = si(20, "deg/s");
  double heading_time = 0.8;
  double lookahead_time = 2;
  double capture_radius = 25;
  double gap_gain = 0.25;
  std::optional<std::string> visual, datalink;

  /// Indices into the shelves of the Library: the names above, looked up.
  struct Indices {
    std::optional<std::uint16_t> visual, datalink;
  };
  Indices index;
  flight::GuidanceGains guidance;  ///< what prepare() makes of the parameters

  static constexpr std::string_view type_name = "vehicle";
  static constexpr std::string_view help = "a type of ground vehicle";
  static constexpr auto params() {
    using V = VehicleType;
    return std::tuple{
        param("label", &V::label, "name in the story and in Tacview").items(1, 40).required(),
        param("wheelbase", &V::wheelbase, "m", range(0.5, 20), "from axle to axle"),
        param("top_speed", &V::top_speed, "m/s", range(1, 100), "drives no faster"),
        param("acceleration", &V::acceleration, "m/s2", range(0.1, 15), "the most it gathers"),
        param("braking", &V::braking, "m/s2", range(0.1, 15), "the most it loses"),
        param("side_acceleration", &V::side_acceleration, "m/s2", range(0.1, 15),
              "the most in a turn: slows down for tighter ones"),
        param("steering_angle", &V::steering_angle, "rad", range(0.01, 1.2),
              "of the front wheels, the most"),
        param("steering_rate", &V::steering_rate, "rad/s", range(0.01, 10),
              "how fast the front wheels turn"),
        param("heading_time", &V::heading_time, "s", range(0.1, 30),
              "heading error over turn rate asked for"),
        param("lookahead_time", &V::lookahead_time, "s", range(0.2, 60),
              "route: aims at the leg this far ahead"),
        param("capture_radius", &V::capture_radius, "m", range(1, 1000),
              "route: a waypoint this near counts as reached"),
        param("gap_gain", &V::gap_gain, "Hz", range(0.01, 2),
              "column: closing speed per distance too far behind"),
        param("visual", &V::visual, "the eyes of its driver; none: sees nobody"),
        param("datalink", &V::datalink, "its radio; none: hears nobody")};
  }

  /// m, with the wheels turned all the way.
  [[nodiscard]] double turn_radius() const;
  /// Makes `guidance` of the parameters.
  void prepare();
};

}  // namespace eyrie::model::vehicle
