// SPDX-License-Identifier: MIT
#pragma once
/// \file  From a library, trees and starts to a simulation and its first world.
#include "core/diagnostics.hpp"
#include "model/frames.hpp"
#include "model/weapon/stores.hpp"
#include "scenario/player_kind.hpp"
#include "scenario/scenario.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {

/// m; the local frame promises its accuracy so far out (docs/models/frames.md).
inline constexpr double kReach = 500e3;

/// How one aircraft begins; in the order of the roster.
struct Start {
  Vec3 position;       ///< m, local frame
  double heading = 0;  ///< rad, true
  double speed = 0;    ///< m/s true airspeed
  double fuel = 0;     ///< kg
  double bingo = 0;    ///< kg
  std::optional<std::uint16_t> rounds;
  std::uint16_t type = 0;
  std::optional<std::uint16_t> tree;
  bool privileged = false;
  std::array<model::Station, model::kMaxStations> stations{};
  std::optional<Spread> spread;
};

/// How one vehicle begins; in the order of the roster, behind the aircraft.
struct VehicleStart {
  Vec3 position;       ///< m, local frame
  double heading = 0;  ///< rad, true
  double speed = 0;    ///< m/s
  std::uint16_t type = 0;
  std::optional<std::uint16_t> tree;
};

/// The place `offset` (forward, right, down) from a lead that flies `heading` (rad).
[[nodiscard]] Vec3 beside(const Reference& reference, const Vec3& lead, double heading,
                          const Vec3& offset);

/// Builds schema, systems and start world of a scenario whose spec, roster, library and trees are
/// complete. Gives why that is impossible (a rate that does not divide), or "".
[[nodiscard]] std::string assemble(Scenario& scenario, std::span<const Start> starts,
                                   std::span<const VehicleStart> vehicles,
                                   std::span<const std::unique_ptr<PlayerKind>> kinds = {});

/// The point of the local frame `north` and `east` (m) of the reference point whose height above
/// the ellipsoid is `altitude` (m). No libm: the same bits everywhere. What lies as far west
/// instead of east gets the same bits, too.
[[nodiscard]] Vec3 at_altitude(const Reference& reference, double north, double east,
                               double altitude);

/// Resolves a place. One that says neither or both ways, or half of one, is a mistake at `where`;
/// so is a place more than 500 km from the reference point.
[[nodiscard]] Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
                           const Location& where, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
