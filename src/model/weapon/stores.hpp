// SPDX-License-Identifier: MIT
#pragma once
/// \file  The book-keeping of stations: what hangs where, and when the next may leave.
#include <cstdint>
#include <optional>
#include <span>

#include "model/aircraft_type.hpp"
#include "model/library.hpp"
#include "model/weapon/stores_state.hpp"

namespace eyrie::model::weapon {

/// The stores of an aircraft at birth. std::logic_error for a store that is not in the library, for
/// more stations than kMaxStations and for more than 255 missile types.
[[nodiscard]] Stores load_stores(std::span<const StationFit> stations,
                                 const Shelf<MissileType>& missiles);

/// How many of a store type (an index into the library) hang on all stations.
[[nodiscard]] std::uint32_t count_of(const Stores& stores, std::uint16_t type);
/// How many missiles of any type.
[[nodiscard]] std::uint32_t missiles_left(const Stores& stores);

/// Whether a store of that type may be released at `time` (s): one hangs there, none is on its way
/// and the interval since the last release is over.
[[nodiscard]] bool can_release(const Stores& stores, std::uint16_t type, double time);

/// Begins the launch of the first store of the type (can_release) at a track.
void begin_release(Stores& stores, std::uint16_t type, const MissileType& missile, TrackId track,
                   double time);

/// A launch whose delay is over.
struct Ejection {
  std::uint8_t station = 0;
  std::uint16_t type = 0;  ///< index of the MissileType
  TrackId track;
  bool last = false;  ///< no missile is left behind: true once in a life
};
/// The launch that is due at `time`, if any. With `track_held` the store leaves its station;
/// without it, it stays. Either way nothing is under way afterwards.
[[nodiscard]] std::optional<Ejection> finish_release(Stores& stores, bool track_held, double time);

}  // namespace eyrie::model::weapon
