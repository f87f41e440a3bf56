// SPDX-License-Identifier: MIT
#pragma once
/// \file  What somebody outside asks of players while a mission is flown, as JSON:
///
///   {"order": "tree", "player": "eagle1", "tree": "bvr"}   from now on by another tree
///   {"order": "lose", "player": "eagle2"}                  lost to something that is not simulated
///
/// "flight": "eagle" instead of "player" means everybody of a flight or convoy.
#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.hpp"
#include "sim/event.hpp"

namespace eyrie::scenario {

struct OperatorOrders {
  std::string kind;                ///< "tree"
  std::vector<sim::Order> orders;  ///< one for each player whom it means
  std::string problem;             ///< why there are none, for people; else ""
};

/// Orders for a step. Reads nothing but the scenario, on any thread.
[[nodiscard]] OperatorOrders orders_from_json(const Scenario& scenario, std::string_view text,
                                              std::uint64_t step);

}  // namespace eyrie::scenario
