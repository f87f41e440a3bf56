// SPDX-License-Identifier: MIT
#pragma once
/// \file  Overrides by the path of a node: `root/bvr=fusion`, `root/bvr/pursue.vote=70`.
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::debrief {

/// Overrides of the scenario's file and of nodes, told apart.
struct Overrides {
  std::vector<std::string> sets;
  std::vector<scenario::TreeChange> changes;
};

/// A path as `explain` writes it, of the tree that the player begins with, or of another one as
/// `patrol:root/bvr`. Before `=` stands the node, for another type, or the node, a point and a
/// parameter. Everything else is an override of the file. Mistakes stand in "--set <text>".
[[nodiscard]] Overrides read_overrides(const scenario::Scenario& scenario, PlayerId who,
                                       const std::vector<std::string>& texts,
                                       Diagnostics& diagnostics);

}  // namespace eyrie::debrief
