// SPDX-License-Identifier: MIT
#pragma once
/// \file  Missiles that one aircraft believes are coming for it.
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"

namespace eyrie::model {

/// What told of the missile, as bits.
enum ThreatSource : std::uint8_t {
  kThreatFromRwr = 1,    ///< its seeker was heard: bearing only
  kThreatFromSight = 2,  ///< it was seen: bearing, elevation and a rough range
  kThreatFromTruth = 4,  ///< privileged state
};

/// One inbound missile as it is perceived.
struct InboundMissile {
  double bearing = 0;             ///< rad, true, in (-pi, pi]
  double elevation = 0;           ///< rad above the horizontal; 0 unless has_position
  double range = 0;               ///< m; 0 unless has_position
  double time = 0;                ///< s, last perceived
  double first_time = 0;          ///< s, first perceived
  PlayerId truth;                 ///< for scoring and debrief only
  std::uint8_t has_position = 0;  ///< 1: elevation and range are known
  std::uint8_t closing = 0;       ///< 1: seen to come closer
  std::uint8_t sources = 0;       ///< bits of ThreatSource, ever
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(
        field("bearing", &InboundMissile::bearing, "rad"),
        field("elevation", &InboundMissile::elevation, "rad"),
        field("range", &InboundMissile::range, "m"), field("time", &InboundMissile::time, "s"),
        field("first_time", &InboundMissile::first_time, "s"),
        field("truth", &InboundMissile::truth),
        field("has_position", &InboundMissile::has_position),
        field("closing", &InboundMissile::closing), field("sources", &InboundMissile::sources),
        field("reserved", &InboundMissile::reserved));
  }
};
static_assert(fields_cover_row<InboundMissile>());

inline constexpr std::size_t kMaxThreats = 4;

/// The inbound missiles of one aircraft, in the order in which they were first perceived.
struct Threats {
  std::array<InboundMissile, kMaxThreats> missiles;
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("missiles", &Threats::missiles), field("count", &Threats::count),
                      field("reserved", &Threats::reserved));
  }
};
static_assert(fields_cover_row<Threats>());

}  // namespace eyrie::model
