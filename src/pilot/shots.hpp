// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot reckons of a shot before it leaves, and of one that is on its way.
#include "pilot/state.hpp"

namespace eyrie::pilot {

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
