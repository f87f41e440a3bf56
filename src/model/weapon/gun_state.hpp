// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one aircraft's gun remembers.
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"

namespace eyrie::model::weapon {

/// Rounds left and the burst that is being fired.
struct GunState {
  double owed = 0;                 ///< rounds, the part of one that a step of firing left over
  double burst_range = 0;          ///< m, to what was in the sight when the burst began
  std::uint32_t rounds = 0;        ///< left in the drum
  std::uint32_t burst_rounds = 0;  ///< fired so far in this burst; 0: not firing
  std::uint32_t burst_hits = 0;    ///< of these, how many hit
  PlayerId burst_target{};         ///< who was in the sight when the burst began; none if nobody

  static constexpr auto fields() {
    return field_list(
        field("owed", &GunState::owed), field("burst_range", &GunState::burst_range, "m"),
        field("rounds", &GunState::rounds), field("burst_rounds", &GunState::burst_rounds),
        field("burst_hits", &GunState::burst_hits), field("burst_target", &GunState::burst_target));
  }
};
static_assert(fields_cover_row<GunState>());

}  // namespace eyrie::model::weapon
