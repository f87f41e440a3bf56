// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "page/column.hpp"

namespace eyrie::page {

using Json = nlohmann::ordered_json;

/// A column as decode.ts expects it.
[[nodiscard]] inline Json put(ColumnBytes& bytes, const Column& column) {
  const ColumnPlace place = bytes.put(column);
  return Json::array({place.offset, place.count, place.quantum, place.order});
}
/// NaN is null.
[[nodiscard]] inline Json number_or_null(double value) {
  return std::isnan(value) ? Json() : Json(value);
}

}  // namespace eyrie::page
