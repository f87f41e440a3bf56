// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Keeps the own place in the flight's wall formation (pilot/formation.hpp), as the datalink tells
/// where the lead is. The place follows from the rank among the living, so the formation closes up.
/// Fails for the lead itself, and while the lead has not been heard of. Attacks nobody.
class FollowLead final : public Behavior {
 public:
  static constexpr std::string_view type_name = "follow_lead";
  static constexpr std::string_view help = "keeps the own place in the wall formation";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &FollowLead::vote_, range(0, 1000), "how strongly"),
        param("load_factor", &FollowLead::load_factor_, range(1, 12), "g, the most it turns with"),
        param("floor", &FollowLead::floor_, "m", range(0, 25e3), "follows no lower")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 20;
  double load_factor_ = 5;
  double floor_ = si(2000, "ft");
};

}  // namespace eyrie::pilot
