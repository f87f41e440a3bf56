// SPDX-License-Identifier: MIT
#pragma once
/// \file  A type of ground vehicle, its rows, and how it moves over the surface of the ellipsoid.
#include "model/entity_type.hpp"
#include "model/flight/flying.hpp"
#include "model/flight/guidance.hpp"
#include "model/frames.hpp"
#include "model/kinematics.hpp"
#include "model/track.hpp"

namespace eyrie::model::vehicle {

/// Const and shared. docs/models/vehicle.md has the equations and what they are worth.
struct VehicleType {
  std::string label;                       ///< what the story and Tacview call it: "M939"
  std::string entity_type = "1.1";         ///< see EntityType
  double wheelbase = 4.5;                  ///< m
  double top_speed = si(85, "km/h");       ///< m/s
  double acceleration = 1;                 ///< m/s^2
  double braking = 3;                      ///< m/s^2
  double side_acceleration = 2.5;          ///< m/s^2
  double steering_angle = si(32, "deg");   ///< rad
  double steering_rate = si(20, "deg/s");  ///< rad/s
  double heading_time = 0.8;               ///< s
  double lookahead_time = 2;               ///< s
  double capture_radius = 25;              ///< m
  double gap_gain = 0.25;                  ///< Hz
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
    return Lines{
        param("label", &V::label, "name in the story and in Tacview").items(1, 40).required(),
        param("entity_type", &V::entity_type, kEntityTypeHelp).items(3, 27),
        param("wheelbase", &V::wheelbase, "m", range(0.5, 20), "from axle to axle"),
        param("top_speed", &V::top_speed, "m/s", range(1, 100), "drives no faster"),
        param("acceleration", &V::acceleration, "m/s2", range(0.1, 15), "the most it gathers"),
        param("braking", &V::braking, "m/s2", range(0.1, 15), "the most it loses"),
        param("side_acceleration", &V::side_acceleration, "m/s2", range(0.1, 15),
              "the most in a turn: slows down for tighter ones"),
        param("steering_angle", &V::steering_angle, "rad", range(0.5, 70, "deg"),
              "of the front wheels, the most"),
        param("steering_rate", &V::steering_rate, "rad/s", range(0.5, 600, "deg/s"),
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

/// What the driver asks of the vehicle: written in decide.
struct DriveCommand {
  double heading = 0;  ///< rad, true
  double speed = 0;    ///< m/s; 0 stands

  static constexpr auto fields() {
    return field_list(field("heading", &DriveCommand::heading, "rad"),
                      field("speed", &DriveCommand::speed, "m/s"));
  }
};

/// Written in move.
struct Driving {
  double steering = 0;  ///< rad, of the front wheels, positive right
  flight::NavState nav = {};
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("steering", &Driving::steering, "rad"), field("nav", &Driving::nav),
                      field("reserved", &Driving::reserved));
  }
};

/// An aircraft that the driver has seen, or was told of over the radio.
struct Sighted {
  Vec3 position{};            ///< m, local frame, as estimated at `time`
  double time = 0;            ///< s, of the last that was seen or told of it
  double seen_time = kNever;  ///< s, last seen with the own eyes
  PlayerId truth{};           ///< whose light it was; none: an empty place
  Identity identity = Identity::unknown;
  std::uint8_t reserved[3] = {};

  static constexpr auto fields() {
    return field_list(field("position", &Sighted::position, "m"),
                      field("time", &Sighted::time, "s"),
                      field("seen_time", &Sighted::seen_time, "s"), field("truth", &Sighted::truth),
                      field("identity", &Sighted::identity), field("reserved", &Sighted::reserved));
  }
};

/// The aircraft that a driver keeps in mind, written in perceive. Who watches a handful of aircraft
/// does not mix them up: a sighting belongs to the aircraft it was of.
struct Lookout {
  static constexpr std::size_t kAircraft = 4;
  std::array<Sighted, kAircraft> sighted{};
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  [[nodiscard]] std::span<const Sighted> all() const { return {sighted.data(), count}; }
  [[nodiscard]] Sighted* find(PlayerId truth) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (sighted[i].truth == truth)
        return &sighted[i];
    return nullptr;
  }

  static constexpr auto fields() {
    return field_list(field("sighted", &Lookout::sighted), field("count", &Lookout::count),
                      field("reserved", &Lookout::reserved));
  }
};

/// A vehicle at a place of the local frame (m), put onto the surface below or above it.
[[nodiscard]] Kinematics parked(const Reference& reference, const Vec3& position, double heading,
                                double speed);

/// One step (s): the front wheels turn towards what the heading asked for needs, the speed follows
/// within the limits, slower where the turn would be too fast, and the vehicle moves as the
/// kinematic bicycle does (Rajamani, Vehicle Dynamics and Control, 2nd ed. 2012, sec. 2.2), with
/// its rear axle as the place: heading rate = speed tan(steering) / wheelbase. The leg of the route
/// counts on, whoever leads.
void drive(const VehicleType& type, const Reference& reference,
           std::span<const flight::Route> routes, const DriveCommand& command, double dt,
           Kinematics& k, Driving& driving);

}  // namespace eyrie::model::vehicle
