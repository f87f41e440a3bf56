// SPDX-License-Identifier: MIT
#include "record/names.hpp"

namespace eyrie::record {
namespace {

/// The tree that an event names, or null.
const ubf::TreeOutline* tree_of(const scenario::Scenario& scenario, const sim::Event& e) {
  if (!scenario.roster.find(e.who))
    return nullptr;
  const auto& trees = scenario.fleet_of(e.who).trees;
  return e.aux < trees.size() ? &trees[e.aux] : nullptr;
}

}  // namespace

bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase) {
  if (const ubf::TreeOutline* tree = tree_of(scenario, phase))
    for (std::size_t i = 0; i < tree->nodes.size(); ++i)
      if (tree->nodes[i].is_sequencer)
        return static_cast<std::size_t>(phase.values[2]) == i;
  return false;
}

std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase) {
  const ubf::TreeOutline* tree = tree_of(scenario, phase);
  const ubf::NodeOutline* to = tree ? tree->child(static_cast<std::size_t>(phase.values[2]),
                                                  static_cast<std::size_t>(phase.values[1]))
                                    : nullptr;
  return to ? to->label : "?";
}

std::string store_label(const scenario::Scenario& scenario, float index) {
  const auto& missiles = scenario.library->missiles;
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < missiles.size() ? missiles[i].label : "?";
}

}  // namespace eyrie::record
