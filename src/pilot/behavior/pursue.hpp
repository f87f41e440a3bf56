// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/fight.hpp"

namespace eyrie::pilot {

enum class Pursuit : std::uint8_t {
  follow,     ///< the autopilot follows the enemy as if he were the lead: the paper's way
  intercept,  ///< collision course: Shneydor, Missile Guidance and Pursuit (1998), ch. 4
  lead,       ///< the same from afar; near, the nose where a gun's rounds would meet the target
};
constexpr auto names_of(Pursuit) {
  return names_from_zero<Pursuit>("follow", "intercept", "lead");
}

/// Goes after the chosen target (pilot/sort.hpp). Fails without one.
///
/// With `crank`, while an own missile is on its way to the target, it keeps the target that far off
/// the nose instead, as the paper's pilots do: closure is less and the radar still supports the
/// missile. (The behavior `crank` heeds the gimbal and the seeker, too.) Mates of a better rank
/// have the right of way: nearer than `separation` to one, it goes above or below.
///
/// Nearer than `level_range`, and with a missile on board, the collision course leads by
/// `near_lead` at most: of a target that beams it would keep the nose so far off that no missile
/// may leave.
///
/// It keeps its energy (pilot/fight.hpp): near `least_mach` it turns no harder than full power
/// sustains, and below it neither climbs nor pulls until it is faster. Beyond `level_range` a new
/// heading is flown only when it differs by more than `dead_band` and what the error of the
/// track's velocity makes of it, from the one that is flown to and from the own: there a turn ends.
/// And with `far_load_factor` at most: errors are no reason to turn.
class Pursue final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "pursue";
  static constexpr std::string_view help = "goes after the chosen target";
  static constexpr auto params() {
    using P = Pursue;
    return joined(
        Maneuver::params(),
        Lines{
            param("mode", &P::mode_,
                  "follow (with the speed that keeps the place), intercept or lead"),
            param("overtake", &P::overtake_, "m/s", range(0, 500),
                  "nearer than level_range, at most so much faster than the target; null: never "
                  "slows"),
            param("altitude", &P::altitude_, "m", range(0, 25e3),
                  "kept while the target is farther than level_range; null: the target's altitude"),
            param("level_range", &P::level_range_, "m", range(0, 500e3),
                  "nearer than this it goes to the target's altitude"),
            param("near_lead", &P::near_lead_, "rad", range(0, 90, "deg"),
                  "modes intercept and lead: a target nearer than level_range is led by so much at "
                  "most while a missile is on board"),
            param("behind", &P::behind_, "m", range(0, 50e3),
                  "mode follow: place behind the target"),
            param("gun_range", &P::gun_range_, "m", range(0, 10e3),
                  "mode lead: nearer than this it aims the gun"),
            param("dead_band", &P::dead_band_, "rad", range(0, 30, "deg"),
                  "beyond level_range: smaller changes of heading are not flown"),
            param("far_load_factor", &P::far_load_factor_, range(1, 12),
                  "g, the most it turns with beyond level_range"),
            param("crank", &P::crank_, "rad", range(0, 85, "deg"),
                  "angle off the nose at which the target is kept while an own missile flies; 0: "
                  "none"),
            param("separation", &P::separation_, "m", range(0, 5e3),
                  "distance to keep from mates of a better rank")});
  }

  Pursue() {
    speed_ = si(560, "kt");  // not in mode follow
    load_factor_ = 6;
    floor_ = si(2000, "ft");
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  void follow(const State& s, const Seen& target, double altitude, Action& action) const;
  /// Of the collision course, or as much of its lead as leaves a missile's target before the nose.
  [[nodiscard]] double heading_of_choice(const State& s, const Seen& target) const;
  [[nodiscard]] double altitude_of_choice(const State& s, const Seen& target) const;
  [[nodiscard]] double speed_of_choice(const State& s, const Seen& target) const;
  [[nodiscard]] double clearance(const State& s) const;
  /// What is flown of a wanted heading.
  [[nodiscard]] double steadied(const State& s, const Seen& target, double heading) const;

  Pursuit mode_ = Pursuit::intercept;
  std::optional<double> overtake_, altitude_;
  double level_range_ = si(15, "nmi");
  double near_lead_ = si(30, "deg");
  double behind_ = si(1, "nmi");
  double gun_range_ = 2500;
  double dead_band_ = si(10, "deg");
  double far_load_factor_ = 2;
  double crank_ = 0;
  double separation_ = si(500, "ft");
};

}  // namespace eyrie::pilot
