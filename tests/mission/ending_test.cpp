// SPDX-License-Identifier: MIT
/// \file  When a mission is over, for every way of saying so and whoever is lost.
#include <gtest/gtest.h>

#include "support/flight.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using scenario::Outcome;

struct Ending {
  Outcome outcome;
  double time;  ///< s
};

/// One against one, far apart and for 3 s; these are lost after a second.
Ending ending(const std::string& ends, std::initializer_list<const char*> lost) {
  const TempFolder folder;
  std::string orders;
  for (const char* player : lost)
    orders += std::string("  - {at: 1 s, player: ") + player + ", lose: true}\n";
  const std::string file =
      folder.write("duel.yaml", "ends: " + ends + "\norders:\n" + orders + R"(eyrie: 1
name: duel
reference: {latitude: 33 deg, longitude: -68 deg}
until: 3 s
trees: {ahead: navigate}
blue:
  flights:
    eagle:
      aircraft: f15c
      tree: ahead
      players: [eagle1]
      start: {north: 0 nmi, east: 0 nmi, altitude: 25000 ft, heading: 90 deg, speed: 480 kt}
      route: [{north: 0 nmi, east: 60 nmi, altitude: 25000 ft, speed: 480 kt}]
red:
  flights:
    bogey:
      aircraft: mig29
      tree: ahead
      players: [bogey1]
      start: {north: 200 nmi, east: 0 nmi, altitude: 25000 ft, heading: 90 deg, speed: 480 kt}
      route: [{north: 200 nmi, east: 60 nmi, altitude: 25000 ft, speed: 480 kt}]
)");
  Flight f(scenario::load({file}, scenario::Source::disk(".")));
  f.mission.fly();
  return {f.mission.outcome(), f.time()};
}

void expect(const Ending& is, Outcome outcome, double time) {
  EXPECT_EQ(is.outcome, outcome) << enum_name(is.outcome);
  EXPECT_NEAR(is.time, time, 0.03);
}

TEST(MissionEnds, WhenOneSideIsLeftWhicheverThatIs) {
  expect(ending("last_side", {"bogey1"}), Outcome::red_lost, 1);
  expect(ending("last_side", {"eagle1"}), Outcome::blue_lost, 1);
  expect(ending("last_side", {"eagle1", "bogey1"}), Outcome::both_lost, 1);
}

TEST(MissionEnds, WithBlueAloneWhereThatIsAsked) {
  expect(ending("blue_home", {"bogey1"}), Outcome::time, 3);
  expect(ending("blue_home", {"eagle1"}), Outcome::blue_lost, 1);
}

TEST(MissionEnds, AtItsTimeWhoeverIsLost) {
  expect(ending("time", {"bogey1"}), Outcome::time, 3);
  expect(ending("time", {"eagle1"}), Outcome::time, 3);
}

TEST(Tally, CountsAsKillsOnlyThoseOfTheOtherSide) {
  const auto scenario = load_scenario("sweep");
  const auto player = [&](const char* name) { return *scenario->roster.find(name); };
  record::Tally tally(*scenario);
  const sim::World world = scenario->world(1);
  const auto kill = [&](const char* who, const char* whom) {
    const sim::Event event{
        .kind = sim::EventKind(EventKind::kill), .who = player(who), .whom = player(whom)};
    tally.observe(world, {.step = 1, .seed = 1, .dt = 0.02}, {&event, 1});
  };
  kill("eagle1", "eagle2");
  kill("eagle1", "bogey1");
  EXPECT_EQ(tally.players()[0].kills, 1U);
  EXPECT_EQ(tally.side(model::Side::blue).losses, 1U);
}

}  // namespace
}  // namespace eyrie::test
