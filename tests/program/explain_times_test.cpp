// SPDX-License-Identifier: MIT
/// \file  Times that explain prints, typed again, and the times that whatif takes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

/// A merge, flown once: somebody is lost in it.
Ran asked(const std::vector<std::string>& arguments) {
  struct Merge {
    TempFolder folder;
    Merge() {
      EXPECT_EQ(run_program(folder, {"fly", "merge", "--seed", "7", "--set", "ends=time", "--until",
                                     "9 min", "--quiet", "--no-debrief", "--out", "m"})
                    .code,
                0);
    }
  };
  static const Merge merge;
  return run_program(merge.folder, arguments);
}

TEST(ExplainTimes, LeadBackToTheDecisionsThatTheyWerePrintedFor) {
  std::istringstream lines(asked({"explain", "m", "--player", "viper1"}).out);
  const std::regex change(R"(^ *(\d\d:\d\d\.\d)  .*-> (?:\S+/)?(\S+) .*)");
  int changes = 0;
  for (std::string line; std::getline(lines, line); ++changes) {
    std::smatch found;
    ASSERT_TRUE(std::regex_match(line, found, change)) << line;
    const std::string time = found[1], leader = found[2];
    const Ran at = asked({"explain", "m", "--player", "viper1", "--at", time});
    const std::string first = at.out.substr(0, at.out.find('\n'));
    EXPECT_TRUE(first.starts_with("viper1 at " + time + " ")) << line << '\n' << first;
    EXPECT_NE(first.find(": " + leader + " leads"), first.npos) << line << '\n' << first;
  }
  EXPECT_GT(changes, 10);
}

TEST(ExplainTimes, AreThoseOfThePlayersMissilesToo) {
  const auto at = [](const char* who, const char* word) {
    return asked({"explain", "m", "--player", who, "--event", word}).out;
  };
  std::size_t shots = 0;
  for (const char* who : {"viper1", "bandit1"})
    if (const std::string fox = at(who, "fox"); !fox.empty()) {
      ++shots;
      EXPECT_NE(at(who, "launch").find(fox.substr(0, fox.find('\n'))), std::string::npos) << who;
    }
  EXPECT_GT(shots, 0U);
}

TEST(ExplainTimes, BeginWhatIsListedAsItIsShown) {
  const std::string all =
      asked({"explain", "m", "--player", "viper1", "--from", "1:00.3", "--to", "1:00.5"}).out;
  EXPECT_TRUE(std::regex_search(
      all, std::regex(R"(^ *01:00\.3  [^\n]*\n *01:00\.4  [^\n]*\n *01:00\.5  [^\n]*\n$)")))
      << all;
}

TEST(ExplainTimes, OfMoreThanOneDecimalAreExact) {
  const auto time_of = [](const char* time) {
    const Ran ran = asked({"explain", "m", "--player", "viper1", "--at", time, "--json"});
    return nlohmann::json::parse(ran.out).at(0).at("time_s").get<double>();
  };
  for (const char* time : {"10.01", "10.04", "10.06", "10.09"})
    EXPECT_GE(time_of(time), std::stod(time) - 1e-9);
}

TEST(WhatIfTimes, SayUntilWhenAPlayerWasThere) {
  const Ran gone =
      asked({"whatif", "m", "--player", "bandit1", "--set", "root.vote=2", "--at", "8:40"});
  EXPECT_EQ(gone.code, 2);
  EXPECT_EQ(gone.out, "");
  EXPECT_EQ(gone.err, asked({"explain", "m", "--player", "bandit1", "--at", "8:40"}).err);
  EXPECT_NE(gone.err.find("it was there until"), std::string::npos) << gone.err;
}

TEST(WhatIfTimes, AreNotForFlightsOverSeeds) {
  const Ran ran = asked(
      {"whatif", "m", "--player", "viper1", "--set", "root.vote=2", "--at", "5", "--seeds", "1"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("--at: flights over seeds begin at their start"), std::string::npos)
      << ran.err;
}

TEST(WhatIfSeeds, HaveNoStandardErrorIfItIsOne) {
  std::vector<std::string> words{"whatif", "m",           "--player", "viper1",
                                 "--set",  "root.vote=2", "--seeds",  "1"};
  const Ran said = asked(words);
  EXPECT_NE(said.out.find(" +0.00 ± -\n"), std::string::npos) << said.out;
  words.emplace_back("--json");
  const auto one = nlohmann::json::parse(asked(words).out);
  for (const auto& figure : one["over_seeds"]["figures"])
    EXPECT_TRUE(figure["standard_error"].is_null()) << figure;
  words[7] = "2";
  const auto two = nlohmann::json::parse(asked(words).out);
  for (const auto& figure : two["over_seeds"]["figures"])
    EXPECT_TRUE(figure["standard_error"].is_number()) << figure;
}

}  // namespace
}  // namespace eyrie::test
