// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a Tick carries of a trace, without the type of its actions.
#include <cstddef>
#include <span>
#include <typeinfo>
#include <vector>

#include "ubf/transition.hpp"
#include "ubf/vote_curve.hpp"

namespace eyrie::ubf {

/// What Tick carries of a Trace<Action>; it knows which action it was made for.
class AnyTrace {
 public:
  /// Why a node failed, in words that outlive the trace, such as a literal; null if it did not say.
  [[nodiscard]] const char* why(NodeIndex node) const { return reasons_[node]; }
  void because(NodeIndex node, const char* why) { reasons_[node] = why; }
  /// What the considerations of a node's vote came to.
  [[nodiscard]] const VoteCurve::Scores& scores(NodeIndex node) const { return scores_[node]; }
  void weighed(NodeIndex node, const VoteCurve::Scores& scores) { scores_[node] = scores; }
  /// Told before a node is asked, so that it is known who threw: the one that was asked last and
  /// has not answered.
  void asking(NodeIndex node) { asked_.push_back(node); }
  void answered() { asked_.pop_back(); }
  [[nodiscard]] std::span<const NodeIndex> unanswered() const { return asked_; }

 protected:
  AnyTrace(const std::type_info& action, std::size_t nodes)
      : action_(&action), reasons_(nodes, nullptr), scores_(nodes) {
    asked_.reserve(64);  // no tree is deeper
  }
  ~AnyTrace() = default;

  /// Compared by what it names and not by its place: a plug-in has one of its own.
  const std::type_info* action_;
  std::vector<const char*> reasons_;
  std::vector<VoteCurve::Scores> scores_;
  std::vector<NodeIndex> asked_;
};

}  // namespace eyrie::ubf
