// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who is who in a scenario: names for reports, tables and recordings.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/id.hpp"
#include "model/fit.hpp"

namespace eyrie::scenario {

/// Names that never enter a step. Player ids are 1 + index: players are born in this order, fleet
/// by fleet.
struct Roster {
  struct Player {
    std::string name;   ///< "eagle1"
    std::string type;   ///< name of its type, "f15c"
    std::string label;  ///< what people call the type, "F-15C"
    model::Side side = model::Side::none;
    std::uint16_t flight = 0;  ///< index into flights
    std::uint16_t rank = 1;    ///< from the name
    std::uint8_t fleet = 0;    ///< index into Scenario::fleets
  };
  struct Flight {
    std::string name;
    model::Side side = model::Side::none;
    std::vector<PlayerId> members;  ///< in order of rank
  };

  std::vector<Player> players;
  std::vector<Flight> flights;

  [[nodiscard]] const Player* find(PlayerId id) const {
    return id && id.value <= players.size() ? &players[id.value - 1] : nullptr;
  }
  /// The name of a player in it; for anybody else "player 12", for nobody "".
  [[nodiscard]] std::string name(PlayerId id) const {
    if (const Player* p = find(id))
      return p->name;
    return id ? "player " + std::to_string(id.value) : "";
  }
  [[nodiscard]] std::optional<PlayerId> find(std::string_view name) const {
    for (std::size_t i = 0; i < players.size(); ++i)
      if (players[i].name == name)
        return PlayerId{static_cast<std::uint32_t>(i + 1)};
    return std::nullopt;
  }
};

[[nodiscard]] constexpr std::string_view side_name(model::Side side) {
  return side == model::Side::blue ? "blue" : side == model::Side::red ? "red" : "none";
}

}  // namespace eyrie::scenario
