// SPDX-License-Identifier: MIT
/// \file  Run files of strangers, with a checksum that fits: every command that opens one refuses
/// what no run can be, with code 2, and ends with code 1 where it is not the run that it claims.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <vector>

#include "pilot/pilot_system.hpp"
#include "record/run_file.hpp"
#include "support/program.hpp"
#include "support/recorded.hpp"

namespace eyrie::test {
namespace {

/// Every command that flies a recorded run again.
std::vector<std::vector<std::string>> commands() {
  return {{"replay", "run.eyrie"},
          {"explain", "run.eyrie", "--player", "viper1"},
          {"export", "run.eyrie", "--to", "czml"},
          {"export", "run.eyrie", "--to", "decisions"},
          {"export", "run.eyrie", "--to", "sqlite"},
          {"debrief", "run.eyrie"},
          {"whatif", "run.eyrie", "--player", "viper1", "--set", "root.vote=2"},
          {"diff", "run.eyrie", "run.eyrie"}};
}

class StrangeRun : public testing::Test {
 protected:
  StrangeRun() : run(recorded_flight("merge", 20).run) {}

  /// What every command says of the file, if they agree.
  void expect_all(int code, const std::string& words) {
    folder.write("run.eyrie", record::encode(run));
    expect_all_of_file(code, words);
  }
  void expect_all_of_file(int code, const std::string& words) {
    const auto before = folder.everything();
    for (const auto& command : commands()) {
      const Ran ran = run_program(folder, command);
      EXPECT_EQ(ran.code, code) << command[0] << ": " << ran.err;
      const std::string& said = command[0] == "replay" && code == 1 ? ran.out : ran.err;
      EXPECT_NE(said.find("run.eyrie: "), std::string::npos) << command[0] << ": " << said;
      EXPECT_NE(said.find(words), std::string::npos) << command[0] << ": " << said;
      EXPECT_EQ(folder.everything(), before) << command[0];
    }
  }
  TempFolder folder;
  record::RunFile run;
};

TEST_F(StrangeRun, IsTheSameIfNobodyTouchedIt) {
  folder.write("run.eyrie", record::encode(run));
  EXPECT_EQ(run_program(folder, {"replay", "run.eyrie"}).code, 0);
  EXPECT_EQ(run_program(folder, {"diff", "run.eyrie", "run.eyrie"}).code, 0);
}

TEST_F(StrangeRun, MayNotClaimMoreStepsThanItHasHashesFor) {
  run.trail.spans += "\xff\xff\xff\xff\xff\xff\xff\x7f";
  expect_all(2, "the run file is corrupt: its hashes do not fit");
}

TEST_F(StrangeRun, MayNotClaimMoreTimeThanAScenarioMayHave) {
  sim::TrailPacker packer(50);
  sim::Mark mark{.step = 50'000'001, .hash = 1, .digest = {}};
  packer.mark(mark);
  run.trail.spans = packer.take();
  expect_all(2, "it claims 50000001 steps, more than a run can have");
}

/// Six hours more, with hashes, but not with those of a flight: nobody flies them.
TEST_F(StrangeRun, EndsWhereItIsNotTheRunThatItClaims) {
  sim::TrailPacker packer(50);
  sim::Mark mark{.step = 0, .hash = 1, .digest = {}};
  packer.mark(mark);
  for (std::uint64_t step = 5; step <= 1'080'000; step += 5)
    packer.fold(0);
  mark.step = 1'080'000;
  packer.mark(mark);
  run.trail.spans = packer.take();
  expect_all(1, "the worlds differ from the start");
}

TEST_F(StrangeRun, MustHaveHashes) {
  run.trail.spans.clear();
  expect_all(2, "the run file has no hashes that a replay could be compared with");
}

TEST_F(StrangeRun, IsComparedByWhoeverFliesIt) {
  run.sets.push_back("blue.flights.viper.players.viper1.fuel=2499 kg");
  expect_all(1, "aircraft.propulsion.fuel of player 1 (row 0)");
}

TEST_F(StrangeRun, IsComparedInItsMiddle) {
  const auto scenario = load_scenario("merge");
  run.orders = {pilot::PilotSystem::swap_tree_order(503, scenario->roster.find("bandit1").value(),
                                                    scenario->trees->find("homeward").value())};
  expect_all(1, "the worlds part between steps 500 and 505; step 550: aircraft.");
}

TEST_F(StrangeRun, MayNotHaveOrdersThatNobodyAccepts) {
  run.orders.resize(1);
  run.orders[0].kind = sim::OrderKind(77);
  expect_all(2, "nobody in its scenario accepts orders of kind 77");
}

TEST_F(StrangeRun, MayNotHaveOrdersToNobody) {
  run.orders = {pilot::PilotSystem::swap_tree_order(9, PlayerId{77}, 0)};
  expect_all(2, "nobody in its scenario is player 77");
}

TEST_F(StrangeRun, MayNotHaveMoreOrdersThanItsStepsTake) {
  run.orders.assign(1000000, pilot::PilotSystem::swap_tree_order(9, PlayerId{1}, 0));
  expect_all(2, "it claims 1000000 orders, more than the ");
}

TEST_F(StrangeRun, HasItsScenarioInIt) {
  run.scenario = "/etc/passwd";
  expect_all(2, "it is corrupt: its scenario '/etc/passwd' is not in it");
}

TEST_F(StrangeRun, MayNotHaveOrdersInDisorder) {
  run.orders = {pilot::PilotSystem::swap_tree_order(9, PlayerId{1}, 0),
                pilot::PilotSystem::swap_tree_order(8, PlayerId{1}, 0)};
  expect_all(2, "its orders for the steps 9 and 8 stand the wrong way round");
}

TEST_F(StrangeRun, HasTheRateOfItsScenario) {
  run.trail.steps_per_second = 54;  // folds would lie as far apart
  expect_all(1, "the replay makes 50 steps per second, the recording 54");
}

TEST_F(StrangeRun, IsAFile) {
  ASSERT_EQ(::mkfifo((folder / "run.eyrie").c_str(), 0600), 0);
  expect_all_of_file(2, "is a pipe, not a file");
  std::filesystem::remove(folder / "run.eyrie");
  std::filesystem::create_symlink("/dev/zero", folder / "run.eyrie");
  expect_all_of_file(2, "is a device, not a file");
  std::filesystem::remove(folder / "run.eyrie");
  expect_all_of_file(2, "there is no such file");
}

/// Two gigabytes that take no room on the disk: nobody reads them.
TEST_F(StrangeRun, IsNotTooLarge) {
  folder.write("run.eyrie", "EYRIERUN");
  std::filesystem::resize_file(folder / "run.eyrie", std::uintmax_t{2} << 30);
  expect_all_of_file(2, "is larger than 1024 MB");
}

}  // namespace
}  // namespace eyrie::test
