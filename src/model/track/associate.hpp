// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which contact belongs to which track.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "model/track.hpp"
#include "model/track/filter.hpp"

namespace eyrie::model::track {

/// m^2: no track is farther than that from a contact of its target. An eye judges a direction well
/// and a range badly, so what the contact does not know along its line comes on top.
[[nodiscard]] inline double reach2(const Tracker& tracker, const Contact& contact) {
  const double reach = tracker.max_gate + tracker.gate * contact.sigma_along;
  return reach * reach;
}

inline constexpr std::size_t kMaxContacts = 32;

/// Marks a contact that belongs to no track.
inline constexpr std::uint8_t kNoTrack = 255;

/// For each contact the index of its track, or kNoTrack. A pair must lie within the gates; of all
/// pairs the closest one (in standard deviations) is taken first, then the closest of the rest, so
/// each contact and each track is used at most once. Of equal pairs the older track and then the
/// earlier contact goes first. This greedy global nearest neighbor is the common choice where
/// targets are farther apart than the errors (Blackman & Popoli, Design and Analysis of Modern
/// Tracking Systems, sec. 6.4). At most kMaxContacts contacts and kMaxTracks predictions.
[[nodiscard]] std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker,
                                                               std::span<const Prediction> tracks,
                                                               std::span<const Contact> contacts);

}  // namespace eyrie::model::track
