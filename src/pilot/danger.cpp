// SPDX-License-Identifier: MIT
#include "pilot/danger.hpp"

#include "pilot/gunnery.hpp"

namespace eyrie::pilot {
namespace {

/// rad: a track that stands so near to a bearing of the warning receiver is the emitter.
constexpr double kSameBearing = si(20, "deg");

/// s: a seeker that has fallen silent for longer has turned to somebody else, or its beam has left.
constexpr double kSilence = 1;

/// s: whose seeker is not heard is seen to come here no earlier than this. Its bearing stands to 3
/// degrees a second (data/visual), which at 4 s may still be a miss by 800 m, at 8 s by 3 km.
constexpr double kSeenTime = 4;

/// s: that a seeker rests on a mate is believed for so long, as long as a missile is remembered:
/// the mate's hard turn often deafens him, and seekers seldom change their targets.
constexpr double kMates = 4;

const Seen* nearest_hostile(const State& s) {
  const Seen* nearest = nullptr;
  for (const Seen& seen : s.tracks_seen())
    if (seen.hostile() && (nearest == nullptr || seen.range < nearest->range))
      nearest = &seen;
  return nearest;
}

Danger from(const State& s, const Seen& seen) {
  return {.bearing = bearing_of(seen.ned), .altitude = altitude_of(s.own, seen.ned)};
}

/// A receiver's bearing is good to 10 degrees; the track of who is there is better.
Danger from(const State& s, const model::RwrWarning& warning) {
  const Seen* best = nullptr;
  double least = kSameBearing;
  for (const Seen& seen : s.tracks_seen()) {
    const double off = std::fabs(angle_between(bearing_of(seen.ned), warning.bearing));
    if (seen.suspect() && off <= least) {
      best = &seen;
      least = off;
    }
  }
  return best != nullptr ? from(s, *best) : Danger{.bearing = warning.bearing};
}

/// His range over r_ne of his reach; nothing if he is no hostile, or cannot hit at all.
std::optional<double> exposure_to(const State& s, const Seen& one) {
  const double r_ne = one.hostile() ? s.reach_of(one).r_ne : 0;
  return r_ne > 0 ? std::optional(one.range / r_ne) : std::nullopt;
}

}  // namespace

std::optional<double> time_to_go(const State& s, const model::InboundMissile& missile) {
  if (missile.arrival > 0)
    return std::max(missile.arrival - s.time, 0.0);
  if (missile.has_position)
    return std::max(
        missile.range / model::sensor::kMissileClosing - (s.time - missile.position_time), 0.0);
  return std::nullopt;
}

const model::InboundMissile* inbound(const State& s, double within) {
  const model::InboundMissile* first = nullptr;
  double least = within;
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& missile = s.threats.missiles[i];
    const auto left = time_to_go(s, missile);
    const bool believed =
        s.time - missile.time <= kSilence && left && (missile.arrival > 0 || *left <= kSeenTime);
    const bool mates = missile.at_mate > 0 && s.time - missile.at_mate <= kMates;
    if (believed && !mates && *left <= least && (first == nullptr || *left < least)) {
      first = &s.threats.missiles[i];
      least = *left;
    }
  }
  return first;
}

const model::RwrWarning* spike(const State& s) {
  for (std::uint32_t i = 0; i < s.rwr.count; ++i)
    if (s.rwr.warnings[i].kind == model::EmissionKind::track)
      return &s.rwr.warnings[i];
  return nullptr;
}

const model::RwrWarning* scanned(const State& s) {
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    if (warning.kind != model::EmissionKind::search)
      continue;
    for (const Seen& seen : s.tracks_seen())
      if (seen.hostile() &&
          std::fabs(angle_between(bearing_of(seen.ned), warning.bearing)) <= kSameBearing &&
          seen.range <= s.reach_of(seen).r_max)
        return &warning;
  }
  return nullptr;
}

std::optional<Exposure> exposure(const State& s) {
  std::optional<Exposure> worst;
  for (const Seen& seen : s.tracks_seen())
    if (const auto ratio = exposure_to(s, seen); ratio && (!worst || *ratio < worst->ratio))
      worst = Exposure{&seen, *ratio};
  return worst;
}

bool exposed(const State& s, double factor) {
  double farthest = 0;  // beyond it nobody's reach need be looked up
  for (std::size_t i = 0; i < s.library.missiles.size(); ++i)
    farthest = std::max(farthest, factor * s.library.missiles[i].zone.longest_no_escape());
  const auto seen = s.tracks_seen();
  return std::any_of(seen.begin(), seen.end(), [&](const Seen& one) {
    if (one.range > farthest)
      return false;
    const auto ratio = exposure_to(s, one);
    return ratio && *ratio <= factor;
  });
}

std::optional<double> support_left(const State& s, const Shot& shot) {
  const model::MissileType& type = s.library.missiles[shot.store];
  if (type.locks_before_launch() || shot.active != 0)
    return 0;
  const Seen* target = s.find(shot.track);
  if (target == nullptr)
    return std::nullopt;
  const double closing = target->range / std::max(time_of_flight(s, *target, type), 1e-3);
  return shot.until - s.time - type.seeker.activation_range / std::max(closing, 1.0);
}

bool support_needed(const State& s) {
  return std::any_of(s.agent.shots.begin(), s.agent.shots.end(), [&](const Shot& shot) {
    return shot.flies(s.time) && support_left(s, shot).value_or(0) > 0;
  });
}

std::optional<Danger> danger(const State& s, Against against, double within) {
  if (const model::InboundMissile* missile = inbound(s, within)) {
    Danger d{.bearing = missile->bearing, .call = Call::none};
    if (missile->has_position)
      d.altitude = s.own.altitude + missile->range * math::sin(missile->elevation);
    return d;
  }
  if (against == Against::missile)
    return std::nullopt;
  if (const model::RwrWarning* warning = spike(s))
    return from(s, *warning);
  if (against == Against::radar)
    return std::nullopt;
  if (const auto worst = exposure(s))
    return from(s, *worst->hostile);
  if (const Seen* nearest = nearest_hostile(s))
    return from(s, *nearest);
  return std::nullopt;
}

}  // namespace eyrie::pilot
