// SPDX-License-Identifier: MIT
#include "record/names.hpp"

namespace eyrie::record {
namespace {

/// The tree that an event names, or null.
const ubf::AnyTree* tree_of(const scenario::Scenario& scenario, const sim::Event& e) {
  if (!scenario.roster.find(e.who))
    return nullptr;
  const auto& trees = scenario.fleet_of(e.who).trees;
  return e.aux < trees.size() ? trees[e.aux] : nullptr;
}

}  // namespace

bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase) {
  if (const ubf::AnyTree* tree = tree_of(scenario, phase))
    for (std::size_t i = 0; i < tree->size(); ++i)
      if (tree->node(static_cast<ubf::NodeIndex>(i)).is_sequencer())
        return static_cast<std::size_t>(phase.values[2]) == i;
  return false;
}

std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase) {
  const ubf::AnyTree* tree = tree_of(scenario, phase);
  const auto node = static_cast<std::size_t>(phase.values[2]);
  const auto child = static_cast<std::size_t>(phase.values[1]);
  if (!tree || node >= tree->size())
    return "?";
  const auto children = tree->node(static_cast<ubf::NodeIndex>(node)).children();
  return child < children.size() ? std::string(children[child]->label()) : "?";
}

std::string store_label(const scenario::Scenario& scenario, float index) {
  const auto& missiles = scenario.library->missiles;
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < missiles.size() ? missiles[i].label : "?";
}

}  // namespace eyrie::record
