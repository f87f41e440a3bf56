// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a radar warning receiver shows.
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"
#include "model/emission.hpp"

namespace eyrie::model::sensor {

/// One emitter on the display: where from and what kind, never how far.
struct RwrWarning {
  double bearing = 0;      ///< rad, true, clockwise from north, in (-pi, pi]
  double time = 0;         ///< s, last heard
  double first_time = 0;   ///< s, first heard without a gap
  PlayerId emitter{};      ///< fingerprint of the pulse train: tells emitters apart, and debrief
  std::uint16_t type = 0;  ///< as Emission::type
  EmissionKind kind = EmissionKind::none;
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(field("bearing", &RwrWarning::bearing, "rad"),
                      field("time", &RwrWarning::time, "s"),
                      field("first_time", &RwrWarning::first_time, "s"),
                      field("emitter", &RwrWarning::emitter), field("type", &RwrWarning::type),
                      field("kind", &RwrWarning::kind), field("reserved", &RwrWarning::reserved));
  }
};
static_assert(fields_cover_row<RwrWarning>());

inline constexpr std::size_t kMaxWarnings = 8;

/// The warnings of one aircraft, the most urgent kind first, then the one heard first.
struct RwrState {
  std::array<RwrWarning, kMaxWarnings> warnings{};
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("warnings", &RwrState::warnings), field("count", &RwrState::count),
                      field("reserved", &RwrState::reserved));
  }
};
static_assert(fields_cover_row<RwrState>());

}  // namespace eyrie::model::sensor
