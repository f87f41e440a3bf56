// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a Tick carries of a trace, without the type of its actions.
#include <cstddef>
#include <typeinfo>
#include <vector>

#include "ubf/transition.hpp"

namespace eyrie::ubf {

/// What Tick carries of a Trace<Action>; it knows which action it was made for.
class AnyTrace {
 public:
  /// Why a node failed, in words that outlive the trace, such as a literal; null if it did not say.
  [[nodiscard]] const char* why(NodeIndex node) const { return reasons_[node]; }
  void because(NodeIndex node, const char* why) { reasons_[node] = why; }

 protected:
  AnyTrace(const std::type_info& action, std::size_t nodes)
      : action_(&action), reasons_(nodes, nullptr) {}
  ~AnyTrace() = default;

  /// Compared by what it names and not by its place: a plug-in has one of its own.
  const std::type_info* action_;
  std::vector<const char*> reasons_;
};

}  // namespace eyrie::ubf
