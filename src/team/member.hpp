// SPDX-License-Identifier: MIT
#pragma once
/// \file  What it takes to be a member of a flight or a convoy, whatever the platform.
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>

#include "core/vec.hpp"
#include "model/columns.hpp"
#include "model/flight/guidance.hpp"
#include "model/kinematics.hpp"
#include "model/library.hpp"

namespace eyrie::team {

/// Whom a member follows, as it believes.
struct Leader {
  Vec3 position;  ///< m, local frame, now
  Vec3 velocity;  ///< m/s over the ground, local frame
};

/// What a state must offer for the behaviors of this folder.
template <class S>
concept MemberState = requires(const S& s, const Leader& leader) {
  { s.own } -> std::convertible_to<const model::Kinematics&>;
  { s.time } -> std::convertible_to<double>;                      // s
  { s.leads() } -> std::same_as<bool>;                            // nobody to follow
  { s.leader() } -> std::same_as<std::optional<Leader>>;          // whom to follow
  { s.place() } -> std::same_as<Vec3>;                            // m forward, right, down of him
  { s.forward_of(leader) } -> std::same_as<double>;               // rad: where his forward is
  { s.routes() } -> std::same_as<std::span<const model::Route>>;  // of the flight
  { s.nav() } -> std::same_as<model::NavState>;                   // how far along them
  { s.guidance() } -> std::same_as<const model::flight::GuidanceGains&>;  // of the platform
  { s.wind() } -> std::same_as<Vec3>;                                     // m/s, north-east-down
};

/// Where a mate is now, if it has been heard of.
[[nodiscard]] inline std::optional<Leader> heard(const model::Mate& mate, double time) {
  if (!mate.reported)
    return std::nullopt;
  return Leader{position_at(mate, time),
                {static_cast<double>(mate.velocity[0]), static_cast<double>(mate.velocity[1]),
                 static_cast<double>(mate.velocity[2])}};
}

/// The own rank among the living: the next in rank takes over when a lead dies. Before the datalink
/// has come up it is the rank at birth.
[[nodiscard]] inline std::uint32_t rank_now(const model::DatalinkState& datalink,
                                            std::uint32_t rank_at_birth) {
  if (datalink.count == 0)
    return rank_at_birth > 0 ? rank_at_birth : 1;
  return model::datalink::living_rank(datalink);
}

/// Keeps in `known` who is believed to lead. Gives who led before if `self` has just taken over.
[[nodiscard]] inline PlayerId taken_over_from(PlayerId& known, const model::DatalinkState& datalink,
                                              PlayerId self) {
  const model::Mate* lead = model::datalink::lead(datalink);
  if (!lead)
    return {};
  const PlayerId before = known;
  known = lead->id;
  return known == self && before != self ? before : PlayerId{};
}

}  // namespace eyrie::team
