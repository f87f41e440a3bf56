// SPDX-License-Identifier: MIT
#pragma once
/// \file  What those who were lost decided before: replicates flown again, as tables for SQL.
#include "campaign/store.hpp"

namespace eyrie::campaign {

/// A player that was lost.
struct Loss {
  PlayerId who, by{};  ///< by: nobody if it crashed
  double time = 0;     ///< s
};
/// A field of a decision, and somebody who proposed it and did not get it.
struct Contest {
  std::size_t loss = 0;  ///< index
  double time = 0;       ///< s
  std::string field, value, winner;
  bool blended = false;  ///< the winner made it of what it and its rivals said
  std::string rival{};   ///< "" if nobody else proposed it
  float votes = 0, rival_votes = 0;
};
struct LastDecisions {
  std::uint64_t hash = 0;  ///< of the last world
  std::vector<Loss> losses;
  std::vector<Contest> contests;  ///< by loss and time within each step
};
/// Of all players of one flight who were lost: every decision of their last `window` (s).
[[nodiscard]] LastDecisions last_decisions(
    const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed, double window);

/// Fills the tables `losses` and `decisions` of a campaign with those of every replicate, flown
/// again on so many threads from what is in the database; what is there already stays. `tell` gets
/// how many of how many, and stops it by false. Throws disk::Refused if a replicate is another one
/// now.
void add_last_decisions(const std::string& folder, double window, unsigned workers,
                        const std::vector<std::string>& plugins,
                        const std::function<bool(std::uint64_t, std::uint64_t)>& tell);

}  // namespace eyrie::campaign
