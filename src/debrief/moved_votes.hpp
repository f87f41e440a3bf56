// SPDX-License-Identifier: MIT
#pragma once
/// \file  Votes that were given to nodes from outside, in a scenario with other trees: they go to
/// the nodes of the same paths.
#include "debrief/recorded.hpp"

namespace eyrie::debrief {

/// An order of a recording; if it is a vote, for the node that has the path in `other`, and for
/// none if no node has it.
[[nodiscard]] sim::Order moved_vote(const scenario::Scenario& flown,
                                    const scenario::Scenario& other, const sim::Order& order);

/// Likewise those that were given before, in a world of `other` that was flown with other trees.
void move_votes(const scenario::Scenario& flown, const scenario::Scenario& other,
                sim::World& world);

/// The paths of nodes that were given another vote and that the other trees do not have.
[[nodiscard]] std::vector<std::string> votes_left_out(const Recorded& recorded,
                                                      const scenario::Scenario& other);

}  // namespace eyrie::debrief
