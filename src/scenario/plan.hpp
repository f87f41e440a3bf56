// SPDX-License-Identifier: MIT
#pragma once
/// \file  The flights and players of a scenario document, read and checked, not yet built.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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
  bool own_place = false;      ///< it has a start place of its own instead of one in the formation
  bool sound = true;           ///< everything said of it and of its flight could be read
  const Value* own = nullptr;  ///< its overrides in the document, if it has any
  const Value* flight = nullptr;  ///< its flight in the document

  /// What the document says of a key: of the player, or else of its flight; null if nothing.
  [[nodiscard]] const Value* said(std::string_view key) const;
  /// Where it says so; if nowhere, where the player stands.
  [[nodiscard]] const Location& place(std::string_view key) const;
};

struct FlightPlan {
  std::string name;
  model::Side side = model::Side::none;
  Location where;
  FlightSpec spec;
  std::optional<PlaceSpec> home;  ///< of the flight, or else of the side
  bool sound = true;              ///< everything said of it could be read
  Location home_where, route_where, start_where;
  std::vector<PlayerPlan> players;  ///< by rank
};

/// Reads `blue:` and `red:` of a scenario document, in this order and flights in file order.
/// Refused: a side or flight without anything in it, a player whose name is not its flight's name
/// and a rank, two players of one name, a flight without a lead, ranks beyond model::kMaxFlight.
[[nodiscard]] std::vector<FlightPlan> read_plans(const Value& document, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
