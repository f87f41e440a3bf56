// SPDX-License-Identifier: MIT
#pragma once
/// \file  The wall formation: where each rank flies.
#include <cstdint>

#include "core/units.hpp"
#include "core/vec.hpp"

namespace eyrie::pilot {

/// Spacing from one place of the wall to the next; the defaults are the paper's.
struct Formation {
  double abreast = si(6000, "ft");  ///< m to the side
  double behind = si(1000, "ft");   ///< m back
  double below = si(500, "ft");     ///< m down
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
