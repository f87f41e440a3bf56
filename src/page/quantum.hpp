// SPDX-License-Identifier: MIT
#pragma once
/// \file  What numbers are rounded to in the page.
#include <string_view>

namespace eyrie::page {

/// Of what is decided with, by unit.
[[nodiscard]] inline double quantum_of(std::string_view unit) {
  return unit == "rad" ? 1e-6 : unit == "m" ? 1e-3 : 1e-4;
}

}  // namespace eyrie::page
