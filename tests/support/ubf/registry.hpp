// SPDX-License-Identifier: MIT
#pragma once
/// \file  Trees from texts, for the tests of this library: what is built of them and what is said.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/yaml.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

/// The nodes of the library, Probe and Check.
[[nodiscard]] inline const RobotRegistry& standard_registry() {
  static const RobotRegistry kRegistry = [] {
    RobotRegistry made;
    add_standard_nodes(made);
    made.add<Probe>();
    made.add<Check>();
    return made;
  }();
  return kRegistry;
}

/// What a text says; it is the test's own, so a mistake in it ends the test.
[[nodiscard]] inline Value document(std::string_view text, const std::string& file = "test.yaml") {
  Diagnostics diagnostics;
  Value value = parse_yaml(text, file, diagnostics);
  EYRIE_DEMAND(diagnostics.ok(), diagnostics.text().c_str());
  return value;
}

/// The label of the tree that the first sequencer has in charge, "" for none.
[[nodiscard]] inline std::string phase(const Robot& robot) {
  for (std::size_t i = 0; i < robot.tree.size(); ++i) {
    const AnyNode& node = robot.tree.node(static_cast<NodeIndex>(i));
    if (!node.is_sequencer())
      continue;
    const NodeIndex active = node.active_child(robot.slab.data());
    return active == kNone ? "" : std::string(node.children()[active]->label());
  }
  return "";
}

/// Trees that others refer to. Each stands in a file of its own: "home" in home.yaml.
class NamedTrees {
 public:
  NamedTrees& with(std::string name, std::string_view text) {
    Value value = document(text, name + ".yaml");
    trees_.emplace_back(std::move(name), std::move(value));
    return *this;
  }
  [[nodiscard]] std::vector<NamedSpec> specs() const {
    std::vector<NamedSpec> specs;
    for (const auto& [name, value] : trees_)
      specs.push_back({name, &value});
    return specs;
  }

 private:
  std::vector<std::pair<std::string, Value>> trees_;
};

/// The tree "test" that a text in test.yaml describes. A mistake in it ends the test.
[[nodiscard]] inline RobotTree build(std::string_view text, const NamedTrees& others = {},
                                     const RobotRegistry& registry = standard_registry()) {
  Diagnostics diagnostics;
  auto tree = registry.build_tree("test", document(text), diagnostics, others.specs());
  if (!tree)
    throw ConfigError(diagnostics);
  return std::move(*tree);
}
/// What is said of a text in test.yaml; empty if it is a tree.
[[nodiscard]] inline std::string mistakes(std::string_view text, const NamedTrees& others = {}) {
  Diagnostics diagnostics;
  const auto tree =
      standard_registry().build_tree("test", document(text), diagnostics, others.specs());
  EXPECT_EQ(tree.has_value(), diagnostics.ok());
  return diagnostics.text();
}

}  // namespace eyrie::ubf::testing
