// SPDX-License-Identifier: MIT
/// \file  `eyrie fly --seeds` as its user sees it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

Ran seeds(const TempFolder& folder, const std::string& range, std::vector<std::string> more = {}) {
  std::vector<std::string> all{"fly", "merge", "--until", "100 s", "--seeds", range};
  all.insert(all.end(), more.begin(), more.end());
  return run_program(folder, all);
}
std::vector<json> lines_of(const std::string& text) {
  std::vector<json> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    all.push_back(json::parse(line));
  return all;
}

TEST(FlySeeds, TellsTheSameForAnyNumberOfWorkers) {
  const TempFolder folder;
  const Ran alone = seeds(folder, "3..9", {"--workers", "1"});
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_EQ(alone.err, "");
  EXPECT_NE(alone.out.find(": seeds 3 to 9\n"), std::string::npos) << alone.out;
  EXPECT_NE(alone.out.find("\ntime                              6    85.7 %   48.7 to 97.4 %\n"),
            std::string::npos)
      << alone.out;
  EXPECT_NE(alone.out.find("eyrie fly merge --seed 3 --until '100 s'\n"), std::string::npos)
      << alone.out;
  EXPECT_EQ(seeds(folder, "3..9", {"--workers", "4"}).out, alone.out);
  EXPECT_EQ(seeds(folder, "3..9").out, alone.out);
  EXPECT_TRUE(folder.everything().empty()) << "nothing is written";
}

TEST(FlySeeds, GivesALineForEachFlightAndOneForAll) {
  const TempFolder folder;
  const Ran ran = seeds(folder, "3", {"--json", "--set", "blue.flights.viper.aircraft=f15c"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto said = lines_of(ran.out);
  ASSERT_EQ(said.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(said[i]["seed"], i + 1);
  EXPECT_EQ(said[3]["flown"], 3);

  // the command that is given shows the flight that it is given for
  const std::string command = said[3]["stand_out"][0]["command"];
  EXPECT_EQ(command,
            "eyrie fly merge --seed 1 --set blue.flights.viper.aircraft=f15c --until '100 s'");
  const json one = json::parse(run_program(folder, {"fly", "merge", "--seed", "1", "--set",
                                                    "blue.flights.viper.aircraft=f15c", "--until",
                                                    "100 s", "--json", "--out", "one"})
                                   .out);
  EXPECT_EQ(one["hash"], said[0]["hash"]);
  EXPECT_EQ(one["sides"]["red"]["shots"], said[0]["red"]["shots"]);
}

TEST(FlySeeds, DrawsItsProgressWithinALineOfTheTerminal) {
  const TempFolder folder;
  const auto drawn = [&](const std::string& settings) {
    return run_line(folder, "script -qec 'stty cols 40; " + settings +
                                " \"$EYRIE\" fly sweep --seeds 8 --until \"3 min\" --workers 1 "
                                ">/dev/null' shown </dev/null >/dev/null; sed -e 1d -e '$d' shown")
        .out;
  };
  const std::string all = drawn("TERM=xterm");
  ASSERT_NE(all.find("\rseeds [##"), all.npos) << all;
  std::istringstream in(all);
  for (std::string line; std::getline(in, line, '\r');)
    EXPECT_LT(line.size(), 40 + std::string_view("\x1b[K").size()) << line;
  EXPECT_EQ(drawn("TERM=dumb").find("seeds"), all.npos);
}

TEST(FlySeeds, RefusesWhatIsNoRangeAndWhatIsForOneFlight) {
  const TempFolder folder;
  for (const std::string range : {"5..1", "1..", "..5", "a", "1...5", "1..5x", "0", "-3"})
    EXPECT_EQ(
        seeds(folder, range).err,
        "--seeds: '" + range + "' is no range of seeds such as 1..500, or 500 for the same\n");
  EXPECT_EQ(seeds(folder, "1..1000001").err, "--seeds: '1..1000001' are more than 1000000 seeds\n");
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--out", "x"},
                                               {"--real-time"},
                                               {"--tacview"},
                                               {"--paranoid"},
                                               {"--force"},
                                               {"--quiet"},
                                               {"--no-debrief"}}) {
    const Ran ran = seeds(folder, "1..3", more);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "eyrie: --seeds excludes " + more[0] + "\neyrie fly --help says more\n");
  }
}

TEST(FlySeeds, KeepsWhatWasFlownWhenItIsStopped) {
  const TempFolder folder;
  // once there are three lines
  const std::string script = "cd " + folder.path().string() +
                             "; touch out; EYRIE_HOME=" + source_root() + " " + program_path() +
                             " fly merge --seeds 1..1000000 --json >out 2>err & "
                             "until [ \"$(wc -l <out)\" -ge 3 ]; do sleep 0.05; done; "
                             "kill -TERM $!; wait $!";
  const int status = std::system(script.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM);
  const auto said = lines_of(read_text(folder / "out"));
  const std::size_t flown = said.back()["flown"];
  EXPECT_GE(flown, 3U);
  EXPECT_EQ(said.size(), flown + 1);
  EXPECT_EQ(read_text(folder / "err"),
            fmt::format("eyrie: interrupted: {} of 1000000 seeds were flown\n", flown));
}

/// One aircraft that misbehaves.
std::string misbehaving(int how) {
  return fmt::format(R"(eyrie: 1
name: small
reference: {{latitude: 33 deg, longitude: -68 deg}}
until: 5 s
ends: time
trees: {{bad: {{misbehave: {{how: {}}}}}}}
blue:
  home: {{north: 0 nmi, east: -20 nmi}}
  flights:
    eagle:
      aircraft: f15c
      start: {{north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}}
      tree: bad
      players: [eagle1]
)",
                     how);
}

TEST(FlySeeds, GoesOnAfterAFaultAndNamesIt) {
  const TempFolder folder;
  const auto scenario = [&](int how) {
    folder.write("small.yaml", misbehaving(how));
    return run_program(folder, {"fly", "small.yaml", "--seeds", "4..6", "--workers", "1",
                                "--plugin", plugin("faulty")});
  };
  const Ran throws = scenario(20);
  EXPECT_EQ(throws.code, 1);
  EXPECT_NE(throws.out.find("\nfault                             3   100.0 %"), std::string::npos)
      << throws.out;
  EXPECT_TRUE(throws.err.starts_with(
      "eyrie: 3 of 3 flights ended with a fault, the first seed 4: eagle1 at 1.0"))
      << throws.err;
  const Ran ends = scenario(30);
  EXPECT_EQ(ends.code, 1);
  EXPECT_EQ(ends.err,
            "eyrie: libfaulty.so called exit() and ended the program; eyrie fly "
            "small.yaml --seed 4 --plugin " +
                plugin("faulty") + " shows it\n");
}

TEST(WhatIfOverSeeds, AddsNoFlightWithAFaultToTheMeans) {
  const TempFolder folder;
  folder.write("small.yaml", misbehaving(99));
  ASSERT_EQ(run_program(folder, {"fly", "small.yaml", "--out", "run", "--no-debrief", "--plugin",
                                 plugin("faulty")})
                .code,
            0);
  const Ran ran = run_program(folder, {"whatif", "run", "--player", "eagle1", "--set", "root.how=0",
                                       "--seeds", "2", "--json", "--plugin", plugin("faulty")});
  EXPECT_EQ(ran.code, 1) << ran.err;
  const json said = json::parse(ran.out)["over_seeds"];
  EXPECT_EQ(said["faults"], 2);
  EXPECT_EQ(said["figures"], json::array()) << "no seed was flown both ways";
}

}  // namespace
}  // namespace eyrie::test
