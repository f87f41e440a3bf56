// SPDX-License-Identifier: MIT
#include "team/explain.hpp"

namespace eyrie::team {

std::vector<Answer> unanswered(const ubf::TreeOutline& tree) {
  std::vector<Answer> all;
  for (const ubf::NodeOutline& node : tree.nodes) {
    Answer answer{.label = node.spoken,
                  .type = node.type,
                  .path = node.path,
                  .depth = node.depth,
                  .parent = node.parent,
                  .is_leaf = node.is_leaf};
    if (node.is_condition)
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

}  // namespace eyrie::team
