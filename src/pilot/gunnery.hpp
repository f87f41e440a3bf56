// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot reckons before he shoots: where the bore must point, when a missile arrives,
/// and who else is in the line.
#include "model/weapon/gun.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {

/// Whether the target is within reach of the gun and in its cone of aim, and there are rounds.
[[nodiscard]] bool in_gun(const State& state);

/// Where to fly (unit vector, north-east-down) so that the nose comes to rest on the sight of a
/// target that moves across: before it by as much as it moves, at the rate of the line of sight and
/// no faster than the nose can follow, while the autopilot closes an error (Autopilot::aim_time).
[[nodiscard]] Vec3 ahead_of_sight(const State& state, const Seen& target, const Sight& sight);

/// Why no gun is fired at the target, null if it may be: it has to be known as hostile and seen
/// within `max_age` (s), for where it was, another one may be now.
[[nodiscard]] const char* why_no_gun(const State& state, const Seen* target, double max_age);

/// A cone from the ownship along `direction` (NED), cut off at two distances.
struct LineOfFire {
  Vec3 direction;
  double from = 0;        ///< m
  double to = 0;          ///< m
  double half_angle = 0;  ///< rad
};
/// Somebody whom the pilot believes a friend: a mate by datalink, or a track identified as
/// friendly.
struct Friend {
  Vec3 ned;           ///< m, at the ownship
  Vec3 velocity;      ///< m/s, north-east-down at the ownship
  double unsure = 0;  ///< m, two standard deviations of a track
};
/// Whether `holds` of any friend.
template <class Holds>
bool any_friend(const State& s, const Holds& holds) {
  for (const Seen& seen : s.tracks_seen())
    if (seen.track->identity == model::Identity::friendly &&
        holds(Friend{seen.ned, s.velocity_of(seen), 2.0 * seen.track->position_sigma}))
      return true;
  return any_mate(s.datalink, [&](const model::Mate& mate) {
    return holds(Friend{to_ned(s.own, position_at(mate, s.time) - s.own.position),
                        to_ned(s.own, velocity_of(mate))});
  });
}

/// Whether a friendly track is where a mate says he is, who knows it better than an eye that
/// guesses his range.
[[nodiscard]] bool is_a_mate(const State& state, const Seen& seen);

/// Whether a friend is believed to be in it: a mate by datalink or a track identified as friendly.
[[nodiscard]] bool friend_in_line(const State& state, const LineOfFire& line);

/// Whether a friend is believed within `radius` (m) of a place (NED at the ownship).
[[nodiscard]] bool friend_near(const State& state, const Vec3& place, double radius);

/// s, until a missile that leaves now will have arrived, as a pilot reckons: the range over the
/// speed at which they close, where the missile adds half of its ideal speed gain to the speed of
/// the aircraft on average (drag takes the other half, [judgement]: docs/models/missile.md has the
/// flights), and no longer than its battery lasts.
[[nodiscard]] double time_of_flight(const State& state, const Seen& target,
                                    const model::MissileType& missile);

/// m, the F-pole: how far apart shooter and target will be when the missile arrives, if both keep
/// their course.
[[nodiscard]] double f_pole(const State& state, const Seen& target,
                            const model::MissileType& missile);

/// Where friends must not be while a missile looks for its target.
struct Clearance {
  double half_angle = 0;  ///< rad, of the cone ahead of the seeker, at least half its field of view
  double beyond = 0;      ///< m, behind the target that the cone reaches
  double turn = 0;        ///< g, with which friends may leave their course until then
};
/// Whether a friend may be in the seeker's basket: in the cone from the missile to the target, from
/// where the seeker is switched on until the missile arrives. Missile and target are carried on
/// along straight lines, friends along theirs, give or take what they can turn until then and two
/// standard deviations of a track.
[[nodiscard]] bool friend_in_basket(const State& state, const Seen& target,
                                    const model::MissileType& missile, const Clearance& clearance);

}  // namespace eyrie::pilot
