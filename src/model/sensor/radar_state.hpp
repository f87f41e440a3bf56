// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a radar is doing: the memory of one aircraft's radar.
#include <array>
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"

namespace eyrie::model::sensor {

enum class RadarMode : std::uint8_t {
  off,
  search,  ///< track while scan: one look per frame at everything in the scan volume
  track,   ///< single target track: looks at nothing else, many times a second
};

}  // namespace eyrie::model::sensor

template <>
struct eyrie::EnumNames<eyrie::model::sensor::RadarMode> {
  using E = eyrie::model::sensor::RadarMode;
  static constexpr std::array names{std::pair<std::string_view, E>{"off", E::off},
                                    std::pair<std::string_view, E>{"search", E::search},
                                    std::pair<std::string_view, E>{"track", E::track}};
};

namespace eyrie::model::sensor {

/// Angles of the scan are stabilised: azimuth from the own heading, elevation from the horizon.
struct RadarState {
  double scan_azimuth = 0;    ///< rad, middle of the scan, clockwise from the heading
  double scan_elevation = 0;  ///< rad, middle of the scan, up from the horizontal
  double lock_time = 0;       ///< s, last detection in track mode, or when the mode was entered
  double search_until = 0;    ///< s, no new lock before: the frame after a lock was lost
  TrackId designated{};       ///< the track that the scan follows
  PlayerId locked{};          ///< whose echo the range gate rests on in track mode
  RadarMode mode = RadarMode::off;
  std::uint8_t reserved[7] = {};

  static constexpr auto fields() {
    return field_list(field("scan_azimuth", &RadarState::scan_azimuth, "rad"),
                      field("scan_elevation", &RadarState::scan_elevation, "rad"),
                      field("lock_time", &RadarState::lock_time, "s"),
                      field("search_until", &RadarState::search_until, "s"),
                      field("designated", &RadarState::designated),
                      field("locked", &RadarState::locked), field("mode", &RadarState::mode),
                      field("reserved", &RadarState::reserved));
  }
};
static_assert(fields_cover_row<RadarState>());

}  // namespace eyrie::model::sensor
