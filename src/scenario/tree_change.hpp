// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "ubf/spec.hpp"

namespace eyrie::scenario {

/// A change of one node of the tree of that name, beside what files say.
struct TreeChange {
  std::string tree;
  ubf::NodeChange change;
};

}  // namespace eyrie::scenario
