// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one pilot perceives at one decision: a view of his own rows, never of the truth.
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "model/columns.hpp"
#include "model/library.hpp"
#include "pilot/agent.hpp"
#include "pilot/formation.hpp"
#include "pilot/geometry.hpp"

namespace eyrie::pilot {

/// One track as seen from the cockpit, carried on to the time of the decision.
struct Seen {
  const model::Track* track = nullptr;
  Vec3 ned;            ///< m, from the ownship, north-east-down at the ownship
  Vec3 velocity;       ///< m/s over the ground, same axes
  double range = 0;    ///< m
  double closing = 0;  ///< m/s, positive if the range shrinks

  [[nodiscard]] bool hostile() const {
    return track->confirmed && track->identity == model::Identity::hostile;
  }
  [[nodiscard]] TrackId id() const { return track->id; }
};

/// What does not change about one flight, for its pilots.
struct FlightPlan {
  Formation formation;
};

/// The rows of one aircraft that its pilot reads.
struct Cockpit {
  const model::Kinematics& own;
  const model::Propulsion& propulsion;
  const model::Flying& flying;
  const model::Stores& stores;
  const model::GunState& gun;
  const model::TrackFile& tracks;
  const model::Threats& threats;
  const model::DatalinkState& datalink;
  const model::Command& command;  ///< the last one
  const Agent& agent;
};

/// Views into the pilot's own rows and what follows from them; good for one decision.
struct State : Cockpit {
  const model::Library& library;
  const model::AircraftType& type;
  const model::Flight& flight;
  const FlightPlan& plan;
  double time = 0;  ///< s

  std::array<Seen, model::kMaxTracks> seen{};
  std::uint32_t seen_count = 0;
  std::int32_t target_index = -1;  ///< into seen
  std::uint32_t rank = 1;          ///< among the members believed alive
  std::uint32_t lost = 0;          ///< members believed lost
  Vec3 velocity_ned{};             ///< m/s over the ground

  [[nodiscard]] std::span<const Seen> tracks_seen() const { return {seen.data(), seen_count}; }
  /// The chosen target, or null.
  [[nodiscard]] const Seen* target() const {
    return target_index < 0 ? nullptr : &seen[static_cast<std::size_t>(target_index)];
  }
  [[nodiscard]] bool leads() const { return rank == 1; }
  /// The member believed to lead; null if the datalink has not come up.
  [[nodiscard]] const model::Mate* lead() const { return model::lead(datalink); }
  [[nodiscard]] bool bingo() const { return propulsion.fuel <= agent.bingo; }
  /// Kilometres do not matter: whether a missile of the own may still be on its way to that track.
  [[nodiscard]] bool own_shot_flies(TrackId track) const {
    return agent.shot_track == track && time < agent.shot_until;
  }
  /// The employment zone of a missile type against a track, from here and now.
  [[nodiscard]] model::EmploymentZone zone(std::uint16_t store, const Seen& against) const;
  /// Angle between the nose and a direction in NED axes, rad.
  [[nodiscard]] double off_nose(const Vec3& ned) const;
};

/// Builds the state: carries every track on to `time` and chooses the target. A hostile track that
/// fewer better-ranked mates have as their target goes first, then the nearest; the target of
/// before stays unless another has fewer mates on it or is nearer by a third.
[[nodiscard]] State perceive(const Cockpit& cockpit, const model::Library& library,
                             const model::Fit& fit, const FlightPlan& plan, double time);

}  // namespace eyrie::pilot
