// SPDX-License-Identifier: MIT
#pragma once
/// \file  The flights and players of a scenario document, read and checked, not yet built.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "model/fit.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {

/// One aircraft: what its flight says, overridden by what the file says of it.
struct PlayerPlan {
  std::string name;
  std::uint16_t rank = 1;  ///< from the name
  Location where;
  PlayerSpec spec;
  bool own_place = false;  ///< it has a start place of its own instead of one in the formation
};

struct FlightPlan {
  std::string name;
  model::Side side = model::Side::none;
  Location where;
  FlightSpec spec;
  std::optional<PlaceSpec> home;  ///< of the flight, or else of the side
  Location home_where, route_where, start_where;
  std::vector<PlayerPlan> players;  ///< by rank
};

/// Reads `blue:` and `red:` of a scenario document, in this order and flights in file order.
/// Refused: a side or flight without anything in it, a player whose name is not its flight's name
/// and a rank, two players of one name, a flight without a lead, ranks beyond model::kMaxFlight.
[[nodiscard]] std::vector<FlightPlan> read_plans(const Value& document, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
