// SPDX-License-Identifier: MIT
#pragma once
/// \file  Trees as the page draws them and arbitrates by them.
#include <string_view>

#include "core/enum_names.hpp"
#include "debrief/nodes.hpp"
#include "page/json.hpp"
#include "ubf/arbiter/commitment.hpp"
#include "ubf/arbiter/fusion.hpp"
#include "ubf/arbiter/inhibit.hpp"
#include "ubf/arbiter/motor_schema.hpp"
#include "ubf/arbiter/paper_fusion.hpp"
#include "ubf/arbiter/priority.hpp"
#include "ubf/arbiter/suppress.hpp"
#include "ubf/composite.hpp"
#include "ubf/control/parallel.hpp"
#include "ubf/tree.hpp"

namespace eyrie::page {

/// The parameters that the page's arbitration reads (viewer/src/decide/arbitrate.ts).
template <class State, class Action>
[[nodiscard]] Json arbiter_params(const ubf::Behavior<State, Action>& node) {
  Json params = Json::object();
  if (node.vote_given())
    params["vote"] = *node.vote_given();
  if (const auto* voting = dynamic_cast<const ubf::Voting<State, Action>*>(&node)) {
    if (voting->vote)
      params["vote"] = *voting->vote;
    if (voting->vote_scale != 1)
      params["vote_scale"] = voting->vote_scale;
  }
  if (const auto* fusion = dynamic_cast<const ubf::Fusion<State, Action>*>(&node)) {
    if (fusion->top)
      params["top"] = *fusion->top;
    params["conflicts"] = enum_name(fusion->conflicts);
  }
  if (const auto* paper = dynamic_cast<const ubf::PaperFusion<State, Action>*>(&node))
    params["high_vote"] = paper->high_vote;
  if (const auto* schema = dynamic_cast<const ubf::MotorSchema<State, Action>*>(&node)) {
    params["direction"] = ubf::field_names<Action>()[schema->direction.index().value_or(0)];
    params["magnitude"] = ubf::field_names<Action>()[schema->magnitude.index().value_or(0)];
    params["unit_vote"] = schema->unit_vote;
  }
  if (const auto* parallel = dynamic_cast<const ubf::Parallel<State, Action>*>(&node)) {
    if (parallel->success_count)
      params["success_count"] = *parallel->success_count;
    params["failure_count"] = parallel->failure_count;
  }
  if (const auto* priority = dynamic_cast<const ubf::Priority<State, Action>*>(&node)) {
    Json list = Json::array();
    for (const bool may : priority->interruptible)
      list.push_back(may ? 1 : 0);
    params["interruptible"] = std::move(list);
  }
  if (const auto* commitment = dynamic_cast<const ubf::Commitment<State, Action>*>(&node)) {
    params["margin"] = commitment->margin;
    params["min_time"] = commitment->min_time;
    params["hold"] = commitment->hold;
  }
  if (const auto* suppress = dynamic_cast<const ubf::Suppress<State, Action>*>(&node))
    params["hold"] = suppress->hold;
  if (const auto* inhibit = dynamic_cast<const ubf::Inhibit<State, Action>*>(&node))
    params["hold"] = inhibit->hold;
  return params;
}

/// `platform` is "aircraft" or "vehicle".
template <class State, class Action>
[[nodiscard]] Json tree_json(const ubf::Tree<State, Action>& tree, std::string_view platform) {
  Json nodes = Json::array();
  const std::vector<debrief::Answer> all = debrief::unanswered(tree);
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
  }
  return {{"name", tree.name()}, {"kind", platform}, {"nodes", std::move(nodes)}};
}

}  // namespace eyrie::page
