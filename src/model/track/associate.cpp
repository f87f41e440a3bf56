// SPDX-License-Identifier: MIT
#include "model/track/associate.hpp"

#include <algorithm>

#include "core/assert.hpp"

namespace eyrie::model::track {
namespace {

struct Pair {
  double deviations2;
  std::uint8_t track, contact;
};

bool closer(const Pair& a, const Pair& b) {
  if (a.deviations2 != b.deviations2)
    return a.deviations2 < b.deviations2;
  return a.track != b.track ? a.track < b.track : a.contact < b.contact;
}

}  // namespace

std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker,
                                                 std::span<const Prediction> tracks,
                                                 std::span<const Contact> contacts) {
  EYRIE_ASSERT(tracks.size() <= kMaxTracks && contacts.size() <= kMaxContacts);

  // every pair within the gates
  std::array<Pair, kMaxTracks * kMaxContacts> pairs;
  std::size_t count = 0;
  const double gate2 = tracker.gate * tracker.gate;
  for (std::size_t t = 0; t < tracks.size(); ++t)
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (norm2(contacts[c].position - tracks[t].position) > reach2(tracker, contacts[c]))
        continue;
      const double deviations2 = deviations_of(tracks[t], contacts[c]);
      if (deviations2 <= gate2)
        pairs[count++] = {deviations2, static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(c)};
    }

  // the closest first
  std::sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count), closer);
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
