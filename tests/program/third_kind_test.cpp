// SPDX-License-Identifier: MIT
/// \file  A kind of player that Eyrie does not know (tests/plugins/ship.cpp), through the whole
/// program: one file brings it, nothing else was changed for it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/plugin.hpp"
#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

/// Two ships sail east; eagle flight comes over them.
const std::vector<Change> kWithShips{{"until: 2 s\n", "until: 60 s\n"},
                                     {"trees:\n", R"(orders:
  - {at: 20 s, player: harbor1, swap_tree: home}
  - {at: 40 s, player: harbor2, lose: true}
trees:
  patrol:
    winner_takes_all:
      - guard: {when: aircraft_range < 15 km, child: turn_away}
      - navigate: {vote: 10, speed: 8 m/s}
  home: navigate
)"},
                                     {"blue:\n", R"(red:
  task_groups:
    harbor:
      tree: patrol
      players: [harbor1, harbor2]
      start: {north: 4 nmi, east: 3 nmi}
      heading: 90 deg
      route: [{north: 4 nmi, east: 30 nmi}]
blue:
)"}};

class ThirdKind : public testing::Test {
 protected:
  ThirdKind() { folder.write("sea.yaml", changed_scenario(kWithShips)); }
  [[nodiscard]] Ran ask(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--plugin", plugin("ship")});
    return run_program(folder, arguments);
  }
  void fly() const {
    const Ran ran = ask({"fly", "sea.yaml", "--out", "run", "--paranoid", "--no-debrief"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("at sea"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.err, "");
  }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    return read_text(folder / name);
  }

  TempFolder folder;
};

TEST_F(ThirdKind, IsReadFromAFile) {
  EXPECT_EQ(ask({"validate", "sea.yaml"}).out,
            "sea.yaml: 2 aircraft in 1 flight and 2 ships in 1 task group, 3 trees\n");
  const Ran without = run_program(folder, {"validate", "sea.yaml"});
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.err.find("red has no 'task_groups'"), std::string::npos) << without.err;
}

TEST_F(ThirdKind, StandsInTheReferenceAndInTheSchemaOfFiles) {
  const std::string list = ask({"catalog"}).out, page = ask({"catalog", "--markdown"}).out;
  EXPECT_NE(list.find("\nTrees of ships: "), std::string::npos) << list;
  EXPECT_NE(list.find("\n  turn_away "), std::string::npos) << list;
  EXPECT_NE(page.find("`blue.task_groups.<name>`: ships that sail together"), std::string::npos);
  EXPECT_NE(page.find("\n| `aircraft_range` | m |"), std::string::npos) << page;
  const auto schema = nlohmann::json::parse(ask({"catalog", "--json-schema"}).out);
  const auto& kinds = schema["definitions"];
  EXPECT_TRUE(kinds["side"]["properties"].contains("task_groups"));
  EXPECT_TRUE(kinds["task_group"]["properties"].contains("heading"));
  EXPECT_TRUE(kinds["node"]["anyOf"][1]["properties"].contains("turn_away"));
}

TEST_F(ThirdKind, HasItsMistakesNamed) {
  const auto mistake = [&](const std::string& from, const std::string& to) {
    auto changes = kWithShips;
    changes.push_back({from, to});
    folder.write("sea.yaml", changed_scenario(changes));
    const Ran ran = ask({"validate", "sea.yaml"});
    EXPECT_EQ(ran.code, 2);
    return ran.err;
  };
  EXPECT_EQ(mistake("child: turn_away", "child: turn_awry"),
            "sea.yaml:12:54: there is no node 'turn_awry'; did you mean 'turn_away'?\n");
  EXPECT_EQ(
      mistake("      heading: 90 deg\n      route: [", "      heeding: 90 deg\n      route: ["),
      "sea.yaml:25:7: task_group has no parameter 'heeding'; did you mean 'heading'?\n");
  EXPECT_EQ(mistake("swap_tree: home", "swap_tree: hume"),
            "sea.yaml:7:44: there is no tree 'hume'; did you mean 'home'?\n");
}

TEST_F(ThirdKind, IsFlownToldAndRecorded) {
  fly();
  const std::string acmi = text_of("run/flight.acmi"), events = text_of("run/events.csv");
  EXPECT_NE(acmi.find("Type=Sea+Watercraft,Name=Ship,CallSign=harbor1"), std::string::npos);
  EXPECT_NE(acmi.find("0,Event=Destroyed|4|"), std::string::npos);
  EXPECT_NE(events.find("harbor2"), std::string::npos);
  EXPECT_EQ(ask({"export", "run", "--to", "geojson"}).code, 0);
  EXPECT_NE(ask({"replay", "run"}).out.find(": the same, 3000 steps"), std::string::npos);
  EXPECT_EQ(ask({"diff", "run", "run"}).code, 0);
}

TEST_F(ThirdKind, IsExplained) {
  fly();
  const Ran early = ask({"explain", "run", "--player", "harbor1", "--at", "10", "--json"});
  ASSERT_EQ(early.code, 0) << early.err;
  const std::string& text = early.out;
  EXPECT_NE(text.find("turn_away"), std::string::npos) << text;
  EXPECT_NE(text.find("#1 (eagle"), std::string::npos) << text;
  EXPECT_NE(text.find("aircraft_range"), std::string::npos) << text;
  // the order of 0:20 took the tree away
  const Ran late = ask({"explain", "run", "--player", "harbor1", "--at", "30"});
  EXPECT_EQ(late.out.find("turn_away"), std::string::npos) << late.out;
  EXPECT_NE(late.out.find("navigate"), std::string::npos) << late.out;
}

TEST_F(ThirdKind, IsAskedWhatIf) {
  fly();
  const Ran ran = ask({"whatif", "run", "--player", "harbor1", "--set", "root/navigate.vote=80",
                       "--at", "1", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto answer = nlohmann::json::parse(ran.out);
  EXPECT_GT(answer["different"], 10);
  EXPECT_EQ(answer["first"]["leader"]["other"], "navigate");
}

TEST_F(ThirdKind, IsToldOfWhenTheWorldHasNoRoom) {
  const auto flown_with = [&](const std::string& boats) {
    auto changes = kWithShips;
    changes.push_back({"heading: 90 deg\n      route: [",
                       "heading: 90 deg\n      boats: " + boats + "\n      route: ["});
    folder.write("sea.yaml", changed_scenario(changes));
  };
  flown_with("1");
  Ran ran = ask({"fly", "sea.yaml", "--until", "2 s", "--out", "one", "--no-debrief"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("\nno room in the world: 1 player could not be launched or born\n"),
            std::string::npos)
      << ran.out;
  flown_with("3");
  ran = ask({"fly", "sea.yaml", "--until", "2 s", "--out", "three", "--no-debrief"});
  EXPECT_NE(ran.out.find("no room in the world: 3 players could not"), std::string::npos);
  ran = ask({"fly", "sea.yaml", "--until", "2 s", "--out", "json", "--no-debrief", "--json"});
  EXPECT_EQ(nlohmann::json::parse(ran.out)["refused_births"], 3);
  flown_with("0");
  ran = ask({"fly", "sea.yaml", "--until", "2 s", "--out", "none", "--no-debrief"});
  EXPECT_EQ(ran.out.find("no room"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace eyrie::test
