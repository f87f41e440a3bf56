// SPDX-License-Identifier: MIT
#pragma once
/// \file  The wall formation: where each rank flies.
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/units.hpp"
#include "core/vec.hpp"

namespace eyrie::pilot {

/// Spacing from one place of the wall to the next; the defaults are the paper's.
struct Formation {
  double abreast = si(6000, "ft");  ///< m to the side
  double behind = si(1000, "ft");   ///< m back
  double below = si(500, "ft");     ///< m down

  static constexpr std::string_view type_name = "formation";
  static constexpr std::string_view help = "the wall formation: spacing from one place to the next";
  static constexpr auto params() {
    using F = Formation;
    return std::tuple{
        param("abreast", &F::abreast, "m", range(50, 50e3), "to the side of the lead, per place"),
        param("behind", &F::behind, "m", range(-50e3, 50e3), "behind the lead, per place"),
        param("below", &F::below, "m", range(-5e3, 5e3), "below the lead, per place")};
  }
};

/// Where a rank stands, in m forward, right and down of the lead's heading. Rank 2 is the first
/// place on the left (the paper's eagle2), 3 and 4 the first and second on the right, 5 the second
/// on the left, 6 the third on the right and so on outwards. Rank 1 is the lead itself.
[[nodiscard]] constexpr Vec3 formation_offset(const Formation& formation, std::uint32_t rank) {
  if (rank <= 1)
    return {};
  constexpr int kPlaces[] = {-1, 1, 2, -2, 3, -3, 4};
  const int place = kPlaces[(rank - 2) % 7];
  const double out = place < 0 ? -place : place;
  return {-out * formation.behind, place * formation.abreast, out * formation.below};
}

}  // namespace eyrie::pilot
