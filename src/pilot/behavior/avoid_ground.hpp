// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Pulls up, wings level, when at the present sink rate the floor would be reached within
/// `warning_time`, less the height that a pull-out of `pull` g still costs. Fails otherwise. The
/// ground is the ellipsoid. Its vote is the highest of all by default.
///
/// Of n g, n - 1 are left at the bottom of a pull-out to bend the path: an arc of the radius
/// V^2 / (g (n - 1)), which from a dive angle c costs V^2 (1 - cos c) / (g (n - 1)) of height.
class AvoidGround final : public Behavior {
 public:
  static constexpr std::string_view type_name = "avoid_ground";
  static constexpr std::string_view help = "pulls up before the ground comes too near";
  static constexpr auto params() {
    using A = AvoidGround;
    return std::tuple{
        param("vote", &A::vote_, range(0, 1000), "how strongly"),
        param("floor", &A::floor_, "m", range(0, 10e3), "altitude to stay above"),
        param("warning_time", &A::warning_time_, "s", range(0, 60), "how far ahead it looks"),
        param("pull", &A::pull_, range(1.5, 12), "g of the pull-up"),
        param("climb", &A::climb_, "m", range(0, 10e3), "how much higher it asks for")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 100;
  double floor_ = si(1500, "ft");
  double warning_time_ = 3;
  double pull_ = 6;
  double climb_ = 500;
};

}  // namespace eyrie::pilot
