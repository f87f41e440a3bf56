// SPDX-License-Identifier: MIT
#include "team/explain.hpp"

#include <algorithm>
#include <functional>

#include "ubf/spec.hpp"

namespace eyrie::team {
namespace {

/// What a node is in a sentence: a condition in its words, if it has no label.
std::string spoken(const ubf::AnyNode& node) {
  if (node.label() != node.type())
    return std::string(node.label());
  if (node.type() == ubf::kHolds)
    return node.values().front().text;
  if (node.type() == "inverter" && node.children().size() == 1)
    return "not " + spoken(*node.children()[0]);
  return std::string(node.label());
}

/// What a node, or somebody below it, proposes for a field now, or holds; null: nothing.
const Value* proposal_of(const Answer& node, const std::string& field) {
  const auto found = std::ranges::find(node.action, field, &Value::name);
  return found == node.action.end() ? nullptr : &*found;
}

/// Whether the field that an arbiter blended is made of what a leaf proposed.
bool is_part_of(const std::vector<Answer>& nodes, ubf::NodeIndex leaf, ubf::NodeIndex arbiter,
                const std::string& field) {
  for (std::size_t n = arbiter + 1U; n < nodes.size() && nodes[n].depth > nodes[arbiter].depth;
       ++n) {
    const Value* const value = proposal_of(nodes[n], field);
    if (nodes[n].parent == arbiter && value && nodes[n].counted() > 0 &&
        nodes[n].set_aside.empty() &&
        (value->supplier == leaf ||
         (!nodes[value->supplier].is_leaf && is_part_of(nodes, leaf, value->supplier, field))))
      return true;
  }
  return false;
}

}  // namespace

std::vector<Answer> unanswered(const ubf::AnyTree& tree) {
  std::vector<Answer> all;
  std::vector<std::string> paths = tree.paths();
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto index = static_cast<ubf::NodeIndex>(i);
    const ubf::AnyNode& node = tree.node(index);
    Answer answer{.label = spoken(node),
                  .type = std::string(node.type()),
                  .path = std::move(paths[i]),
                  .where = node.where(),
                  .decided_by = std::string(node.decided_by()),
                  .depth = static_cast<std::uint16_t>(tree.depth(index)),
                  .parent = tree.parent(index),
                  .is_leaf = node.children().empty()};
    if (node.node_kind() == ubf::Kind::condition)
      answer.why = "does not hold";  // if it fails without a word of its own
    all.push_back(std::move(answer));
  }
  return all;
}

std::pair<ubf::NodeIndex, ubf::NodeIndex> parting(const std::vector<Answer>& nodes,
                                                  ubf::NodeIndex a, ubf::NodeIndex b) {
  std::pair at{a, b};
  while (a != b) {
    ubf::NodeIndex& deeper = nodes[a].depth >= nodes[b].depth ? a : b;
    (&deeper == &a ? at.first : at.second) = deeper;
    deeper = nodes[deeper].parent;
  }
  return at;
}

const std::string& decided_by(const std::vector<Answer>& nodes,
                              std::pair<ubf::NodeIndex, ubf::NodeIndex> parted) {
  const auto [a, b] = parted;
  return nodes[nodes[nodes[a].depth > nodes[b].depth ? a : b].parent].decided_by;
}

ubf::NodeIndex lost_in(const std::vector<Answer>& nodes, ubf::NodeIndex node, ubf::NodeIndex top) {
  const auto comes_up = [&](const Value& v) {  // a blend may be made of it
    return v.supplier == node || v.supplier >= nodes.size() || !nodes[v.supplier].is_leaf;
  };
  for (ubf::NodeIndex at = node; at != top && !nodes[node].action.empty();) {
    at = nodes[at].parent;
    if (!std::ranges::any_of(nodes[at].action, comes_up))
      return at;
  }
  return ubf::kNone;
}

std::vector<Won> contest(const std::vector<Answer>& nodes) {
  std::vector<Won> all;
  for (const Value& value : nodes[0].action) {
    const ubf::NodeIndex winner = value.supplier;
    Won won{.value = value,
            .winner = winner,
            .blended = !value.held && !nodes[winner].is_leaf,
            .held = value.held,
            .rivals = {}};
    const auto has_it = [&](ubf::NodeIndex node) {
      const Value* const proposed = proposal_of(nodes[node], value.name);
      return proposed && proposed->held == value.held;
    };
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto node = static_cast<ubf::NodeIndex>(n);
      const Value* const proposed = proposal_of(nodes[n], value.name);
      if (node == winner || !nodes[n].is_leaf || !proposed)
        continue;
      auto [its, mine] = parting(nodes, node, winner);
      const std::string& by = decided_by(nodes, {its, mine});
      while (!has_it(mine))
        mine = nodes[mine].parent;  // up to who holds it; the root has it
      const float vote = nodes[its].counted(), against = nodes[mine].counted();
      won.rivals.push_back(
          {.node = node,
           .value = *proposed,
           .against = against,
           .vote = vote,
           .decided_by = by,
           .came_up = proposal_of(nodes[its], value.name) && (vote > 0 || against == 0),
           .blended = won.blended && is_part_of(nodes, node, winner, value.name),
           .set_aside = nodes[its].set_aside});
    }
    std::ranges::stable_sort(won.rivals, std::greater<>(), [](const Rival& r) {
      return std::tuple(r.blended, r.came_up, r.vote);
    });
    all.push_back(std::move(won));
  }
  return all;
}

}  // namespace eyrie::team
