// SPDX-License-Identifier: MIT
#include "scenario/plan.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "core/yaml.hpp"

namespace eyrie::scenario {
namespace {

struct Read {
  std::vector<FlightPlan> plans;
  std::vector<ConvoyPlan> convoys;
  std::string mistakes;
};

Read read(std::string_view yaml) {
  Diagnostics diagnostics;
  const Value document = parse_yaml(yaml, "a", diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  Read result;
  Plans read = read_plans(document, diagnostics);
  result.plans = std::move(read.flights);
  result.convoys = std::move(read.convoys);
  result.mistakes = diagnostics.text();
  return result;
}

/// Flight eagle with these players.
std::string players(std::string_view list) {
  return read("blue: {flights: {eagle: {players: " + std::string(list) + "}}}\n").mistakes;
}

TEST(Plan, ReadsSidesFlightsAndPlayersByRank) {
  const auto [plans, convoys, mistakes] = read(
      "red: {flights: {bogey: {players: [bogey1]}}}\n"
      "blue:\n"
      "  flights:\n"
      "    viper: {players: [viper1]}\n"
      "    eagle: {players: [eagle3, eagle1, eagle2], aircraft: f15c}\n");
  EXPECT_EQ(mistakes, "");
  ASSERT_EQ(plans.size(), 3u);
  EXPECT_EQ(plans[0].name, "viper");
  EXPECT_EQ(plans[1].name, "eagle");
  EXPECT_EQ(plans[2].name, "bogey");
  EXPECT_EQ(plans[0].side, model::Side::blue);
  EXPECT_EQ(plans[2].side, model::Side::red);
  ASSERT_EQ(plans[1].players.size(), 3u);
  for (std::uint16_t i = 0; i < 3; ++i) {
    EXPECT_EQ(plans[1].players[i].rank, i + 1);
    EXPECT_EQ(plans[1].players[i].name, "eagle" + std::to_string(i + 1));
    EXPECT_EQ(plans[1].players[i].spec.aircraft, "f15c");
  }
  EXPECT_EQ(plans[1].players[2].where, (Location{"a", 5, 23}));
}

TEST(Plan, LetsAPlayerSayWhatItsFlightSaysDifferently) {
  const auto [plans, convoys, mistakes] = read(
      "blue:\n"
      "  flights:\n"
      "    eagle:\n"
      "      aircraft: f15c\n"
      "      fuel: 5000 kg\n"
      "      start: {north: 1 nmi, east: 2 nmi, altitude: 20000 ft, heading: 90 deg}\n"
      "      players:\n"
      "        - eagle1:\n"
      "        - eagle2: {fuel: 4000 kg, start: {heading: 80 deg}}\n"
      "        - eagle3: {aircraft: f16c, start: {latitude: 33 deg, longitude: -68 deg}}\n");
  ASSERT_EQ(mistakes, "");
  const auto& p = plans.at(0).players;
  ASSERT_EQ(p.size(), 3u);
  EXPECT_EQ(p[0].spec.fuel, 5000);
  EXPECT_EQ(p[1].spec.fuel, 4000);
  EXPECT_EQ(p[1].spec.start.heading, si(80, "deg"));
  EXPECT_EQ(p[1].spec.start.north, si(1, "nmi"));
  EXPECT_FALSE(p[1].own_place) << "a heading is no place: it stays in the formation";
  EXPECT_EQ(p[2].spec.aircraft, "f16c");
  EXPECT_TRUE(p[2].own_place);
  EXPECT_EQ(p[2].spec.start.north, std::nullopt) << "a place replaces the flight's as a whole";
  EXPECT_EQ(p[2].spec.start.altitude, si(20000, "ft"));
}

TEST(Plan, GivesAFlightTheHomeOfItsSideUnlessItHasItsOwn) {
  const auto [plans, convoys, mistakes] = read(
      "blue:\n"
      "  home: {north: 1 nmi, east: 2 nmi}\n"
      "  flights:\n"
      "    a: {players: [a1]}\n"
      "    b: {players: [b1], home: {north: 3 nmi, east: 4 nmi}}\n"
      "red: {flights: {c: {players: [c1]}}}\n");
  ASSERT_EQ(mistakes, "");
  EXPECT_EQ(plans[0].home->north, si(1, "nmi"));
  EXPECT_EQ(plans[0].home_where, (Location{"a", 2, 9}));
  EXPECT_EQ(plans[1].home->north, si(3, "nmi"));
  EXPECT_EQ(plans[1].home_where, (Location{"a", 5, 30}));
  EXPECT_EQ(plans[2].home, std::nullopt);
}

TEST(Plan, RefusesAFlightWithoutALead) {
  EXPECT_EQ(players("[eagle2, eagle3]"),
            "a:1:35: flight 'eagle' has no lead: none of its players is 'eagle1'");
}

TEST(Plan, RefusesTwoPlayersOfOneName) {
  EXPECT_EQ(players("[eagle1, eagle2, {eagle1: {fuel: 1 kg}}]"),
            "a:1:52: there are two players 'eagle1' (also at a:1:36)");
}

TEST(Plan, RefusesNamesThatAreNotTheFlightAndARank) {
  EXPECT_EQ(players("[eagle1, eagel2]"),
            "a:1:44: 'eagel2' is not the flight's name and a rank, such as 'eagle1'");
  EXPECT_EQ(players("[eagle1, eagle]"),
            "a:1:44: 'eagle' is not the flight's name and a rank, such as 'eagle1'");
  EXPECT_EQ(players("[eagle01]"),
            "a:1:36: 'eagle01' is not the flight's name and a rank, such as 'eagle1'");
  EXPECT_EQ(players("[eagle0]"),
            "a:1:36: 'eagle0' is not the flight's name and a rank, such as 'eagle1'");
  EXPECT_EQ(players("[eagle1x]"),
            "a:1:36: 'eagle1x' is not the flight's name and a rank, such as 'eagle1'");
  EXPECT_EQ(players("[eagle99999]"),
            "a:1:36: 'eagle99999' is not the flight's name and a rank, such as 'eagle1'");
}

TEST(Plan, RefusesRanksThatNoFlightHas) {
  EXPECT_EQ(players("[eagle1, eagle8]"), "");
  EXPECT_EQ(players("[eagle1, eagle2, eagle3, eagle4, eagle5, eagle6, eagle7, eagle8, eagle9]"),
            "a:1:100: 'eagle9': the ranks of a flight are 1 to 8");
}

TEST(Plan, RefusesPlayersThatAreNone) {
  const std::string needs = "flight 'eagle' needs its players: a list such as [eagle1, eagle2]";
  EXPECT_EQ(players("[]"), "a:1:35: " + needs);
  EXPECT_EQ(players("eagle1"), "a:1:35: " + needs);
  EXPECT_EQ(read("blue: {flights: {eagle: {}}}\n").mistakes, "a:1:18: " + needs);
  EXPECT_EQ(players("[[eagle1]]"),
            "a:1:36: players: expected a name or a name with a map, got a list");
  EXPECT_EQ(players("[{eagle1: {}, eagle2: {}}]"),
            "a:1:36: players: expected a name or a name with a map, got a map");
  EXPECT_EQ(players("[eagle1: 3]"), "a:1:44: player: expected a map, got '3'");
}

TEST(Plan, RefusesNamesThatCannotNameAFlight) {
  for (const std::string name : {"Eagle", "eagle2", "2eagle", "e-agle", "''"}) {
    const std::string shown = name == "''" ? name : "'" + name + "'";
    EXPECT_EQ(read("blue: {flights: {" + name + ": {players: [x1]}}}\n").mistakes,
              "a:1:18: " + shown +
                  " cannot name a flight: lower-case letters, digits and '_', with a letter first "
                  "and no digit last, at most 40 in all");
  }
  EXPECT_EQ(read("blue: {flights: {f_2_x: {players: [f_2_x1]}}}\n").mistakes, "");
}

TEST(Plan, RefusesTwoFlightsOfOneNameOnAnySide) {
  EXPECT_EQ(read("blue: {flights: {eagle: {players: [eagle1]}}}\n"
                 "red: {flights: {eagle: {players: [eagle1]}}}\n")
                .mistakes,
            "a:2:17: flight 'eagle' is defined twice (also at a:1:18)");
}

TEST(Plan, NamesTheNearestRightKey) {
  EXPECT_EQ(
      read("blue: {flihgts: {}, flights: {eagle: {players: [eagle1], aircaft: f15c}}}\n").mistakes,
      "a:1:8: blue has no 'flihgts'; did you mean 'flights'?\n"
      "a:1:58: flight has no parameter 'aircaft'; did you mean 'aircraft'?");
  EXPECT_EQ(
      players("[eagle1, {eagle2: {fule: 3 kg, start: {nroth: 0}, formation: {}}}]"),
      "a:1:54: player has no parameter 'fule'; did you mean 'fuel'?\n"
      "a:1:74: start: start has no parameter 'nroth'; did you mean 'north'?\n"
      "a:1:85: player has no parameter 'formation', only aircraft, tree, start, spread, fuel, "
      "bingo, loadout, rounds, privileged");
}

TEST(Plan, CollectsMistakesOfUnitsAndRanges) {
  EXPECT_EQ(read("blue:\n"
                 "  flights:\n"
                 "    eagle:\n"
                 "      players: [eagle1]\n"
                 "      fuel: 900 ft\n"
                 "      start: {heading: 90, speed: -3 kt}\n"
                 "      route: [{north: 600 km}]\n")
                .mistakes,
            "a:5:13: fuel: expected a mass such as '900 kg', got '900 ft' (a length)\n"
            "a:6:24: start.heading: expected an angle such as '30 deg', got '90' (without a unit)\n"
            "a:6:35: start.speed: -3 kt is outside [1 m/s, 1000 m/s]\n"
            "a:7:23: route[0].north: 600 km is outside [-500 km, 500 km]");
}

TEST(Plan, RefusesSidesWithoutAnything) {
  EXPECT_EQ(read("seed: 1\n").mistakes, "a:1:1: no flights: neither blue nor red has any");
  EXPECT_EQ(read("blue: {flights: {eagle: }}\n").mistakes,
            "a:1:18: flight 'eagle': expected a map, got nothing");
  EXPECT_EQ(read("blue:\n").mistakes, "a:1:1: blue: expected a map with flights, got nothing");
  EXPECT_EQ(read("blue: [eagle]\n").mistakes,
            "a:1:7: blue: expected a map with flights, got a list");
  EXPECT_EQ(read("blue: {home: {north: 0, east: 0}}\n").mistakes,
            "a:1:7: blue: expected a map of flights, got nothing");
  EXPECT_EQ(read("blue: {flights: {}}\n").mistakes,
            "a:1:17: blue: expected a map of flights, got an empty map");
  EXPECT_EQ(read("blue: {flihts: {}}\n").mistakes,
            "a:1:8: blue has no 'flihts'; did you mean 'flights'?");
}

TEST(Plan, ReadsConvoysOfVehicles) {
  const auto [plans, convoys, mistakes] = read(
      "red: {convoys: {column: {vehicle: m939, gap: 80 m, players: [column2, column1]}}}\n"
      "blue:\n"
      "  flights: {eagle: {players: [eagle1]}}\n"
      "  convoys:\n"
      "    supply:\n"
      "      start: {north: 1 km, east: 2 km, heading: 90 deg}\n"
      "      route: [{north: 1 km, east: 9 km, speed: 60 km/h}]\n"
      "      players: [supply1, {supply2: {vehicle: m113}}]\n");
  EXPECT_EQ(mistakes, "");
  ASSERT_EQ(plans.size(), 1u);
  ASSERT_EQ(convoys.size(), 2u);
  EXPECT_EQ(convoys[0].name, "supply");
  EXPECT_EQ(convoys[0].players[1].spec.vehicle, "m113");
  EXPECT_EQ(convoys[0].spec.route.at(0).speed, si(60, "km/h"));
  EXPECT_EQ(convoys[1].side, model::Side::red);
  EXPECT_EQ(convoys[1].spec.gap, 80);
  EXPECT_EQ(convoys[1].players[0].name, "column1");
}

TEST(Plan, RefusesOnTheGroundWhatOnlyAircraftHave) {
  EXPECT_EQ(read("blue: {convoys: {supply: {players: [supply1], loadout: [aim9],\n"
                 "  start: {north: 1 km, east: 2 km, altitude: 3 km},\n"
                 "  route: [{north: 1 km, east: 2 km, altitude: 3 km}]}}}\n")
                .mistakes,
            "a:1:47: supply drives on the ground: 'loadout' is for aircraft\n"
            "a:2:36: supply drives on the ground: 'altitude' is for aircraft\n"
            "a:3:37: supply drives on the ground: 'altitude' is for aircraft");
}

TEST(Plan, RefusesAConvoyThatHasTheNameOfAFlight) {
  EXPECT_EQ(read("blue: {flights: {eagle: {players: [eagle1]}}, convoys: {eagle: {players: "
                 "[eagle1]}}}\n")
                .mistakes,
            "a:1:57: convoy 'eagle' is defined twice (also at a:1:18)");
}

}  // namespace
}  // namespace eyrie::scenario
