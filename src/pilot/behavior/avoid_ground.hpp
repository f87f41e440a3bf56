// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Pulls up when the present sink rate, with the height that a pull-out of `pull` g costs, would go
/// below the floor within `warning_time`. Fails otherwise.
class AvoidGround final : public Behavior {
 public:
  static constexpr std::string_view type_name = "avoid_ground";
  static constexpr std::string_view help = "pulls up before the ground comes too near";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &AvoidGround::vote_, range(0, 1000), "how strongly"),
        param("floor", &AvoidGround::floor_, "m", range(0, 10e3), "altitude to stay above"),
        param("warning_time", &AvoidGround::warning_time_, "s", range(0, 60),
              "how far ahead it looks"),
        param("pull", &AvoidGround::pull_, range(1.5, 12), "g of the pull-up")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 100;
  double floor_ = si(1500, "ft");
  double warning_time_ = 3;
  double pull_ = 6;
};

}  // namespace eyrie::pilot
