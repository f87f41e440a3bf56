// SPDX-License-Identifier: MIT
#pragma once
/// \file  What stays the same about the nodes of a tree, in words.
#include <string>
#include <vector>

#include "debrief/decision.hpp"
#include "ubf/leaf/holds.hpp"
#include "ubf/tree.hpp"

namespace eyrie::debrief {

/// What a node without a label of its own is called: conditions in their words, "not in_sight".
template <class State, class Action>
[[nodiscard]] std::string spoken(const ubf::Behavior<State, Action>& node) {
  if (const auto* condition = dynamic_cast<const ubf::Holds<State, Action>*>(&node))
    return condition->that;
  if (node.type() == "inverter" && node.children().size() == 1)
    return "not " + spoken(*node.children()[0]);
  return std::string(node.label());
}

/// Every node of a tree as one that was not asked.
template <class State, class Action>
[[nodiscard]] std::vector<Answer> unanswered(const ubf::Tree<State, Action>& tree) {
  std::vector<Answer> all;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto index = static_cast<ubf::NodeIndex>(i);
    const auto& node = tree.node(index);
    Answer answer{.label = node.label() == node.type() ? spoken(node) : std::string(node.label()),
                  .type = std::string(node.type()),
                  .path = tree.path(index),
                  .depth = static_cast<std::uint16_t>(tree.depth(index)),
                  .parent = tree.parent(index),
                  .is_leaf = node.children().empty()};
    if (dynamic_cast<const ubf::Condition<State, Action>*>(&node))
      answer.why = "does not hold";  // if it fails without a word of its own
    all.push_back(std::move(answer));
  }
  return all;
}

}  // namespace eyrie::debrief
