// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// Kills of twelve duels against one who notches and throws out nothing.
int kills_of(const std::string& aircraft) {
  int kills = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Flight f(
        load_scenario("duel_defense",
                      {"red.flights.bogey.tree=notches", "red.flights.bogey.aircraft=" + aircraft,
                       "trees.notches.winner_takes_all.1.notch.dispense=none"}),
        seed);
    f.fly_until(300);
    kills += static_cast<int>(f.log.of(EventKind::kill, "eagle1").size());
  }
  return kills;
}

TEST(TowedDecoy, SavesWhoTurnsHisSideToTheMissile) {
  EXPECT_GT(kills_of("mig29"), 3);
  EXPECT_LT(kills_of("towing_mig29"), 2) << "it passes between both, which are as bright";
}

}  // namespace
}  // namespace eyrie::test
