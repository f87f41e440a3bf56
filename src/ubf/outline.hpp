// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a tree is made of, without the types of its states and actions.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ubf/agent.hpp"
#include "ubf/leaf/holds.hpp"
#include "ubf/tree.hpp"

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

template <class State, class Action>
[[nodiscard]] std::string spoken(const Behavior<State, Action>& node) {
  if (node.label() != node.type())
    return std::string(node.label());
  if (node.type() == Holds<State, Action>::type_name)
    return static_cast<const Holds<State, Action>&>(node).that;
  if (node.type() == "inverter" && node.children().size() == 1)
    return "not " + spoken(*node.children()[0]);
  return std::string(node.label());
}

template <class State, class Action>
[[nodiscard]] TreeOutline outline(const Tree<State, Action>& tree) {
  TreeOutline all{std::string(tree.name()), tree.memory_bytes(), {}};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto index = static_cast<NodeIndex>(i);
    const auto& node = tree.node(index);
    all.nodes.push_back({.label = std::string(node.label()),
                         .spoken = spoken(node),
                         .type = std::string(node.type()),
                         .path = tree.path(index),
                         .depth = static_cast<std::uint16_t>(tree.depth(index)),
                         .parent = tree.parent(index),
                         .is_leaf = node.children().empty(),
                         .is_condition = node.node_kind() == Kind::condition,
                         .is_sequencer = node.is_sequencer()});
  }
  return all;
}

template <class State, class Action>
[[nodiscard]] std::vector<TreeOutline> outlines(const Trees<State, Action>& trees) {
  std::vector<TreeOutline> all;
  for (const auto& tree : trees)
    all.push_back(outline(tree));
  return all;
}

/// The tree of that name, or nothing.
[[nodiscard]] inline const TreeOutline* find(std::span<const TreeOutline> trees,
                                             std::string_view name) {
  for (const TreeOutline& tree : trees)
    if (tree.name == name)
      return &tree;
  return nullptr;
}

}  // namespace eyrie::ubf
