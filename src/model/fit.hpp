// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a player is made of: indices into the const Library, set at birth.
#include <cstdint>

#include "core/id.hpp"

namespace eyrie::model {

enum class Side : std::uint8_t { none, blue, red };

/// Set when an aircraft is born and never changed.
struct Fit {
  std::uint16_t type = 0;    ///< index of the AircraftType in the Library
  std::uint16_t flight = 0;  ///< index of the Flight in the Library
  std::uint16_t rank = 0;    ///< rank at birth, 1 = lead (the number in 'eagle1')
  Side side = Side::none;
  std::uint8_t privileged = 0;  ///< 1: tracks are the truth, as in the paper
};

}  // namespace eyrie::model
