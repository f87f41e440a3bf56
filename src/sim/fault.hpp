// SPDX-License-Identifier: MIT
#pragma once
/// \file  Why a step could not be finished.
#include <cstdint>
#include <string>
#include <string_view>
#include <typeinfo>

#include "core/id.hpp"

namespace eyrie::sim {

/// Somebody's code threw in a step, or gave a value that means nothing (NaN, infinity, 1e300). The
/// step is not finished and nobody observes it; the run ends with the last whole one.
struct Fault {
  PlayerId player{};
  std::string agent = {};  ///< whose part it was: the tree and the path of the node; may be empty
  const std::type_info* node = nullptr;  ///< its type, by which the library with its code is found
  std::string what = {};                 ///< "heading is nan rad", "threw: no fuel"
  std::string_view system = {};          ///< filled in by the step
  std::uint64_t step = 0;                ///< likewise: the one that was not finished
};

}  // namespace eyrie::sim
