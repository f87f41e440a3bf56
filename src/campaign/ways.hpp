// SPDX-License-Identifier: MIT
#pragma once
/// \file  The ways flown in some replicates of a campaign, to be drawn.
#include <array>

#include "campaign/again.hpp"

namespace eyrie::campaign {

/// Of one player.
struct Way {
  std::uint64_t cell = 0, replicate = 0;
  std::string player, side;
  bool lost = false;
  /// m north and east of the reference point, every kEvery seconds, and at the end.
  std::vector<std::array<double, 2>> places;

  static constexpr double kEvery = 10;
};

/// Of the first `count` replicates of each cell, flown again on so many threads. `tell` gets how
/// many of how many, and stops it by false. Throws as Again does.
[[nodiscard]] std::vector<Way> ways_flown(
    const std::string& folder, std::uint64_t count, unsigned workers,
    const std::vector<std::string>& plugins,
    const std::function<bool(std::uint64_t, std::uint64_t)>& tell);

}  // namespace eyrie::campaign
