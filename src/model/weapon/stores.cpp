// SPDX-License-Identifier: MIT
#include "model/weapon/stores.hpp"

#include <algorithm>

namespace eyrie::model::weapon {

namespace {

/// Tells a due time from one that is a rounding later: a hundredth of any sensible step.
constexpr double kSlack = 1e-4;

std::optional<std::uint8_t> station_with(const Stores& stores, std::uint16_t type) {
  for (std::uint8_t i = 0; i < stores.stations.size(); ++i)
    if (stores.stations[i].store == type + 1 && stores.stations[i].count > 0)
      return i;
  return std::nullopt;
}

}  // namespace

std::uint32_t missiles_left(const Stores& stores) {
  std::uint32_t count = 0;
  for (const Station& station : stores.stations)
    if (station.store != 0)
      count += station.count;
  return count;
}

bool can_release(const Stores& stores, std::uint16_t type, double time) {
  return !stores.pending_track && time + kSlack >= stores.ready_time &&
         station_with(stores, type).has_value();
}

void begin_release(Stores& stores, std::uint16_t type, const MissileType& missile, TrackId track,
                   double time) {
  EYRIE_ASSERT(can_release(stores, type, time) && track);
  stores.pending_track = track;
  stores.pending_station = station_with(stores, type).value_or(0);
  stores.launch_time = time + missile.launch_delay;
  stores.ready_time = time + std::max(missile.release_interval, missile.launch_delay);
}

std::optional<Ejection> finish_release(Stores& stores, bool track_held, double time) {
  if (!stores.pending_track || time + kSlack < stores.launch_time)
    return std::nullopt;
  const TrackId track = stores.pending_track;
  stores.pending_track = {};
  Station& station = stores.stations[stores.pending_station];
  if (!track_held || station.count == 0)
    return std::nullopt;
  --station.count;
  Ejection ejection{.station = stores.pending_station,
                    .type = static_cast<std::uint16_t>(station.store - 1),
                    .track = track};
  if (missiles_left(stores) == 0 && stores.winchester == 0) {
    stores.winchester = 1;
    ejection.last = true;
  }
  return ejection;
}

}  // namespace eyrie::model::weapon
