// SPDX-License-Identifier: MIT
#include "ubf/outline.hpp"

#include "ubf/spec.hpp"

namespace eyrie::ubf {

std::string spoken(const AnyNode& node) {
  if (node.label() != node.type())
    return std::string(node.label());
  if (node.type() == kHolds)
    return std::get<std::string>(node.values().front().value);
  if (node.type() == "inverter" && node.children().size() == 1)
    return "not " + spoken(*node.children()[0]);
  return std::string(node.label());
}

TreeOutline outline(const AnyTree& tree) {
  TreeOutline all{std::string(tree.name()), tree.memory_bytes(), {}};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto index = static_cast<NodeIndex>(i);
    const AnyNode& node = tree.node(index);
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

const TreeOutline* find(std::span<const TreeOutline> trees, std::string_view name) {
  for (const TreeOutline& tree : trees)
    if (tree.name == name)
      return &tree;
  return nullptr;
}

}  // namespace eyrie::ubf
