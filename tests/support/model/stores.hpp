// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: stores hung on stations by name, and counted.
#include "model/library.hpp"
#include "model/weapon/stores.hpp"

namespace eyrie::model::weapon {

/// What a scenario hangs under an aircraft of which it says nothing else.
[[nodiscard]] inline Stores load_stores(std::span<const StationFit> stations,
                                        const Shelf<MissileType>& missiles) {
  Stores stores;
  for (std::size_t i = 0; i < stations.size(); ++i)
    stores.stations.at(i) = {
        .store = static_cast<std::uint8_t>(missiles.find(stations[i].store).value() + 1),
        .count = stations[i].count};
  return stores;
}

/// How many of a store type (an index into the library) hang on all stations.
[[nodiscard]] inline std::uint32_t count_of(const Stores& stores, std::uint16_t type) {
  std::uint32_t count = 0;
  for (const Station& station : stores.stations)
    count += station.store == type + 1 ? station.count : 0;
  return count;
}

}  // namespace eyrie::model::weapon
