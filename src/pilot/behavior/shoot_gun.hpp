// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Pulls the trigger while the nose is on the place where the bullets will meet the target. Fails
/// when it is not, without rounds, and at anyone not identified as hostile.
class ShootGun final : public Behavior {
 public:
  static constexpr std::string_view type_name = "shoot_gun";
  static constexpr std::string_view help = "fires the gun when the sight is on the target";
  static constexpr auto params() {
    return std::tuple{param("vote", &ShootGun::vote_, range(0, 1000), "how strongly"),
                      param("range", &ShootGun::range_, "m", range(50, 3000), "fires no farther"),
                      param("tolerance", &ShootGun::tolerance_, "rad", range(0.001, 0.5),
                            "largest angle between the nose and the lead point")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 55;
  double range_ = 900;
  double tolerance_ = si(3, "deg");
};

}  // namespace eyrie::pilot
