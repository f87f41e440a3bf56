// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/fight.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

struct CrankMemory {
  double began = 0;         ///< m, its altitude when it began
  std::uint64_t going = 0;  ///< 1 since then
};

/// Keeps the chosen target near the edge of the radar's gimbal while an own missile flies to it:
/// the radar still supports the missile, and the enemy comes nearer as slowly as that allows (the
/// F-pole: Shaw, Fighter Combat, ch. 1). Turns to the side on which the nose already is, never
/// farther than `margin` inside the gimbal, and goes down by `descend`, so that the enemy has to
/// look and shoot down into thicker air. Fails without a missile that needs it: `support: true`
/// ends it when the missile's own seeker is switched on, as the pilot reckons.
class Crank final : public ubf::WithMemory<Maneuver, CrankMemory> {
 public:
  static constexpr std::string_view type_name = "crank";
  static constexpr std::string_view help =
      "keeps the target near the radar's gimbal while an own missile flies";
  static constexpr auto params() {
    using C = Crank;
    return joined(
        Maneuver::params(),
        Lines{param("angle", &C::angle_, "rad", range(0, 85, "deg"), "of the target off the nose"),
              param("margin", &C::margin_, "rad", range(0, 60, "deg"),
                    "to keep from the edge of the gimbal"),
              param("support", &C::support_, "true: no longer than the missile needs the radar"),
              param("descend", &C::descend_, "m", range(0, 10e3),
                    "below the altitude at which it began")});
  }

  Crank() {
    vote_ = 50;
    speed_ = si(560, "kt");
    least_mach_ = 0.75;
    load_factor_ = 4;
    floor_ = si(5000, "ft");
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double angle_ = si(50, "deg");
  double margin_ = si(5, "deg");
  bool support_ = true;
  double descend_ = 0;
};

}  // namespace eyrie::pilot
