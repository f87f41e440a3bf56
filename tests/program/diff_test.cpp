// SPDX-License-Identifier: MIT
/// \file  `eyrie diff` as a user has it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

TEST(DiffProgram, WritesValuesOfEventsInTheUnitsAskedFor) {
  const TempFolder folder;
  for (const char* seed : {"7", "13"})
    ASSERT_EQ(run_program(folder, {"fly", "sweep", "--until", "1 s", "--quiet", "--no-debrief",
                                   "--seed", seed, "--out", seed})
                  .code,
              0);
  const auto has = [](const std::string& text, const char* pattern) {
    return std::regex_search(text, std::regex(pattern));
  };
  const auto event = [&](const char* units) {
    const std::string words = run_program(folder, {"diff", "7", "13", "--units", units}).out;
    return words.substr(words.find("\nevent "));
  };
  EXPECT_TRUE(has(event("us"), R"( range \S+ (nmi|ft); and [^;]+ range \S+ \1 in the other)"));
  EXPECT_TRUE(has(event("metric"), R"( range \S+ (k?m); and [^;]+ range \S+ \1 in the other)"));
}

TEST(DiffProgram, ComparesThoseOfTheSameNamesByWhatTheyDecide) {
  const TempFolder folder;
  folder.write("small.yaml", kSmallScenario);
  folder.write("cobra.yaml", changed_scenario({{"    eagle:", "    cobra:"},
                                               {"[eagle1, eagle2]", "[cobra1, cobra2]"}}));
  const auto fly = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"fly"});
    more.insert(more.end(), {"--quiet", "--no-debrief"});
    ASSERT_EQ(run_program(folder, more).code, 0);
  };
  fly({"small.yaml", "--out", "a"});
  fly({"small.yaml", "--out", "b", "--set", "blue.flights.eagle.start.heading=80 deg"});
  fly({"cobra.yaml", "--out", "c"});
  const Ran others = run_program(folder, {"diff", "a", "c"});
  EXPECT_EQ(others.code, 2);
  EXPECT_NE(others.err.find("have other players: eagle1 is cobra1 in the other"), std::string::npos)
      << others.err;
  const Ran parted = run_program(folder, {"diff", "a", "b"});
  EXPECT_EQ(parted.code, 1);
  EXPECT_TRUE(std::regex_search(parted.out, std::regex(R"(\naction +\S+  eagle\d: navigate)")))
      << parted.out;
  EXPECT_FALSE(std::regex_search(parted.out, std::regex(R"(: ([^\n]+); and \1 in the other)")))
      << parted.out;
  const auto both = nlohmann::json::parse(run_program(folder, {"diff", "a", "b", "--json"}).out);
  const auto& world = both["world"];
  EXPECT_TRUE(std::string(world["text"])
                  .starts_with(fmt::format("step {}: ", world["step"].get<std::uint64_t>())))
      << world;
  EXPECT_NEAR(world["time_s"], 0.02 * world["step"].get<double>(), 1e-9);
  // an event at the time that it has in events.csv
  const auto& event = both["event"];
  ASSERT_TRUE(event.is_object()) << parted.out;
  const std::string row = fmt::format("\n{:.3f},{},", event["time_s"].get<double>(),
                                      event["step"].get<std::uint64_t>());
  EXPECT_TRUE(read_text(folder / "a/events.csv").find(row) != std::string::npos ||
              read_text(folder / "b/events.csv").find(row) != std::string::npos)
      << row;
}

TEST(DiffProgram, NamesTheTreesOfAnEventWhereverTheyStandInTheFile) {
  const TempFolder folder;
  // the same phases: of a tree with another name, and of the same tree behind one more
  const std::string phases = "{sequencer: {start: a, trees: {a: navigate}}}";
  folder.write("one.yaml", changed_scenario({{"trees:", "trees:\n  one: " + phases}}));
  folder.write("two.yaml",
               changed_scenario({{"trees:", "trees:\n  before: navigate\n  one: " + phases}}));
  folder.write("three.yaml",
               changed_scenario({{"trees:", "trees:\n  before: navigate\n  other: " + phases}}));
  for (const std::string name : {"one", "two", "three"})
    ASSERT_EQ(run_program(folder,
                          {"fly", name + ".yaml", "--out", name, "--quiet", "--no-debrief", "--set",
                           name == "three" ? "blue.flights.eagle.tree=other"
                                           : "blue.flights.eagle.tree=one"})
                  .code,
              0);
  const std::string same = run_program(folder, {"diff", "one", "two"}).out;
  EXPECT_EQ(same.find("aux"), std::string::npos) << same;
  EXPECT_EQ(same.find("event"), std::string::npos) << same;
  const std::string other = run_program(folder, {"diff", "one", "three"}).out;
  EXPECT_NE(other.find(", tree 'one'; and"), std::string::npos) << other;
}

}  // namespace
}  // namespace eyrie::test
