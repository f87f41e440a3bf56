// SPDX-License-Identifier: MIT
#pragma once
/// \file  What numbers are rounded to in the page.
#include <string_view>

#include "ubf/state_fields.hpp"

namespace eyrie::page {

/// Of what is decided with, by unit.
[[nodiscard]] inline double quantum_of(std::string_view unit) {
  return unit == "rad" ? 1e-6 : unit == "m" ? 1e-3 : 1e-4;
}
/// Of a field of a state, or of an action as conditions name it.
[[nodiscard]] inline double quantum_of(const ubf::StateFieldInfo& field) {
  return field.kind == ubf::FieldKind::number ? quantum_of(field.unit.si_symbol) : 1;
}

}  // namespace eyrie::page
