// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where everybody was, as rows of a table.
#include <array>
#include <functional>

#include "scenario/scenario.hpp"

namespace eyrie::tables {

struct TrackColumn {
  std::string_view name, unit, help;
  int decimals;  ///< that a file keeps
};
inline constexpr std::array kTrackColumns = std::to_array<TrackColumn>({
    {"time_s", "s", "when", 3},
    {"north_m", "m", "from the scenario's reference", 2},
    {"east_m", "m", "likewise", 2},
    {"altitude_m", "m", "above the ellipsoid", 2},
    {"latitude_deg", "deg", "WGS 84", 7},
    {"longitude_deg", "deg", "WGS 84", 7},
    {"heading_deg", "deg", "of the nose, true", 2},
    {"pitch_deg", "deg", "nose up", 2},
    {"roll_deg", "deg", "right wing down", 2},
    {"speed_m_s", "m/s", "through the air; of vehicles over the ground", 2},
    {"mach", "", "of aircraft", 3},
    {"load_factor", "", "g, of aircraft", 2},
    {"fuel_kg", "kg", "of aircraft", 1},
});
/// A value for each column; NaN for none.
using TrackRow = std::array<double, kTrackColumns.size()>;

/// s between two rows of one player, of one missile.
struct TrackRates {
  double players = 1, missiles = 0.2;
};

/// Calls `use(id, row)` for everybody who has a row due after a step (World::step()); all have one
/// at step 0.
void each_track(const scenario::Scenario& scenario, const sim::World& world,
                const TrackRates& rates, const std::function<void(PlayerId, const TrackRow&)>& use);

}  // namespace eyrie::tables
