// SPDX-License-Identifier: MIT
#pragma once
/// \file  Trees as the page draws them.
#include <string_view>
#include <variant>

#include "debrief/decision.hpp"
#include "page/json.hpp"
#include "ubf/tree.hpp"

namespace eyrie::page {

/// `platform` is "aircraft" or "vehicle".
template <class State, class Action>
[[nodiscard]] Json tree_json(const ubf::Tree<State, Action>& tree, std::string_view platform) {
  Json nodes = Json::array();
  const std::vector<debrief::Answer> all = team::unanswered(ubf::outline(tree));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& node = tree.node(static_cast<ubf::NodeIndex>(i));
    const debrief::Answer& answer = all[i];
    Json params = Json::object();  // in SI; a page may ask for others
    for (const ParamValue& param : node.values())
      std::visit([&](const auto& value) { params[param.name] = value; }, param.value);
    nodes.push_back({{"label", answer.label},
                     {"type", answer.type},
                     {"path", answer.path},
                     {"kind", to_text(node.node_kind())},
                     {"parent", answer.parent == ubf::kNone ? -1 : static_cast<int>(answer.parent)},
                     {"depth", answer.depth},
                     {"params", std::move(params)},
                     {"remembers", node.remembers()}});
  }
  return {{"name", tree.name()}, {"kind", platform}, {"nodes", std::move(nodes)}};
}

}  // namespace eyrie::page
