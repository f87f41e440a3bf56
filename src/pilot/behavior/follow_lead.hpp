// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "team/follow_lead.hpp"

namespace eyrie::pilot {

/// Keeps the own place in the flight's wall formation (team/follow_lead.hpp, pilot/formation.hpp),
/// as the datalink tells where the lead is. Attacks nobody.
class FollowLead final : public team::FollowLead<Platform> {
 public:
  static constexpr std::string_view help = "keeps the own place in the wall formation";
  static constexpr auto params() {
    return std::tuple_cat(
        team::FollowLead<Platform>::params(),
        std::tuple{param("load_factor", &FollowLead::load_factor_, range(1, 12),
                         "g, the most it turns with"),
                   param("floor", &FollowLead::floor_, "m", range(0, 25e3), "follows no lower")});
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double load_factor_ = 5;
  double floor_ = si(2000, "ft");
};

}  // namespace eyrie::pilot
