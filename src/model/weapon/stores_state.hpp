// SPDX-License-Identifier: MIT
#pragma once
/// \file  What hangs under one aircraft, and the release that is under way.
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"

namespace eyrie::model::weapon {

/// One station: `count` stores of one type.
struct Station {
  std::uint8_t store = 0;  ///< 1 + index of the MissileType in the Library; 0: nothing
  std::uint8_t count = 0;

  static constexpr auto fields() {
    return field_list(field("store", &Station::store), field("count", &Station::count));
  }
};

inline constexpr std::size_t kMaxStations = 12;

/// The stores of one aircraft. A release begins a launch; the store leaves its station when the
/// launch delay is over, unless the target's track is gone by then.
struct Stores {
  std::array<Station, kMaxStations> stations{};
  double ready_time = 0;             ///< s: no release before
  double launch_time = 0;            ///< s: when the store that was released leaves
  TrackId pending_track{};           ///< the target of that store; none: no release is under way
  std::uint8_t pending_station = 0;  ///< its station
  std::uint8_t winchester = 0;       ///< 1 once the last missile has left
  std::uint8_t reserved[2] = {};

  static constexpr auto fields() {
    return field_list(
        field("stations", &Stores::stations), field("ready_time", &Stores::ready_time, "s"),
        field("launch_time", &Stores::launch_time, "s"),
        field("pending_track", &Stores::pending_track),
        field("pending_station", &Stores::pending_station),
        field("winchester", &Stores::winchester), field("reserved", &Stores::reserved));
  }
};
static_assert(fields_cover_row<Stores>());

}  // namespace eyrie::model::weapon
