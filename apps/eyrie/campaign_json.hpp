// SPDX-License-Identifier: MIT
#pragma once
/// \file  Estimates of campaigns and searches in JSON.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "campaign/estimate.hpp"

namespace eyrie::app {

[[nodiscard]] inline nlohmann::ordered_json number_or_null(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
}

/// [value, low, high], null for what there is not.
[[nodiscard]] inline nlohmann::ordered_json estimate_json(const campaign::Estimate& e) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  return {number_or_null(e.value.value_or(nothing)),
          number_or_null(e.interval ? e.interval->low : nothing),
          number_or_null(e.interval ? e.interval->high : nothing)};
}

}  // namespace eyrie::app
