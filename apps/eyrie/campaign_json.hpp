// SPDX-License-Identifier: MIT
#pragma once
/// \file  Estimates of campaigns and searches in JSON.
#include <cmath>
#include <nlohmann/json.hpp>

#include "campaign/estimate.hpp"

namespace eyrie::app {

[[nodiscard]] inline nlohmann::ordered_json number_or_null(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
}

/// [low, high], null for what there is not.
[[nodiscard]] inline nlohmann::ordered_json interval_json(const std::optional<stats::Interval>& i) {
  if (!i)
    return {nullptr, nullptr};
  return {number_or_null(i->low), number_or_null(i->high)};
}

/// [value, low, high], null for what there is not.
[[nodiscard]] inline nlohmann::ordered_json estimate_json(const campaign::Estimate& e) {
  const nlohmann::ordered_json ends = interval_json(e.interval);
  return {e.value ? number_or_null(*e.value) : nullptr, ends[0], ends[1]};
}

}  // namespace eyrie::app
