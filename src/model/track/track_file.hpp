// SPDX-License-Identifier: MIT
#pragma once
/// \file  The life of tracks: born from contacts, confirmed, merged, coasting, dropped.
#include "model/track.hpp"
#include "model/track/filter.hpp"

namespace eyrie::model::track {

/// Something about a track that others may want to hear.
struct TrackNews {
  enum class What : std::uint8_t { confirmed, lost, identified };
  What what = What::confirmed;
  std::uint8_t bits = 0;  ///< sources (confirmed, lost) or identity (identified)
  TrackId id{};
  PlayerId truth{};
  double value = 0;  ///< range in m (confirmed, identified) or age in s (lost)
};

/// What happened to a track file in one step. Has room for all that one call can tell.
class TrackNewsList {
 public:
  TrackNewsList() {}
  void add(const TrackNews& news) {
    EYRIE_ASSERT(count_ < items_.size());
    if (count_ < items_.size())
      items_[count_++] = news;
  }
  [[nodiscard]] std::span<const TrackNews> items() const { return {items_.data(), count_}; }
  void clear() { count_ = 0; }

 private:
  union {  // not of zeros: most are never used
    std::array<TrackNews, 256> items_;
  };
  std::size_t count_ = 0;
};

/// What every change of a track file needs to know.
struct TrackContext {
  const Tracker& tracker;
  Ownship ownship;
  double time = 0;              ///< s
  std::uint32_t iff_tries = 0;  ///< as Iff::tries
  TrackNewsList& news;
};

/// The contacts of one look of one sensor (at most kMaxContacts): those that fit a track update it,
/// the others start tentative tracks. A full file makes room only for what is worth more: the
/// farthest tentative track gives way to a nearer contact, then a confirmed one that has gone
/// without an update for half its coasting time, the stalest first; otherwise the contact is
/// dropped. No truth is read.
void update(TrackFile& file, const TrackContext& context, std::span<const Contact> contacts);

/// Drops what is too old, merges duplicates, lets the sigmas grow.
void upkeep(TrackFile& file, const TrackContext& context);

/// Adds a track, gives it its id and returns its index; kMaxTracks if there was no room for it.
std::size_t add_track(TrackFile& file, const TrackContext& context, const Track& track);

/// Tell that a track is believed from now on, or that it is none any more.
void tell_confirmed(const Track& track, const TrackContext& context);
void tell_lost(const Track& track, const TrackContext& context);

/// Sets who a track is and tells it, if that is new.
void identify(Track& track, Identity identity, const TrackContext& context);

/// The declared rule. A reply makes a friend, even of a track that was held for hostile: a track
/// may have passed from one aircraft to another. `tries` interrogations in a row without a reply
/// make a hostile of an unknown, and an unknown again of a friend, for the same reason. A hostile
/// stays one.
constexpr void conclude(Track& track, std::uint32_t tries, bool reply) {
  if (reply) {
    track.identity = Identity::friendly;
    track.unanswered = 0;
    return;
  }
  if (track.unanswered < 255)
    ++track.unanswered;
  if (tries == 0 || track.unanswered < tries || track.identity == Identity::hostile)
    return;
  const bool was_friendly = track.identity == Identity::friendly;
  track.identity = was_friendly ? Identity::unknown : Identity::hostile;
  if (was_friendly)
    track.unanswered = 0;
}

}  // namespace eyrie::model::track
