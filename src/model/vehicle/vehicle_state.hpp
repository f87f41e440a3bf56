// SPDX-License-Identifier: MIT
#pragma once
/// \file  The rows of one ground vehicle besides place and radio.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/field.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"
#include "model/flight/flying.hpp"
#include "model/track.hpp"

namespace eyrie::model::vehicle {

/// What the driver asks of the vehicle: written in decide.
struct DriveCommand {
  double heading = 0;  ///< rad, true
  double speed = 0;    ///< m/s; 0 stands

  static constexpr auto fields() {
    return field_list(field("heading", &DriveCommand::heading, "rad"),
                      field("speed", &DriveCommand::speed, "m/s"));
  }
};

/// Written in move.
struct Driving {
  double steering = 0;  ///< rad, of the front wheels, positive right
  flight::NavState nav = {};
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("steering", &Driving::steering, "rad"), field("nav", &Driving::nav),
                      field("reserved", &Driving::reserved));
  }
};
static_assert(fields_cover_row<Driving>());

/// An aircraft that the driver has seen, or was told of over the radio.
struct Sighted {
  Vec3 position{};            ///< m, local frame, as estimated at `time`
  double time = 0;            ///< s, of the last that was seen or told of it
  double seen_time = kNever;  ///< s, last seen with the own eyes
  PlayerId truth{};           ///< whose light it was; none: an empty place
  Identity identity = Identity::unknown;
  std::uint8_t reserved[3] = {};

  static constexpr auto fields() {
    return field_list(field("position", &Sighted::position, "m"),
                      field("time", &Sighted::time, "s"),
                      field("seen_time", &Sighted::seen_time, "s"), field("truth", &Sighted::truth),
                      field("identity", &Sighted::identity), field("reserved", &Sighted::reserved));
  }
};
static_assert(fields_cover_row<Sighted>());

/// The aircraft that a driver keeps in mind, written in perceive. Who watches a handful of aircraft
/// does not mix them up: a sighting belongs to the aircraft it was of.
struct Lookout {
  static constexpr std::size_t kAircraft = 4;
  std::array<Sighted, kAircraft> sighted{};
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  [[nodiscard]] std::span<const Sighted> all() const { return {sighted.data(), count}; }
  [[nodiscard]] Sighted* find(PlayerId truth) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (sighted[i].truth == truth)
        return &sighted[i];
    return nullptr;
  }

  static constexpr auto fields() {
    return field_list(field("sighted", &Lookout::sighted), field("count", &Lookout::count),
                      field("reserved", &Lookout::reserved));
  }
};
static_assert(fields_cover_row<Lookout>());

}  // namespace eyrie::model::vehicle
