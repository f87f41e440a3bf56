// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/flight.hpp"

namespace eyrie::test {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<std::pair<std::string, double>>& phases) {
  Names names;
  for (const auto& [name, time] : phases)
    names.push_back(name);
  return names;
}

TEST(BingoMission, SendsTheThirstyOneHomeWhileTheOthersFlyOn) {
  Flight f(load_scenario("bingo"));
  f.mission.fly();

  // only eagle3 reaches bingo, at the fuel that the scenario says, and leaves at once
  ASSERT_EQ(f.log.of(EventKind::bingo).size(), 1U);
  const Happened bingo = f.log.of(EventKind::bingo).front();
  EXPECT_EQ(f.scenario->roster.name(bingo.event.who), "eagle3");
  EXPECT_NEAR(bingo.event.values[0], 2200, 2);
  EXPECT_EQ(names_of(f.log.phases("eagle3")), (Names{"ingress", "egress"}));
  EXPECT_NEAR(f.log.phases("eagle3").back().second, bingo.time, 0.2);

  // the others do not turn back with it: minutes later they are at the end of the route
  for (const char* mate : {"eagle1", "eagle2", "eagle4"}) {
    const auto phases = f.log.phases(mate);
    EXPECT_EQ(names_of(phases), (Names{"ingress", "egress"})) << mate;
    EXPECT_GT(phases.back().second, bingo.time + 240) << mate;
  }

  // it is home before them, nobody is lost and nobody's tanks are dry
  const auto home3 = f.log.first(EventKind::home, "eagle3");
  ASSERT_TRUE(home3);
  for (const char* mate : {"eagle1", "eagle2", "eagle4"}) {
    ASSERT_TRUE(f.log.first(EventKind::home, mate)) << mate;
    EXPECT_GT(f.log.first(EventKind::home, mate)->time, home3->time) << mate;
  }
  EXPECT_TRUE(f.log.of(EventKind::fuel_out).empty());
  EXPECT_EQ(f.mission.outcome(), scenario::Outcome::blue_home);
  EXPECT_EQ(f.tally.side(model::Side::blue).home, 4U);
  EXPECT_EQ(f.tally.side(model::Side::blue).losses, 0U);
}

TEST(BingoMission, KeepsTheFlightTogetherWithFullTanks) {
  Flight f(load_scenario("bingo", {"blue.flights.eagle.players.eagle3.fuel=5900 kg"}));
  f.mission.fly();
  EXPECT_TRUE(f.log.of(EventKind::bingo).empty());
  ASSERT_EQ(f.log.phases("eagle3").size(), 2U);
  EXPECT_NEAR(f.log.phases("eagle3").back().second, f.log.phases("eagle1").back().second, 60);
}

}  // namespace
}  // namespace eyrie::test
