// SPDX-License-Identifier: MIT
#pragma once
/// \file  How badly one aircraft has been hit.
#include "core/field.hpp"

namespace eyrie::model::weapon {

/// Written in commit only.
struct Damage {
  double damage = 0;       ///< 0 whole, 1 or more destroyed
  PlayerId last_hit_by{};  ///< shooter of the last hit; none if there was none
  std::uint32_t hits = 0;  ///< hits so far

  static constexpr auto fields() {
    return field_list(field("damage", &Damage::damage), field("last_hit_by", &Damage::last_hit_by),
                      field("hits", &Damage::hits));
  }
};

}  // namespace eyrie::model::weapon
