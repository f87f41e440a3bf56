// SPDX-License-Identifier: MIT
/// \file  `eyrie replay` flies a recorded run again: the same, or where it first differs.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "pilot/pilot_system.hpp"
#include "record/run_file.hpp"
#include "support/flight.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// A minute of the merge, recorded; and ways to tamper with the file.
class Replay : public testing::Test {
 protected:
  Replay() {
    const Ran ran =
        run_program(folder, {"fly", "merge", "--until", "60 s", "--out", "run", "--json"});
    if (ran.code != 0)
      throw std::runtime_error(ran.err);
    report = json::parse(ran.out);
    run = record::read_run_file(folder / "run/run.eyrie").run;
  }

  Ran replay(std::vector<std::string> more = {}) {
    std::vector<std::string> all{"replay", "run"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(folder, all);
  }
  void write(const std::string& bytes) {
    std::ofstream(folder / "run/run.eyrie", std::ios::binary) << bytes;
  }
  void write(const record::RunFile& changed) { write(record::encode(changed)); }

  TempFolder folder;
  json report;
  record::RunFile run;
};

TEST_F(Replay, SaysTheSame) {
  const Ran ran = replay();
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out, "run/run.eyrie: the same, 3000 steps, world hash " +
                         report["hash"].get<std::string>() + "\n");
  const json j = json::parse(replay({"--json", "--workers", "3"}).out);
  EXPECT_EQ(j["same"], true);
  EXPECT_EQ(j["steps"], 3000);
  EXPECT_EQ(j["hash"], report["hash"]);
  EXPECT_EQ(run_program(folder, {"replay", "run/run.eyrie"}).code, 0) << "or the file itself";
  std::filesystem::create_directory(folder / "runs");
  std::filesystem::copy(folder / "run", folder / "runs/merge-1",
                        std::filesystem::copy_options::recursive);
  EXPECT_EQ(run_program(folder, {"replay", "merge-1"}).err,
            "merge-1: there is no such file; did you mean 'runs/merge-1'?\n");
}

TEST_F(Replay, NeedsNothingButTheFile) {
  EXPECT_TRUE(run.files.contains("data/aircraft/f16c.yaml"));
  EXPECT_TRUE(run.files.contains(run.scenario));
  const TempFolder elsewhere;
  std::filesystem::copy(folder / "run/run.eyrie", elsewhere / "run.eyrie");
  const Ran ran = run_program(elsewhere, {"replay", "run.eyrie"}, {.home = "/nowhere"});
  EXPECT_EQ(ran.code, 0) << ran.err;
}

TEST_F(Replay, NamesTheFirstDifferenceOfAnotherSeed) {
  record::RunFile changed = run;
  changed.seed = 2;
  write(changed);
  const Ran ran = replay();
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("run/run.eyrie: differs from the recording by eyrie "), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("the worlds differ from the start; step 0: header differs"),
            std::string::npos)
      << ran.out;
  const Ran machine = replay({"--json"});
  EXPECT_EQ(machine.code, 1);
  const json j = json::parse(machine.out);
  EXPECT_EQ(j["same"], false);
  EXPECT_EQ(j["first_step"], 0);
}

/// The texts inside decide what is flown: with other fuel the run differs from the start, in the
/// column of propulsion, of that player.
TEST_F(Replay, NamesStepColumnPlayerAndFieldOfAnotherScenario) {
  record::RunFile changed = run;
  changed.sets.push_back("blue.flights.viper.players.viper1.fuel=2499 kg");
  write(changed);
  const Ran ran = replay();
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(
      std::regex_search(ran.out, std::regex(R"(aircraft\.propulsion\.fuel of player 1 \(row 0\))")))
      << ran.out;
  const json j = json::parse(replay({"--json"}).out);
  EXPECT_EQ(j["first_step"], 0);
  ASSERT_TRUE(j.contains("where")) << j;
  EXPECT_EQ(j["where"]["table"], "aircraft");
  EXPECT_EQ(j["where"]["column"], "propulsion");
  EXPECT_EQ(j["where"]["field"], "fuel");
  EXPECT_EQ(j["where"]["player"], 1);
}

/// Orders come from the recording: what the scenario inside orders is not carried out twice.
TEST_F(Replay, TakesTheOrdersOfTheRecording) {
  record::RunFile changed = run;
  std::string& text = changed.files.at(changed.scenario);
  const auto at = text.find("seed: 4");
  ASSERT_NE(at, std::string::npos);
  text.insert(at, "orders: [{at: 30 s, player: bandit1, swap_tree: homeward}]\n");
  write(changed);
  EXPECT_EQ(replay().code, 0);

  // with the order in the recording too the run goes another way from then on, and it is found
  const auto scenario = load_scenario("merge");
  changed.orders = {pilot::PilotSystem::swap_tree_order(
      1500, scenario->roster.find("bandit1").value(), scenario->trees->find("homeward").value())};
  write(changed);
  const json j = json::parse(replay({"--json"}).out);
  ASSERT_TRUE(j.contains("where")) << j;
  EXPECT_EQ(j["same"], false);
  EXPECT_EQ(j["first_step"], 1505) << "the first hash after the order";
  EXPECT_TRUE(j["reason"].get<std::string>().starts_with(
      "the worlds part between steps 1500 and 1505; step 1550: aircraft."))
      << j["reason"];
  EXPECT_EQ(j["where"]["table"], "aircraft");
  // the first in row order: himself, or who hears his radar from another place
  EXPECT_LE(j["where"]["player"], 2);
}

TEST_F(Replay, RefusesWhatIsCutForeignOrBroken) {
  const std::string whole = read_text(folder / "run/run.eyrie");
  const auto expect = [&](const std::string& bytes, const std::string& error) {
    write(bytes);
    const Ran ran = replay();
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "run/run.eyrie: " + error + "\n");
    EXPECT_EQ(ran.out, "");
  };
  expect(whole.substr(0, whole.size() - 1),
         "the run file is cut or corrupt: its checksum does not fit");
  expect(whole.substr(0, 10), "the run file is cut");
  expect("", "this is not a run file");
  expect("FileType=text/acmi/tacview\nFileVersion=2.2\n", "this is not a run file");
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  write(flipped);
  EXPECT_EQ(replay().code, 2);
}

TEST_F(Replay, RefusesAWorldOfAnotherLayout) {
  record::RunFile changed = run;
  changed.layout_hash ^= 1;
  write(changed);
  const Ran ran = replay();
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("another layout"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace eyrie::test
