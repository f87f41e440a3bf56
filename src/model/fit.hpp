// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a player is made of: indices into the const Library, set at birth.
#include "core/field.hpp"

namespace eyrie::model {

enum class Side : std::uint8_t { none, blue, red };
constexpr auto names_of(Side) {
  return names_from_zero<Side>("none", "blue", "red");
}

/// A flight has at most so many members.
inline constexpr std::size_t kMaxFlight = 8;

/// Set when an aircraft is born and never changed.
struct Fit {
  std::uint16_t type = 0;    ///< index of the AircraftType in the Library
  std::uint16_t flight = 0;  ///< index of the Flight in the Library
  std::uint8_t rank = 0;     ///< rank at birth, 1 = lead (the number in 'eagle1')
  std::uint8_t remote = 0;   ///< 1: another program flies it, see model/remote.hpp
  Side side = Side::none;
  std::uint8_t privileged = 0;  ///< 1: tracks are the truth, as in the paper

  static constexpr auto fields() {
    return field_list(field("type", &Fit::type), field("flight", &Fit::flight),
                      field("rank", &Fit::rank), field("remote", &Fit::remote),
                      field("side", &Fit::side), field("privileged", &Fit::privileged));
  }
};

}  // namespace eyrie::model
