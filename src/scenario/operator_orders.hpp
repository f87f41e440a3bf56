// SPDX-License-Identifier: MIT
#pragma once
/// \file  What somebody outside asks of players while a mission is flown, as JSON; numbers in SI:
///
///   {"order": "tree", "player": "eagle1", "tree": "bvr"}   from now on by another tree
///   {"order": "lose", "player": "eagle2"}                  lost to something that is not simulated
///   {"order": "manual", "player": "eagle1", "heading": 1.57, "altitude": 6000, "speed": 250}
///     a person flies it, the tree goes on proposing; each time anew with everything that is to
///     hold: also "climb" (rad; a direction to fly to instead of an altitude), "load_factor" (g),
///     "target" (a number of its own tracker), "shoot": true (once, at the target), "gun": true,
///     "radar": false, "dispense": "chaff", "flares" or "both" (once)
///   {"order": "hand_back", "player": "eagle1"}             by its tree again
///   {"order": "vote", "player": "eagle1", "tree": "bvr", "node": "root/pursue", "vote": 70}
///     a node of the tree it flies by votes so much; without "vote" as its file says
///   {"order": "weapons", "flight": "eagle", "free": false} nothing is released
///   {"order": "point", "player": "eagle1", "east": 9000, "north": 2000, "altitude": 8000}
///     to a place of the flat map instead of its route; "more": true: after the points it has
///   {"order": "route", "player": "eagle1"}                 its route again
///
#include <span>
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

/// Orders for a step; "flight": "eagle" instead of "player" means everybody of a flight or convoy
/// who is not another program's.
/// Reads nothing but the scenario, on any thread.
[[nodiscard]] OperatorOrders orders_from_json(const Scenario& scenario, std::string_view text,
                                              std::uint64_t step);

/// Leaves those out who are no longer there or, if it is for now, cannot obey; it is a problem if
/// that is everybody. `waiting` was given before and is not yet carried out.
void leave_out_unable(OperatorOrders& asked, const Scenario& scenario, const sim::World& world,
                      std::span<const sim::Order> waiting = {});

}  // namespace eyrie::scenario
