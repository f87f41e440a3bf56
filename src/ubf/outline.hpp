// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a tree is made of, without the types of its states and actions.
#include "ubf/agent.hpp"
#include "ubf/node.hpp"

namespace eyrie::ubf {

struct NodeOutline {
  std::string label;   ///< what the user called it; the type's name if he did not
  std::string spoken;  ///< the same, but conditions in their words: "not in_sight"
  std::string type, path;
  std::uint16_t depth = 0, parent = kNone;
  bool is_leaf = true, is_condition = false, is_sequencer = false;
};

struct TreeOutline {
  std::string name;
  std::size_t memory_bytes = 0;
  std::vector<NodeOutline> nodes;  ///< in pre-order

  /// The label of a node; "nobody" for none.
  [[nodiscard]] std::string label(std::size_t node) const {
    return node < nodes.size() ? nodes[node].label : "nobody";
  }
  /// The child of a node, counted from 0; null if there is none.
  [[nodiscard]] const NodeOutline* child(std::size_t node, std::size_t number) const {
    for (const NodeOutline& one : nodes)
      if (one.parent == node && number-- == 0)
        return &one;
    return nullptr;
  }
};

/// What a node is in a sentence: a condition in its words, if it has no label.
[[nodiscard]] std::string spoken(const AnyNode& node);

[[nodiscard]] TreeOutline outline(const AnyTree& tree);

template <class State, class Action>
[[nodiscard]] std::vector<TreeOutline> outlines(const Trees<State, Action>& trees) {
  std::vector<TreeOutline> all;
  for (const auto& tree : trees)
    all.push_back(outline(tree));
  return all;
}

/// The tree of that name, or nothing.
[[nodiscard]] const TreeOutline* find(std::span<const TreeOutline> trees, std::string_view name);

}  // namespace eyrie::ubf
