// SPDX-License-Identifier: MIT
#include "pilot/state.hpp"

#include <bit>

#include "core/math.hpp"

namespace eyrie::pilot {
namespace {

/// Mates of a better rank, believed alive, who said that the track is their target.
int taken(const State& s, const model::Track& track) {
  std::uint32_t better = 0;
  for (std::uint32_t i = 0; i < s.datalink.self; ++i)
    better |= static_cast<std::uint32_t>(s.datalink.members[i].alive) << i;
  return std::popcount(better & track.targeted_by);
}

std::int32_t choose_target(const State& s) {
  std::int32_t best = -1;
  int best_taken = 0;
  double best_range = 0;
  for (std::uint32_t i = 0; i < s.seen_count; ++i) {
    const Seen& seen = s.seen[i];
    if (!seen.hostile())
      continue;
    const int mates = taken(s, *seen.track);
    const double range = seen.id() == s.agent.target ? seen.range * 0.67 : seen.range;
    if (best < 0 || mates < best_taken || (mates == best_taken && range < best_range)) {
      best = static_cast<std::int32_t>(i);
      best_taken = mates;
      best_range = range;
    }
  }
  return best;
}

}  // namespace

State perceive(const Cockpit& cockpit, const model::Library& library, const model::Fit& fit,
               const FlightPlan& plan, double time) {
  State s{cockpit, library, library.aircraft[fit.type], library.flights[fit.flight], plan, time};
  s.velocity_ned = to_ned(s.own, s.own.velocity);
  for (std::uint32_t i = 0; i < s.tracks.count; ++i) {
    const model::Track& track = s.tracks.tracks[i];
    Seen& seen = s.seen[s.seen_count++];
    seen.track = &track;
    const Vec3 offset = model::position_at(track, time) - s.own.position;
    seen.ned = to_ned(s.own, offset);
    seen.velocity = to_ned(s.own, track.velocity);
    seen.range = norm(offset);
    if (seen.range > 0)
      seen.closing = dot(offset, s.own.velocity - track.velocity) / seen.range;
  }
  if (s.datalink.count) {
    s.rank = model::living_rank(s.datalink);
    for (std::uint32_t i = 0; i < s.datalink.count; ++i)
      s.lost += s.datalink.members[i].alive ? 0 : 1;
  }
  s.target_index = choose_target(s);
  return s;
}

model::EmploymentZone State::zone(std::uint16_t store, const Seen& against) const {
  const model::Track& track = *against.track;
  return library.missiles[store].zone.at(model::launch_situation(
      {own.position, own.velocity, own.altitude},
      {model::position_at(track, time), track.velocity, altitude_of(own, against.ned)}));
}

double State::off_nose(const Vec3& ned) const {
  const double size = norm(ned);
  return size > 0 ? math::acos(std::clamp(dot(nose_of(own), ned) / size, -1.0, 1.0)) : 0;
}

}  // namespace eyrie::pilot
