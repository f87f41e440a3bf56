// SPDX-License-Identifier: MIT
#include "record/names.hpp"

namespace eyrie::record {
namespace {

const pilot::Trees::TreeType* tree_of(const scenario::Scenario& scenario, const sim::Event& e) {
  const auto& trees = *scenario.trees;
  return e.aux < trees.size() ? &trees[e.aux] : nullptr;
}

}  // namespace

bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase) {
  const auto* tree = tree_of(scenario, phase);
  if (!tree)
    return false;
  for (std::size_t i = 0; i < tree->size(); ++i)
    if (tree->node(static_cast<ubf::NodeIndex>(i)).type() == "sequencer")
      return static_cast<std::size_t>(phase.values[2]) == i;
  return false;
}

std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase) {
  const auto* tree = tree_of(scenario, phase);
  const auto node = static_cast<std::size_t>(phase.values[2]);
  if (!tree || node >= tree->size())
    return "?";
  const auto children = tree->node(static_cast<ubf::NodeIndex>(node)).children();
  const auto to = static_cast<std::size_t>(phase.values[1]);
  return to < children.size() ? std::string(children[to]->label()) : "?";
}

std::string store_label(const scenario::Scenario& scenario, float index) {
  const auto& missiles = scenario.library->missiles;
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < missiles.size() ? missiles[i].label : "?";
}

}  // namespace eyrie::record
