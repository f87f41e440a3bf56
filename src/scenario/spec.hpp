// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a scenario file says, as typed values before anything is built from them.
#include "core/describe.hpp"
#include "core/units.hpp"
#include "core/version.hpp"
#include "pilot/geometry.hpp"

namespace eyrie::scenario {

/// s, of simulated time: eleven days.
inline constexpr double kLongestFlight = 1e6;

/// When a run is over, besides `until`.
enum class Ends : std::uint8_t {
  blue_home,  ///< every living blue aircraft is home and convoy arrived, or none lives
  last_side,  ///< one side has no aircraft and no vehicle left
  time,       ///< only `until` counts
};
constexpr auto names_of(Ends) {
  return names_from_zero<Ends>("blue_home", "last_side", "time");
}

/// A place: north and east of the reference point, or geodetic.
struct PlaceSpec {
  static constexpr std::string_view type_name = "place";
  static constexpr std::string_view help =
      "a place, as north/east of the reference point or as latitude/longitude";
  static constexpr auto params() {
    return Lines{
        param("north", &PlaceSpec::north, "m", range(-500e3, 500e3),
              "north of the reference point, in its tangent plane"),
        param("east", &PlaceSpec::east, "m", range(-500e3, 500e3),
              "east of the reference point, in its tangent plane"),
        param("latitude", &PlaceSpec::latitude, "rad", range(-kPi / 2, kPi / 2),
              "geodetic latitude, WGS-84"),
        param("longitude", &PlaceSpec::longitude, "rad", range(-kTau, kTau), "longitude, WGS-84")};
  }
  std::optional<double> north, east, latitude, longitude;
};

struct StartSpec : PlaceSpec {
  static constexpr std::string_view type_name = "start";
  static constexpr std::string_view help = "where and how an aircraft begins";
  static constexpr auto params() {
    return joined(
        PlaceSpec::params(),
        Lines{param("altitude", &StartSpec::altitude, "m", range(0, 30e3),
                    "height above the ellipsoid"),
              param("heading", &StartSpec::heading, "rad", range(-kTau, kTau), "true heading"),
              param("speed", &StartSpec::speed, "m/s", range(1, 1000), "true airspeed")});
  }
  std::optional<double> altitude, heading, speed;
};

struct WaypointSpec : PlaceSpec {
  static constexpr std::string_view type_name = "waypoint";
  static constexpr std::string_view help = "one point of a route";
  static constexpr auto params() {
    return joined(PlaceSpec::params(),
                  Lines{param("altitude", &WaypointSpec::altitude, "m", range(0, 30e3),
                              "height above the ellipsoid to fly on the leg to this point"),
                        param("speed", &WaypointSpec::speed, "m/s", range(1, 1000),
                              "true airspeed to fly on the leg to this point")});
  }
  std::optional<double> altitude, speed;
};

/// How far a start may lie from what the file says. Zero: it is the same for every seed.
struct SpreadSpec {
  static constexpr std::string_view type_name = "spread";
  static constexpr std::string_view help =
      "how far starts differ from seed to seed: each amount is drawn evenly, up to so much more or "
      "less than the start says";
  static constexpr auto params() {
    return Lines{
        param("position", &SpreadSpec::position, "m", range(0, 100e3),
              "to the north and to the east"),
        param("altitude", &SpreadSpec::altitude, "m", range(0, 15e3), "higher or lower"),
        param("heading", &SpreadSpec::heading, "rad", range(0, kPi), "to the right or to the left"),
        param("speed", &SpreadSpec::speed, "m/s", range(0, 300), "faster or slower")};
  }
  double position = 0;  ///< m
  double altitude = 0;  ///< m
  double heading = 0;   ///< rad
  double speed = 0;     ///< m/s
  friend bool operator==(const SpreadSpec&, const SpreadSpec&) = default;
};

/// What may be said of a whole flight and again of one of its players.
struct PlayerSpec {
  static constexpr std::string_view type_name = "player";
  static constexpr std::string_view help =
      "one aircraft; what it does not say comes from its flight";
  static constexpr auto params() {
    return Lines{
        param("aircraft", &PlayerSpec::aircraft, "name of an aircraft in data/aircraft"),
        param("tree", &PlayerSpec::tree,
              "name of the tree that flies it; none: the autopilot alone"),
        param("start", &PlayerSpec::start, "where and how it begins"),
        param(
            "spread", &PlayerSpec::spread,
            "by how much its start differs from seed to seed; one of a flight moves it as a whole"),
        param("fuel", &PlayerSpec::fuel, "kg", range(0, 100e3),
              "fuel at the start; not given: full tanks"),
        param("bingo", &PlayerSpec::bingo, "kg", range(0, 100e3),
              "fuel at which the pilot goes home; not given: a quarter of what the tanks hold"),
        param("loadout", &PlayerSpec::loadout, "stores by name, one per station in order"),
        param("rounds", &PlayerSpec::rounds, range(0, 10e3),
              "gun rounds at the start; not given: what the gun holds"),
        param("privileged", &PlayerSpec::privileged,
              "true: its tracks are the truth, as in the paper")};
  }
  std::string aircraft, tree;
  StartSpec start;
  SpreadSpec spread;
  std::optional<double> fuel, bingo;
  std::optional<std::vector<std::string>> loadout;
  std::optional<std::uint16_t> rounds;
  bool privileged = false;
};

struct FlightSpec : PlayerSpec {
  static constexpr std::string_view type_name = "flight";
  static constexpr std::string_view help = "aircraft that fly together, ranked by their names";
  static constexpr auto params() {
    return joined(
        PlayerSpec::params(),
        Lines{param("formation", &FlightSpec::formation, "spacing of the wall formation"),
              param("route", &FlightSpec::route, "the waypoints, in order").items(0, 10'000),
              param("home", &FlightSpec::home, "where it lands; not given: the side's home")});
  }
  pilot::Formation formation;
  std::vector<WaypointSpec> route;
  std::optional<PlaceSpec> home;
};

struct VehicleStartSpec : PlaceSpec {
  static constexpr std::string_view type_name = "vehicle_start";
  static constexpr std::string_view help = "where and how a vehicle begins, on the surface";
  static constexpr auto params() {
    return joined(PlaceSpec::params(),
                  Lines{param("heading", &VehicleStartSpec::heading, "rad", range(-kTau, kTau),
                              "true heading"),
                        param("speed", &VehicleStartSpec::speed, "m/s", range(0, 100),
                              "over the ground; not given: stands")});
  }
  std::optional<double> heading, speed;
};

struct RoadPointSpec : PlaceSpec {
  static constexpr std::string_view type_name = "road_point";
  static constexpr std::string_view help = "one point of a convoy's route";
  static constexpr auto params() {
    return joined(PlaceSpec::params(),
                  Lines{param("speed", &RoadPointSpec::speed, "m/s", range(0.5, 100),
                              "to drive on the leg to this point")});
  }
  std::optional<double> speed;
};

/// What may be said of a whole convoy and again of one of its vehicles.
struct VehicleSpec {
  static constexpr std::string_view type_name = "vehicle";
  static constexpr std::string_view help =
      "one vehicle; what it does not say comes from its convoy";
  static constexpr auto params() {
    return Lines{
        param("vehicle", &VehicleSpec::vehicle, "name of a vehicle in data/vehicles"),
        param("tree", &VehicleSpec::tree, "name of the tree that drives it; none: it stands"),
        param("start", &VehicleSpec::start, "where and how it begins")};
  }
  std::string vehicle, tree;
  VehicleStartSpec start;
};

struct ConvoySpec : VehicleSpec {
  static constexpr std::string_view type_name = "convoy";
  static constexpr std::string_view help = "vehicles that drive in column, ranked by their names";
  static constexpr auto params() {
    return joined(
        VehicleSpec::params(),
        Lines{param("gap", &ConvoySpec::gap, "m", range(5, 5e3), "from vehicle to vehicle"),
              param("route", &ConvoySpec::route, "the points of its way, in order; it stops there")
                  .items(0, 10'000)});
  }
  double gap = 50;
  std::vector<RoadPointSpec> route;
};

struct RatesSpec {
  static constexpr std::string_view type_name = "rates";
  static constexpr std::string_view help = "how often things happen; each must divide the first";
  static constexpr auto params() {
    return Lines{
        param("kinematics", &RatesSpec::kinematics, "Hz", range(1, 1000), "steps of the world"),
        param("decisions", &RatesSpec::decisions, "Hz", range(0.1, 1000),
              "ticks of each pilot's and each driver's tree")};
  }
  double kinematics = 50, decisions = 10;

  /// The step that is nearest to a time (s, not negative).
  [[nodiscard]] std::uint64_t step_at(double time) const {
    return static_cast<std::uint64_t>(time * kinematics + 0.5);
  }
};

struct ReferenceSpec {
  static constexpr std::string_view type_name = "reference";
  static constexpr std::string_view help = "the reference point: origin of the local frame";
  static constexpr auto params() {
    return Lines{param("latitude", &ReferenceSpec::latitude, "rad", range(-kPi / 2, kPi / 2),
                       "geodetic latitude, WGS-84")
                     .required(),
                 param("longitude", &ReferenceSpec::longitude, "rad", range(-kTau, kTau),
                       "longitude, WGS-84")
                     .required()};
  }
  double latitude = 0, longitude = 0;
};

/// An order that comes with the scenario.
struct OrderSpec {
  static constexpr std::string_view type_name = "order";
  static constexpr std::string_view help = "something asked of a player from outside, at a time";
  static constexpr auto params() {
    return Lines{
        param("at", &OrderSpec::at, "s", range(0, kLongestFlight),
              "simulated time, before the scenario's end")
            .required(),
        param("player", &OrderSpec::player, "who").required(),
        param("swap_tree", &OrderSpec::swap_tree, "the tree to fly or drive by from then on"),
        param("lose", &OrderSpec::lose,
              "true: the player is lost to something that is not simulated, such as a mine")};
  }
  double at = 0;
  std::string player;
  std::optional<std::string> swap_tree;
  bool lose = false;
};

/// The top level of a scenario file; trees, data, routes, blue and red are read by hand.
struct ScenarioSpec {
  static constexpr std::string_view type_name = "scenario";
  static constexpr std::string_view help = "a scenario: who flies what, where, and until when";
  static constexpr auto params() {
    return Lines{
        param("eyrie", &ScenarioSpec::eyrie, range(kFileFormat, kFileFormat),
              "version of the file format")
            .required(),
        param("name", &ScenarioSpec::name, "what the run is called").items(1, 100).required(),
        param("help", &ScenarioSpec::help_text, "one line on what it is for").items(0, 500),
        param("reference", &ScenarioSpec::reference, "origin of the local frame").required(),
        param("seed", &ScenarioSpec::seed, "default seed of the draws"),
        param("rates", &ScenarioSpec::rates, "how often things happen"),
        param("until", &ScenarioSpec::until, "s", range(0.001, kLongestFlight),
              "the run ends at the latest then; at least one step"),
        param("ends", &ScenarioSpec::ends, "what else ends the run"),
        param("orders", &ScenarioSpec::orders, "orders from outside, carried out on time"),
        param("ours", &ScenarioSpec::ours,
              "sides, flights and aircraft that this program flies, [blue] or [eagle, bogey2]; all "
              "others are flown by programs that are heard over DIS; [] (the default): nobody is")
            .items(0, 1000)};
  }
  int eyrie = kFileFormat;
  std::string name, help_text;
  ReferenceSpec reference;
  std::uint64_t seed = 1;
  RatesSpec rates;
  double until = si(60, "min");
  Ends ends = Ends::blue_home;
  std::vector<OrderSpec> orders;
  std::vector<std::string> ours;
};

}  // namespace eyrie::scenario
