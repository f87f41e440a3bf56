// SPDX-License-Identifier: MIT
#pragma once
/// \file  What hangs under an aircraft, and when the next of it may leave.
#include "model/weapon/missile.hpp"

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

/// How many missiles hang on all stations.
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
