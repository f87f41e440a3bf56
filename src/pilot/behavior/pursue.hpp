// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

enum class Pursuit : std::uint8_t {
  follow,     ///< the autopilot follows the enemy as if he were the lead: the paper's way
  intercept,  ///< collision course
  lead,       ///< nose ahead of the target by the flight time of a bullet, all the turn there is
};

}  // namespace eyrie::pilot

template <>
struct eyrie::EnumNames<eyrie::pilot::Pursuit> {
  using E = eyrie::pilot::Pursuit;
  static constexpr std::array names{std::pair<std::string_view, E>{"follow", E::follow},
                                    std::pair<std::string_view, E>{"intercept", E::intercept},
                                    std::pair<std::string_view, E>{"lead", E::lead}};
};

namespace eyrie::pilot {

/// Goes after the chosen target. Fails without one. With `crank`, while the own missile is on its
/// way to the target, it keeps the target that far off the nose instead: that lowers the closure
/// and still lets the radar support the missile.
class Pursue final : public Behavior {
 public:
  static constexpr std::string_view type_name = "pursue";
  static constexpr std::string_view help = "goes after the chosen target";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &Pursue::vote_, range(0, 1000), "how strongly"),
        param("mode", &Pursue::mode_, "follow, intercept or lead"),
        param("speed", &Pursue::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("altitude", &Pursue::altitude_, "m", range(0, 25e3),
              "altitude to keep while the target is farther than level_range; not given: the "
              "target's"),
        param("level_range", &Pursue::level_range_, "m", range(0, 500e3),
              "nearer than this it goes to the target's altitude"),
        param("behind", &Pursue::behind_, "m", range(0, 50e3),
              "mode follow: place behind the target"),
        param("load_factor", &Pursue::load_factor_, range(1, 12), "g, the most it turns with"),
        param(
            "crank", &Pursue::crank_, "rad", range(0, 1.5),
            "angle off the nose at which the target is kept while the own missile flies; 0: none"),
        param("floor", &Pursue::floor_, "m", range(0, 25e3), "follows no lower")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 40;
  Pursuit mode_ = Pursuit::intercept;
  double speed_ = si(560, "kt");
  std::optional<double> altitude_;
  double level_range_ = si(15, "nmi");
  double behind_ = si(1, "nmi");
  double load_factor_ = 6;
  double crank_ = 0;
  double floor_ = si(2000, "ft");
};

}  // namespace eyrie::pilot
