// SPDX-License-Identifier: MIT
#include "sim/system.hpp"

namespace eyrie::sim {

std::string_view phase_name(Phase phase) {
  constexpr std::array<std::string_view, kPhases> kNames = {"orders", "perceive", "decide", "act",
                                                            "move",   "interact", "commit"};
  return kNames[static_cast<std::size_t>(phase)];
}

bool CommitContext::remove(PlayerId who) {
  const std::optional<RowRef> place = world_.find(who);
  if (place)
    world_.remove(place->table, place->row);
  return place.has_value();
}

}  // namespace eyrie::sim
