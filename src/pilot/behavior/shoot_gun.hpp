// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

struct BurstMemory {
  double since = 0;         ///< s, when this burst, or the pause after it, began
  std::uint32_t phase = 0;  ///< 0 ready, 1 firing, 2 pausing
  std::uint32_t reserved = 0;
};

/// Pulls the trigger while the nose is on the place where the rounds will meet the target, and
/// keeps it there. Fires in bursts; between two of them it goes on aiming. Fails when the target is
/// too far, out of sight or not in the gun's, without gun or rounds, while a friend is in the line
/// of fire, and at anyone not identified as hostile.
class ShootGun final : public ubf::WithMemory<Behavior, BurstMemory> {
 public:
  static constexpr std::string_view type_name = "shoot_gun";
  static constexpr std::string_view help = "fires the gun when the sight is on the target";
  static constexpr auto params() {
    using G = ShootGun;
    return Lines{
        param("vote", &G::vote_, range(0, 1000), "how strongly"),
        param("range", &G::range_, "m", range(50, 5000),
              "fires no farther, and never beyond the reach of the gun"),
        param("tolerance", &G::tolerance_, "rad", range(0.05, 30, "deg"),
              "largest angle between the nose and the lead point; null: the gun's aim cone"),
        param("burst", &G::burst_, "s", range(0.05, 60), "longest burst, in whole decisions"),
        param("pause", &G::pause_, "s", range(0, 60), "between two bursts"),
        param("max_age", &G::max_age_, "s", range(0, 60),
              "not at a target that nobody has seen for longer"),
        param("clear_cone", &G::clear_cone_, "rad", range(0, 30, "deg"),
              "no friend may be within this angle of the line of fire"),
        param("clear_beyond", &G::clear_beyond_, "m", range(0, 10e3),
              "nor so far behind the target"),
        param("speed", &G::speed_, "m/s", range(50, 1000), "true airspeed to go for"),
        param("overtake", &G::overtake_, "m/s", range(0, 500),
              "at most so much faster than the target; null: never slows"),
        param("load_factor", &G::load_factor_, range(1, 12), "g, the most it turns with"),
        param("floor", &G::floor_, "m", range(0, 25e3), "aims no lower")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  [[nodiscard]] bool trigger(double time, BurstMemory& m) const;

  float vote_ = 55;
  std::optional<double> range_, tolerance_;
  double burst_ = 1;
  double pause_ = 0.5;
  double max_age_ = 2;
  double clear_cone_ = si(3, "deg");
  double clear_beyond_ = 1000;
  double speed_ = si(450, "kt");
  std::optional<double> overtake_;
  double load_factor_ = 8;
  double floor_ = si(1000, "ft");
};

}  // namespace eyrie::pilot
