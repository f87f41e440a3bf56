// SPDX-License-Identifier: MIT
#include "pilot/sort.hpp"

namespace eyrie::pilot {
namespace {

bool same_place(const Seen& a, const Seen& b) {
  return norm2(a.ned - b.ned) <= kSamePlace * kSamePlace;
}

/// The hostile tracks that better-ranked mates, believed alive, have as their targets.
class Taken {
 public:
  explicit Taken(const State& s) : better_(s.alive & ((1U << s.datalink.self) - 1)) {
    for (const Seen& seen : s.tracks_seen())
      if ((seen.track->targeted_by & better_) != 0 && seen.hostile())
        tracks_[count_++] = &seen;
  }
  /// How many of them are after a track, or after what may be the same aircraft.
  [[nodiscard]] int by(const Seen& hostile) const {
    std::uint32_t members = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if (same_place(*tracks_[i], hostile))
        members |= tracks_[i]->track->targeted_by;
    return std::popcount(members & better_);
  }

 private:
  std::uint32_t better_;
  std::size_t count_ = 0;
  std::array<const Seen*, model::kMaxTracks> tracks_;
};

}  // namespace

Claims claims_on(const State& s, const Seen& hostile) {
  Claims claims;
  for (const Seen& seen : s.tracks_seen()) {
    if (!seen.hostile() || !same_place(seen, hostile))
      continue;
    claims.targeted |= seen.track->targeted_by;
    claims.shot |= seen.track->shot_by;
    for (const Shot& shot : s.agent.shots) {
      if (shot.track != seen.id())
        continue;
      claims.last_left = std::max(claims.last_left, shot.since);
      if (shot.flies(s.time))
        ++claims.own_shots;
      else
        claims.last_arrived = std::max(claims.last_arrived, shot.until);
    }
  }
  return claims;
}

std::int32_t choose_target(const State& s) {
  if (const Seen* held = s.find(s.agent.target); held && held->hostile()) {
    const double hold = std::clamp(held->range / kHoldSpeed, kLeastHold, kMostHold);
    if (s.time - s.agent.target_since < hold || s.agent.flying_at(held->id(), s.time) > 0)
      return static_cast<std::int32_t>(held - s.seen.data());
  }
  const Taken taken_tracks(s);
  std::int32_t best = -1;
  int best_taken = 0;
  double best_range = 0;
  for (std::uint32_t i = 0; i < s.seen_count; ++i) {
    const Seen& seen = s.seen[i];
    if (!seen.hostile())
      continue;
    const int taken = taken_tracks.by(seen);
    const double range = seen.id() == s.agent.target ? seen.range * kSwitchShare : seen.range;
    if (best < 0 || taken < best_taken || (taken == best_taken && range < best_range)) {
      best = static_cast<std::int32_t>(i);
      best_taken = taken;
      best_range = range;
    }
  }
  return best;
}

bool shoots_first(const State& s, const Seen& target) {
  const Vec3 place = position_at(*target.track, s.time);
  const std::uint32_t rivals = claims_on(s, target).targeted & s.alive;
  std::uint32_t busy = 0;
  for (const Seen& seen : s.tracks_seen())
    busy |= seen.track->shot_by;
  for (std::uint32_t i = 0; i < s.datalink.count; ++i) {
    const model::Mate& mate = s.datalink.members[i];
    const std::uint32_t bit = 1U << i;
    if (i == s.datalink.self || !(rivals & ~busy & bit) || !mate.reported)
      continue;
    const double range = norm(place - position_at(mate, s.time));
    if (range < target.range || (range == target.range && i < s.datalink.self))
      return false;
  }
  return true;
}

}  // namespace eyrie::pilot
