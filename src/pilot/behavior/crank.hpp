// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Keeps the chosen target near the edge of the radar's gimbal while an own missile flies to it:
/// the radar still supports the missile, and the enemy comes nearer as slowly as that allows (the
/// F-pole: Shaw, Fighter Combat, ch. 1). Turns to the side on which the nose already is, never
/// farther than `margin` inside the gimbal, and goes down by `descend`, so that the enemy has to
/// look and shoot down into thicker air. Fails without a missile that needs it: `support: true`
/// ends it when the missile's own seeker is switched on, as the pilot reckons.
class Crank final : public Behavior {
 public:
  static constexpr std::string_view type_name = "crank";
  static constexpr std::string_view help =
      "keeps the target near the radar's gimbal while an own missile flies";
  static constexpr auto params() {
    using C = Crank;
    return std::tuple{
        param("vote", &C::vote_, range(0, 1000), "how strongly"),
        param("angle", &C::angle_, "rad", range(0, 1.5), "of the target off the nose"),
        param("margin", &C::margin_, "rad", range(0, 1), "to keep from the edge of the gimbal"),
        param("support", &C::support_, "true: no longer than the missile needs the radar"),
        param("speed", &C::speed_, "m/s", range(50, 1000), "true airspeed"),
        param("least_mach", &C::least_mach_, range(0, 2), "turns easier when it gets slower"),
        param("descend", &C::descend_, "m", range(0, 10e3), "below the present altitude"),
        param("floor", &C::floor_, "m", range(0, 25e3), "descends no lower"),
        param("load_factor", &C::load_factor_, range(1, 12), "g, the most it turns with")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 50;
  double angle_ = si(50, "deg");
  double margin_ = si(5, "deg");
  bool support_ = true;
  double speed_ = si(560, "kt");
  double least_mach_ = 0.75;
  double descend_ = 0;
  double floor_ = si(5000, "ft");
  double load_factor_ = 4;
};

}  // namespace eyrie::pilot
