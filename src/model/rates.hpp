// SPDX-License-Identifier: MIT
#pragma once
/// \file  Rates of models that are no whole number of steps.
#include <string>
#include <string_view>
#include <vector>

#include "model/library.hpp"

namespace eyrie::model {

/// One of them: `data.<kind>.<model>.<parameter>`, and why there is no such period.
struct RateProblem {
  std::string_view kind;  ///< "radars", as in files
  std::string model;
  std::string_view parameter;
  std::string problem;
};

/// Of every model on the shelves, flown or not, in steps of `dt` seconds.
[[nodiscard]] std::vector<RateProblem> rate_problems(const Library& library, double dt);

}  // namespace eyrie::model
