// SPDX-License-Identifier: MIT
#pragma once
/// \file  Estimates of campaigns and searches in JSON.
#include <nlohmann/json.hpp>

#include "campaign/estimate.hpp"

namespace eyrie::app {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json number_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

/// [value, low, high], null for what there is not.
[[nodiscard]] inline Json estimate_json(const campaign::Estimate& e) {
  return {e.value ? number_or_null(*e.value) : Json(),
          e.interval ? number_or_null(e.interval->low) : Json(),
          e.interval ? number_or_null(e.interval->high) : Json()};
}

}  // namespace eyrie::app
