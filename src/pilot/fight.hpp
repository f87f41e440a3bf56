// SPDX-License-Identifier: MIT
#pragma once
/// \file  What every maneuver of a fight is made of: angles, energy and where to point the lift.
/// Terms as in Shaw, Fighter Combat: Tactics and Maneuvering (1985), ch. 2; not seen: equations
/// are derived from the geometry.
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// m/s true airspeed at a Mach number, here.
[[nodiscard]] double speed_of(const State& s, double mach);

/// g to turn with, up to `most`: all that the wing gives at corner speed and above; at the slowest
/// speed worth fighting at only what full power sustains; between them in proportion to the speed;
/// and less below, so that the speed comes back. `slowest` 0: `most`, whatever it costs.
[[nodiscard]] double load_for_energy(const State& s, double slowest, double most);

/// How far above (positive) or below the level a turn is best flown (rad): the excess of speed over
/// corner speed is put into height, and a lack of it is taken from height, down to `floor` (m).
[[nodiscard]] double slope_for_energy(const State& s, double floor);

/// The direction turned by an angle (rad) upwards, as seen along it; unit length. Straight up and
/// straight down stay.
[[nodiscard]] Vec3 raised(const Vec3& ned, double angle);

/// rad below the level, in [0, pi/2]: the steepest dive that a pull-out with so many g, or with
/// what the wing gives of them, still ends above `floor` (m).
[[nodiscard]] double steepest_above(const State& s, double floor, double load_factor);

/// rad/s, at which the nose turns with all that the wing gives now.
[[nodiscard]] double fastest_turn(const State& s);

/// m/s true airspeed: `speed`, but at most `overtake` faster than the target, if that is given, and
/// no slower than half of it.
[[nodiscard]] double held_back(const State& s, const Seen& target, std::optional<double> overtake,
                               double speed);

/// How a direction is flown to.
struct Pull {
  double load_factor;  ///< g, to turn with
  double most;         ///< g, to pull out with above the floor
  double speed;        ///< m/s true airspeed
  double floor;        ///< m
};

/// Flies towards a direction (NED, any length), upside down if need be, but no steeper down than
/// can be pulled out of above the floor; from below it climbs back.
void aim(const State& s, const Vec3& direction, const Pull& pull, Action& action);

/// What all behaviors that turn share: how strongly, how fast, how hard and how low.
class Maneuver : public Behavior {
 public:
  static constexpr auto params() {
    using M = Maneuver;
    return Lines{
        param("vote", &M::vote_, range(0, 1000), "how strongly"),
        param("speed", &M::speed_, "m/s", range(50, 1000), "true airspeed to go for"),
        param("least_mach", &M::least_mach_, range(0, 2),
              "slowest Mach number worth fighting at: turns no harder there than full power "
              "sustains, and less below; 0: turns as hard as it can"),
        param("load_factor", &M::load_factor_, range(1, 12), "g, the most it turns with"),
        param("floor", &M::floor_, "m", range(0, 25e3), "goes no lower")};
  }

 protected:
  /// g of a turn with the energy it has, up to `most`.
  [[nodiscard]] double load(const State& s, double most) const {
    return load_for_energy(s, speed_of(s, least_mach_), most);
  }
  /// Recommends to fly there with that load, after whom it is after.
  Status fly(const State& s, const Seen* target, const Vec3& direction, double load_factor,
             Proposal& out) const;
  /// With the energy it has.
  Status fly(const State& s, const Seen* target, const Vec3& direction, Proposal& out) const {
    return fly(s, target, direction, load(s, load_factor_), out);
  }

  float vote_ = 40;
  double speed_ = si(600, "kt");
  double least_mach_ = 0.6;
  double load_factor_ = 9;
  double floor_ = si(3000, "ft");
};

}  // namespace eyrie::pilot
