// SPDX-License-Identifier: MIT
#pragma once
/// \file  Behaviors that are written in Python: node types made at run time.
#include <nanobind/nanobind.h>

#include "scenario/plugin.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::python {
namespace nb = nanobind;

class BehaviorType;

/// eyrie._core.Behavior: what a scenario may name. Trees hold it as long as
/// they live.
struct Behavior {
  std::shared_ptr<const BehaviorType> type;
};

/// Adds them to what the trees of a scenario are made of; nothing for none.
[[nodiscard]] scenario::AddNodes adds(const std::vector<Behavior>& behaviors);

}  // namespace eyrie::python
