// SPDX-License-Identifier: MIT
#include "record/names.hpp"

namespace eyrie::record {
namespace {

/// `use(tree)` of the tree that an event names, whatever the platform; `otherwise` without one.
template <class Result, class Use>
Result with_tree(const scenario::Scenario& scenario, const sim::Event& e, Result otherwise,
                 Use use) {
  const auto* player = scenario.roster.find(e.who);
  if (player && player->platform == scenario::Platform::vehicle)
    return e.aux < scenario.driver_trees->size() ? use((*scenario.driver_trees)[e.aux]) : otherwise;
  return e.aux < scenario.trees->size() ? use((*scenario.trees)[e.aux]) : otherwise;
}

}  // namespace

bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase) {
  return with_tree(scenario, phase, false, [&](const auto& tree) {
    for (std::size_t i = 0; i < tree.size(); ++i)
      if (tree.node(static_cast<ubf::NodeIndex>(i)).type() == "sequencer")
        return static_cast<std::size_t>(phase.values[2]) == i;
    return false;
  });
}

std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase) {
  return with_tree(scenario, phase, std::string("?"), [&](const auto& tree) {
    const auto node = static_cast<std::size_t>(phase.values[2]);
    if (node >= tree.size())
      return std::string("?");
    const auto children = tree.node(static_cast<ubf::NodeIndex>(node)).children();
    const auto to = static_cast<std::size_t>(phase.values[1]);
    return to < children.size() ? std::string(children[to]->label()) : "?";
  });
}

std::string store_label(const scenario::Scenario& scenario, float index) {
  const auto& missiles = scenario.library->missiles;
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < missiles.size() ? missiles[i].label : "?";
}

}  // namespace eyrie::record
