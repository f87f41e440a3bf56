// SPDX-License-Identifier: MIT
#pragma once
/// \file  Routes: the waypoints of a flight, const and shared by its members.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/vec.hpp"

namespace eyrie::model::flight {

/// What to do after the last waypoint.
enum class RouteEnd : std::uint8_t {
  loiter,    ///< circle around it
  straight,  ///< keep flying as the last leg went
  repeat,    ///< start again with the first
  stop,      ///< stand there; for who is on the ground
};

/// A place to fly over. Positions are in the scenario's local frame.
struct Waypoint {
  Vec3 position;                     ///< m; only its place on the ground counts
  double altitude = 0;               ///< m above the ellipsoid, flown on the leg towards it
  std::optional<double> speed = {};  ///< m/s true airspeed on that leg; none: as the command says
};

/// Waypoints in order. The first leg leads from wherever the aircraft is to the first one.
struct Route {
  std::string name;
  std::vector<Waypoint> waypoints;
  RouteEnd end = RouteEnd::loiter;
};

}  // namespace eyrie::model::flight

template <>
struct eyrie::EnumNames<eyrie::model::flight::RouteEnd> {
  using E = eyrie::model::flight::RouteEnd;
  static constexpr std::array names{std::pair<std::string_view, E>{"loiter", E::loiter},
                                    std::pair<std::string_view, E>{"straight", E::straight},
                                    std::pair<std::string_view, E>{"repeat", E::repeat},
                                    std::pair<std::string_view, E>{"stop", E::stop}};
};
