// SPDX-License-Identifier: MIT
#include "scenario/trees.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/yaml.hpp"
#include "scenario/plugins.hpp"

namespace eyrie::scenario {
namespace {

struct Book {
  TreeBook trees;
  std::string mistakes;
};

/// Trees for eagle1, who flies `flown`, and truck1, who drives `driven`.
Book book_of(const std::string& trees, const std::string& flown, const std::string& driven) {
  Diagnostics diagnostics;
  const Value document = parse_yaml(
      trees + "\nblue:\n  flights: {eagle: {tree: " + flown + ", players: [eagle1]}}\n" +
          (driven.empty() ? "" : "  convoys: {truck: {tree: " + driven + ", players: [truck1]}}\n"),
      "a", diagnostics);
  const Plans plans = read_plans(document, diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  Book book;
  book.trees = TreeBook::read(document, plans, {}, Plugins().registries(), {}, diagnostics);
  book.mistakes = diagnostics.text();
  return book;
}

TEST(TreeBook, ReadsATreeForWhoUsesIt) {
  const Book b = book_of("trees: {air: pursue, road: scatter, both: navigate, idle: follow_lead}",
                         "air", "road");
  EXPECT_EQ(b.mistakes, "");
  EXPECT_TRUE(b.trees.pilots()->find("air"));
  EXPECT_FALSE(b.trees.drivers()->find("air"));
  EXPECT_TRUE(b.trees.drivers()->find("road"));
  EXPECT_FALSE(b.trees.pilots()->find("road"));
  EXPECT_TRUE(b.trees.pilots()->find("idle")) << "nobody's yet";
  EXPECT_TRUE(b.trees.drivers()->find("idle"));
}

TEST(TreeBook, LetsPilotsAndDriversShareATree) {
  const Book b = book_of(
      "trees: {way: {winner_takes_all: [{follow_lead: {vote: 20}}, {navigate: {vote: 10}}]}}",
      "way", "way");
  EXPECT_EQ(b.mistakes, "");
  EXPECT_TRUE(b.trees.pilots()->find("way"));
  EXPECT_TRUE(b.trees.drivers()->find("way"));
}

TEST(TreeBook, RunsWhatWasWrittenForOnePlatformOnTheOtherUnderItsOwnNames) {
  const std::string package =
      "trees:\n"
      "  wary: {guard: {when: range > 5 km, child: navigate}}\n"
      "  air: {tree: wary}\n"
      "  road: {tree: {wary: {fields: {range: aircraft_range}}}}\n";
  const Book b = book_of(package, "air", "road");
  EXPECT_EQ(b.mistakes, "");
  EXPECT_TRUE(b.trees.pilots()->find("air"));
  EXPECT_TRUE(b.trees.drivers()->find("road"));
  EXPECT_FALSE(b.trees.drivers()->find("wary")) << "a driver's state has no range";
}

TEST(TreeBook, DoesNotReadByItselfWhatIsReadUnderOtherNamesAlone) {
  const std::string trees =
      "trees:\n"
      "  near: distance < 5 km\n"
      "  patrol: {guard: {when: {tree: near}, child: navigate}}\n"
      "  air: {tree: {patrol: {fields: {distance: range}}}}\n";
  EXPECT_EQ(book_of(trees, "air", "").mistakes, "");
  EXPECT_EQ(book_of(trees + "  lost: distance < 5 km\n", "air", "").mistakes,
            "a:5:9: there is no state field 'distance'");
  EXPECT_EQ(book_of(trees, "patrol", "").mistakes, "a:2:9: there is no state field 'distance'");
}

TEST(TreeBook, SaysThatATruckCannotFlyAndAnAircraftCannotScatter) {
  EXPECT_EQ(book_of("trees: {air: pursue, road: scatter}", "air", "air").mistakes,
            "a:4:27: truck1 is a vehicle, and tree 'air' is for pilots (a:1:14: there is no node "
            "'pursue')");
  EXPECT_EQ(book_of("trees: {air: pursue, road: scatter}", "road", "road").mistakes,
            "a:3:27: eagle1 is an aircraft, and tree 'road' is for drivers (a:1:28: there is no "
            "node 'scatter')");
}

TEST(TreeBook, SaysWhereAnOrderNamesATreeOfTheOtherPlatform) {
  Diagnostics diagnostics;
  const Value document = parse_yaml(
      "trees: {air: pursue, road: scatter}\n"
      "orders: [{at: 1 s, player: eagle1, swap_tree: road}]\n"
      "blue:\n  flights: {eagle: {tree: air, players: [eagle1]}}\n"
      "  convoys: {truck: {tree: road, players: [truck1]}}\n",
      "a", diagnostics);
  const Plans plans = read_plans(document, diagnostics);
  static_cast<void>(TreeBook::read(document, plans,
                                   {{.at = 1, .player = "eagle1", .swap_tree = "road"}},
                                   Plugins().registries(), {}, diagnostics));
  EXPECT_EQ(diagnostics.text(),
            "a:2:47: eagle1 is an aircraft, and tree 'road' is for drivers (a:1:28: there is no "
            "node 'scatter')");
}

TEST(TreeBook, SaysForWhomATreeWasReadThatNobodyCanUse) {
  EXPECT_EQ(book_of("trees: {air: navigate, road: {sequence: [pursue, scatter]}}", "air", "road")
                .mistakes,
            "a:1:42: there is no node 'pursue' (in a tree for drivers: truck1 has it)");
  EXPECT_EQ(book_of("trees: {air: {navigate: {spede: 1}}}", "air", "").mistakes,
            "a:1:26: navigate has no parameter 'spede'; did you mean 'speed'?")
      << "without convoys there is nothing to explain";
  EXPECT_EQ(book_of("trees: {air: navigate, free: {sequence: [{pursue: {vote: 2000, spede: 1}}]}}",
                    "air", "")
                .mistakes,
            "a:1:58: vote: 2000 is outside [0, 1000]\n"
            "a:1:64: pursue has no parameter 'spede'; did you mean 'speed'?")
      << "whoever knows more of the nodes is meant, however many mistakes they have";
}

TEST(TreeBook, KnowsNoAltitudeOnTheGround) {
  EXPECT_EQ(
      book_of("trees: {air: pursue, road: {sequence: [altitude > 1 km, scatter]}}", "air", "road")
          .mistakes,
      "a:1:40: there is no state field 'altitude', only time, speed, heading, rank, alive, leads, "
      "gap, aircraft, aircraft_range, hostile (in a tree for drivers: truck1 has it)");
}

TEST(TreeBook, LimitsTheNodesOfAllTreesTogether) {
  std::string text = "trees:\n  big: {sequence: [navigate";
  for (int i = 1; i < 60'000; ++i)
    text += ",navigate";
  text += "]}\n";
  for (int i = 0; i < 50; ++i)
    text += "  x" + std::to_string(i) + ": {tree: big}\n";
  EXPECT_EQ(book_of(text, "x40", "").mistakes,
            "a:10:7: trees: with 'x7' they have more than 500000 nodes");
}

TEST(TreeBook, ChecksTreesThatNobodyGivesArguments) {
  EXPECT_EQ(book_of("trees:\n"
                    "  air: navigate\n"
                    "  good: {parameters: {near: , vote: 3}, root: {guard: {when: range < $near,\n"
                    "    child: {pursue: {vote: $vote}}}}}\n"
                    "  typo: {parameters: {near: , far: }, root: {holds: range < $naer}, rot: 3}\n"
                    "  bare: {parameters: {near: }}\n"
                    "  names: {parameters: {near: , far: }, root: {holds: range < $naer}}\n"
                    "  idle: {parameters: {near: , far: }, root: {holds: range < $near}}\n",
                    "air", "")
                .mistakes,
            "a:5:69: a tree with parameters has 'parameters' and 'root', got 'rot'\n"
            "a:6:9: tree 'bare' has parameters but no 'root'\n"
            "a:7:54: tree 'names' has no parameter 'naer'; did you mean 'near'?\n"
            "a:8:31: tree 'idle' never uses its parameter 'far'");
}

}  // namespace
}  // namespace eyrie::scenario
