// SPDX-License-Identifier: MIT
#include "pilot/sort.hpp"

#include <bit>

namespace eyrie::pilot {

Claims claims_on(const State& s, const Seen& hostile) {
  Claims claims;
  for (const Seen& seen : s.tracks_seen()) {
    if (!seen.hostile() || norm2(seen.ned - hostile.ned) > kSamePlace * kSamePlace)
      continue;
    claims.targeted |= seen.track->targeted_by;
    claims.shot |= seen.track->shot_by;
    claims.own_shots += s.agent.flying_at(seen.id(), s.time);
  }
  return claims;
}

std::int32_t choose_target(const State& s) {
  const std::uint32_t better = s.alive & ((1U << s.datalink.self) - 1);
  std::int32_t best = -1;
  int best_taken = 0;
  double best_range = 0;
  for (std::uint32_t i = 0; i < s.seen_count; ++i) {
    const Seen& seen = s.seen[i];
    if (!seen.hostile())
      continue;
    const int taken = better ? std::popcount(better & claims_on(s, seen).targeted) : 0;
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
  const Vec3 place = model::position_at(*target.track, s.time);
  const std::uint32_t rivals = claims_on(s, target).targeted & s.alive;
  std::uint32_t busy = 0;
  for (const Seen& seen : s.tracks_seen())
    busy |= seen.track->shot_by;
  for (std::uint32_t i = 0; i < s.datalink.count; ++i) {
    const model::Mate& mate = s.datalink.members[i];
    const std::uint32_t bit = 1U << i;
    if (i == s.datalink.self || !(rivals & ~busy & bit) || !mate.reported)
      continue;
    const double range = norm(place - model::position_at(mate, s.time));
    if (range < target.range || (range == target.range && i < s.datalink.self))
      return false;
  }
  return true;
}

}  // namespace eyrie::pilot
