// SPDX-License-Identifier: MIT
#pragma once
/// \file  Trees as the page draws them and arbitrates by them.
#include <string_view>

#include "debrief/decision.hpp"
#include "page/params_json.hpp"
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
    nodes.push_back({{"label", answer.label},
                     {"type", answer.type},
                     {"path", answer.path},
                     {"kind", to_text(node.node_kind())},
                     {"parent", answer.parent == ubf::kNone ? -1 : static_cast<int>(answer.parent)},
                     {"depth", answer.depth},
                     {"params", arbiter_params(node)},
                     {"remembers", node.remembers()}});
    if (node.appraiser() || (node.vote_curve() && !answer.is_leaf))
      nodes.back()["appraises"] = true;
  }
  return {{"name", tree.name()}, {"kind", platform}, {"nodes", std::move(nodes)}};
}

}  // namespace eyrie::page
