// SPDX-License-Identifier: MIT
#pragma once
/// \file  A filtered estimate of one other player, built from contacts, and each player's list.
#include <array>
#include <cstdint>

#include "core/id.hpp"
#include "core/vec.hpp"

namespace eyrie::model {

enum class Identity : std::uint8_t { unknown, friendly, hostile };

/// Which sensors have contributed to a track, as bits.
enum TrackSource : std::uint8_t {
  kFromRadar = 1,
  kFromVisual = 2,
  kFromDatalink = 4,
  kFromTruth = 8,  ///< privileged state
};

/// What one player believes about one other. Position and velocity are in the local frame.
struct Track {
  Vec3 position;              ///< m, at `time`
  Vec3 velocity;              ///< m/s
  double time = 0;            ///< s, of the last update
  double first_time = 0;      ///< s, of the first contact
  float position_sigma = 0;   ///< m, 1-sigma
  float velocity_sigma = 0;   ///< m/s, 1-sigma
  TrackId id;                 ///< names the track in its owner's list; never reused there
  PlayerId truth;             ///< who the last contact came from: for scoring and debrief only
  Identity identity = Identity::unknown;
  std::uint8_t sources = 0;   ///< sources ever seen, bits of TrackSource
  std::uint8_t fresh = 0;     ///< sources that updated it at `time`
  std::uint8_t hits = 0;      ///< contacts so far, saturating
  std::uint8_t confirmed = 0; ///< 1 once enough contacts were associated
  std::uint8_t reserved[3] = {};
};

inline constexpr std::size_t kMaxTracks = 16;

/// The track file of one player, ordered by track id (age).
struct TrackFile {
  std::array<Track, kMaxTracks> tracks;
  std::uint32_t count = 0;
  std::uint32_t next_id = 1;
};

}  // namespace eyrie::model
