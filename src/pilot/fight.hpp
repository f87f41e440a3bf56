// SPDX-License-Identifier: MIT
#pragma once
/// \file  What every maneuver of a fight is made of: angles, energy and where to point the lift.
/// Terms as in Shaw, Fighter Combat: Tactics and Maneuvering (1985), ch. 2; not seen: equations
/// are derived from the geometry.
#include "pilot/state.hpp"

namespace eyrie::pilot {

/// One target as a fight sees it. Angles in rad in [0, pi].
struct Angles {
  double off_nose = 0;  ///< own flight path to the line of sight: 0 he is ahead
  double off_tail = 0;  ///< his tail to the line to here: 0 right behind him, pi in front of him
  double crossing = 0;  ///< between the two flight paths
};
[[nodiscard]] Angles angles_of(const State& s, const Seen& target);

/// m/s true airspeed at a Mach number, here.
[[nodiscard]] double speed_of(const State& s, double mach);

/// g to turn with, up to `most`: all that the wing gives at corner speed and above; at the slowest
/// speed worth fighting at only what full power sustains; between them in proportion to the speed;
/// and less below, so that the speed comes back.
[[nodiscard]] double load_for_energy(const State& s, double slowest, double most);

/// How far above (positive) or below the level a turn is best flown (rad): the excess of speed over
/// corner speed is put into height, and a lack of it is taken from height, down to `floor` (m).
[[nodiscard]] double slope_for_energy(const State& s, double floor);

/// The direction turned by an angle (rad) upwards, as seen along it; unit length. Straight up and
/// straight down stay.
[[nodiscard]] Vec3 raised(const Vec3& ned, double angle);

/// Flies towards a direction (NED, any length) with at most `load_factor` g, upside down if need
/// be, but no steeper down than what leaves room above `floor` (m).
void aim(const State& s, const Vec3& direction, double load_factor, double speed, double floor,
         Action& action);

}  // namespace eyrie::pilot
