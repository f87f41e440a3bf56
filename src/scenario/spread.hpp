// SPDX-License-Identifier: MIT
#pragma once
/// \file  Starts that differ from seed to seed.
#include "model/columns.hpp"
#include "model/environment.hpp"
#include "model/frames.hpp"
#include "scenario/plan.hpp"
#include "scenario/spec.hpp"
#include "sim/world.hpp"

namespace eyrie::scenario {

/// How the start of one aircraft differs from seed to seed.
struct Spread {
  PlayerId player{};    ///< whose start it is
  PlayerId drawn_by{};  ///< whose draws move it: its own, or those of the lead of its flight
  Vec3 place = {};      ///< m, local frame: unmoved, its own or that of its lead
  Vec3 offset = {};     ///< m, from there in the formation: forward, right, down
  double lead_off = 0;  ///< rad, of the lead's heading to the right of its own
  double altitude = 0;  ///< m, of that place
  double heading = 0;   ///< rad, true
  double speed = 0;     ///< m/s
  SpreadSpec by;
};

/// What is said of a player; nothing if it begins the same with every seed. `of` has the player,
/// the lead of its flight, the place where it begins or to which its offset is, and that offset.
/// Whoever says it himself is moved by himself, everybody else as his flight is. Reported are
/// starts that are or could be below the surface or above what anybody may begin at, slower than
/// anything flies, or beyond the local frame.
[[nodiscard]] std::optional<Spread> spread_of(const PlayerPlan& player, Spread of,
                                              const Reference& reference, Diagnostics& diagnostics);

/// Moves the starts of a world at step 0 as its seed says: each amount is even in its range, a draw
/// of (seed, Spread::drawn_by, Stream::start). Heading and altitude of the first command, too.
void scatter(std::span<const Spread> spreads, const Reference& reference,
             const model::Environment& environment, const model::AircraftColumns& columns,
             sim::World& world);

}  // namespace eyrie::scenario
