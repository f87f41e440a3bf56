// SPDX-License-Identifier: MIT
#include "pilot/sort.hpp"

namespace eyrie::pilot {
namespace {

constexpr double kFaint = 8;  ///< s, two looks of a radar

bool same_place(const Seen& a, const Seen& b) {
  return norm2(a.ned - b.ned) <= kSamePlace * kSamePlace;
}

/// Who of the better-ranked mates, believed alive, is after which hostile track.
class Taken {
 public:
  explicit Taken(const State& s) : s_(s), better_(s.alive & ((1U << s.datalink.self) - 1)) {
    for (std::uint32_t k = 0; k < s.seen_count; ++k)
      if (s.seen[k].hostile() && (s.seen[k].track->targeted_by & better_) != 0)
        take(k, s.seen[k].track->targeted_by & better_);
  }
  /// Whoever has not said yet whom he takes will take one by the rule that holds for all.
  void reckon() {
    std::uint32_t said = 0;
    for (std::size_t i = 0; i < count_; ++i)
      said |= members_[i];
    for (std::uint32_t i = 0; i < s_.datalink.self; ++i) {
      const model::Mate& mate = s_.datalink.members[i];
      if ((better_ & ~said & 1U << i) == 0 || !mate.reported)
        continue;
      const Vec3 apart = to_ned(s_.own, position_at(mate, s_.time) - s_.own.position);
      if (const auto k = choose(i, [&](const Seen& seen) { return norm(seen.ned - apart); });
          k >= 0)
        take(static_cast<std::uint32_t>(k), 1U << i);
    }
  }
  /// The hostile that fewest of those who rank before `member` are after, the nearest of these. One
  /// who was not seen for long counts as if one more were after him: he may be gone.
  template <typename Range>
  [[nodiscard]] std::int32_t choose(std::uint32_t member, const Range& range_of) const {
    std::int32_t best = -1;
    std::pair<int, double> least;
    for (std::uint32_t k = 0; k < s_.seen_count; ++k) {
      if (!s_.seen[k].hostile())
        continue;
      const bool faint = s_.time - s_.seen[k].track->time > kFaint;
      const std::pair rank(by((1U << member) - 1, s_.seen[k]) + (faint ? 1 : 0),
                           range_of(s_.seen[k]));
      if (best < 0 || rank < least) {
        best = static_cast<std::int32_t>(k);
        least = rank;
      }
    }
    return best;
  }

  /// How many of these are after a track, or after what may be the same aircraft.
  [[nodiscard]] int by(std::uint32_t members, const Seen& hostile) const {
    std::uint32_t after = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if (same_place(s_.seen[tracks_[i]], hostile))
        after |= members_[i];
    return std::popcount(after & members);
  }

 private:
  void take(std::uint32_t track, std::uint32_t members) {
    tracks_[count_] = track;
    members_[count_++] = members;
  }

  const State& s_;
  std::uint32_t better_;
  std::size_t count_ = 0;
  std::array<std::uint32_t, model::kMaxTracks + model::kMaxFlight> tracks_, members_;
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

Choice choose_target(const State& s) {
  const Seen* held = s.find(s.agent.target);
  if (held && !held->hostile())
    held = nullptr;
  const auto kept = [&] { return static_cast<std::int32_t>(held - s.seen.data()); };
  if (held) {
    const double hold = std::clamp(held->range / kHoldSpeed, kLeastHold, kMostHold);
    const bool shot_at = std::any_of(
        s.agent.shots.begin(), s.agent.shots.end(),
        [&](const Shot& shot) { return held->track->named(shot.track) && shot.flies(s.time); });
    if (s.time - s.agent.target_since < hold || shot_at)
      return {.index = kept()};
  }
  Taken taken(s);
  if (!held)
    taken.reckon();
  const std::uint32_t self = s.datalink.self;
  const bool contested = held && taken.by((1U << self) - 1, *held) > 0;
  if (contested && (s.agent.contested_since == 0 || s.time - s.agent.contested_since < kBelieved))
    return {.index = kept(), .contested = true};
  const std::int32_t best = taken.choose(self, [&](const Seen& seen) {
    return &seen == held ? seen.range * kSwitchShare : seen.range;
  });
  return {.index = best, .contested = contested};
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
