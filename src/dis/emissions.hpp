// SPDX-License-Identifier: MIT
#pragma once
/// \file  Radars, seekers and jammers of a world as systems and beams of an Emission.
#include <functional>

#include "dis/pdu.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::dis {

/// The number in the exercise of a player.
using IdOf = std::function<EntityId(PlayerId)>;

/// A beam that tracks more says that it is crowded, and lists none.
inline constexpr std::size_t kMostTargets = 10;

/// Of an aircraft: its radar, which is there with no beam while it is silent, and its jammer.
[[nodiscard]] std::vector<Emission::System> systems_of(const scenario::Scenario& scenario,
                                                       const sim::World& world, std::size_t row,
                                                       const IdOf& id_of);
/// Of a missile: its seeker, from when it is active.
[[nodiscard]] std::vector<Emission::System> seeker_of(const scenario::Scenario& scenario,
                                                      const sim::World& world, std::size_t row,
                                                      const IdOf& id_of);

/// Whether others must hear of the change: another beam, function or target, or a beam that points
/// elsewhere by more than `angle` (rad).
[[nodiscard]] bool differs(std::span<const Emission::System> a, std::span<const Emission::System> b,
                           double angle);

}  // namespace eyrie::dis
