// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/track/filter.hpp"

namespace eyrie::model::track {
namespace {

/// The likeliest first, of equal ones the older track and then the earlier contact.
struct Pair {
  double misfit;
  std::uint8_t track, contact;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace

std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker, const Predictions& tracks,
                                                 std::span<const Contact> contacts,
                                                 std::uint32_t hostile) {
  EYRIE_ASSERT(contacts.size() <= kMaxContacts);

  // every pair within the gates
  std::array<Pair, kMaxTracks * kMaxContacts> pairs;
  std::size_t count = 0;
  const double gate2 = tracker.gate * tracker.gate;
  for (std::size_t t = 0; t < kMaxTracks; ++t) {
    const Prediction* track = tracks[t];
    for (std::size_t c = 0; track != nullptr && c < contacts.size(); ++c) {
      if (contacts[c].mate && (hostile >> t & 1) != 0)
        continue;
      if (norm2(contacts[c].position - track->position) > reach2(tracker, contacts[c]))
        continue;
      const Match m = match(*track, contacts[c]);
      if (m.deviations2() <= gate2)
        pairs[count++] = {misfit(*track, m), static_cast<std::uint8_t>(t),
                          static_cast<std::uint8_t>(c)};
    }
  }

  // the likeliest first
  std::sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count));
  std::array<std::uint8_t, kMaxContacts> track_of;
  track_of.fill(kNoTrack);
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair& pair = pairs[i];
    if (track_of[pair.contact] != kNoTrack || (used >> pair.track & 1) != 0)
      continue;
    track_of[pair.contact] = pair.track;
    used |= 1u << pair.track;
  }
  return track_of;
}

}  // namespace eyrie::model::track
