// SPDX-License-Identifier: MIT
/// \file  What a plug-in does wrong in a step ends the run there, with who, where and when; the run
/// so far is kept and can be replayed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

class Fault : public testing::Test {
 protected:
  /// A flight whose second aircraft has such a tree.
  void scenario(const std::string& tree) const {
    folder.write("small.yaml", R"(eyrie: 1
name: small
reference: {latitude: 33 deg, longitude: -68 deg}
until: 4 s
trees:
  good: navigate
  bad: )" + tree + R"(
blue:
  flights:
    eagle:
      aircraft: f16c
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
      tree: good
      players: [eagle1, {eagle2: {tree: bad}}]
)");
  }
  [[nodiscard]] Ran run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--plugin", plugin("faulty")});
    return run_program(folder, arguments);
  }
  /// Flies it; whatever ended it, what was flown is there and is the same again.
  void ends(const std::string& tree, const std::string& words) const {
    scenario(tree);
    for (const std::string workers : {"1", "7"}) {
      SCOPED_TRACE(tree + " with " + workers);
      const std::string out = "run" + workers;
      const Ran ran =
          run({"fly", "small.yaml", "--out", out, "--force", "--json", "--workers", workers});
      EXPECT_EQ(ran.code, 1);
      EXPECT_EQ(ran.err, "eyrie: eagle2 at " + words + "; the run is kept up to there\n");
      const auto said = nlohmann::json::parse(ran.out, nullptr, false);
      ASSERT_FALSE(said.is_discarded()) << ran.out;
      EXPECT_EQ(said["outcome"], "fault");
      const int steps = said["steps"];
      EXPECT_NE(words.find(fmt::format("(step {})", steps)), std::string::npos) << steps;
      const Ran again = run({"replay", out});
      EXPECT_EQ(again.code, 0) << again.err;
      EXPECT_NE(again.out.find(fmt::format("the same, {} steps, world hash {}", steps,
                                           std::string(said["hash"]))),
                std::string::npos)
          << again.out << ran.out;
      EXPECT_NE(run({"explain", out}).out.find("00:01.1  a fault ended it at 00:01.1"),
                std::string::npos);
      EXPECT_EQ(read_text(folder / out + "/flight.acmi").find("nan"), std::string::npos);
    }
    EXPECT_EQ(read_text(folder / "run1/run.eyrie"), read_text(folder / "run7/run.eyrie"));
  }
  [[nodiscard]] static std::string leaf(int how) {
    return fmt::format("{{winner_takes_all: [navigate, {{misbehave: {{how: {}}}}}]}}", how);
  }

  TempFolder folder;
};

const std::string kWho = "1.06 s (step 53): root/misbehave of tree 'bad', from libfaulty.so, ";

TEST_F(Fault, NamesFieldAndValueThatMeanNothing) {
  const std::string words = kWho + "recommends what means nothing: ";
  ends(leaf(0), words + "heading is nan rad");
  ends(leaf(1), words + "heading is inf rad");
  ends(leaf(2), words + "altitude is -inf m");
  ends(leaf(3), words + "speed is 1e+300 m/s");
  ends(leaf(4), words + "load_factor is -1000000000");
  ends(leaf(5), words + "follow.velocity is nan");
  ends(leaf(6), words + "mode is 99, which has no name");
  ends(leaf(7), words + "call is 55, which has no name");
}

TEST_F(Fault, NamesTheDeepestNodeBehindABlend) {
  ends("{fusion: [{priority: [{misbehave: {how: 2}}]}, navigate]}",
       "1.06 s (step 53): root/priority/misbehave of tree 'bad', from libfaulty.so, recommends "
       "what means nothing: altitude is -inf m");
}

TEST_F(Fault, NamesWhoVotesWhatMeansNothing) {
  const std::string words = kWho + "votes what means nothing: vote is ";
  ends(leaf(10), words + "nan");
  ends(leaf(11), words + "-1");
  ends(leaf(12), words + "inf");
}

TEST_F(Fault, NamesWhoAnswersWithAStatusThatIsNone) {
  ends(leaf(13), kWho + "answers what means nothing: status is 7");
}

TEST_F(Fault, NamesWhoThrew) {
  ends(leaf(20), kWho + "threw: no fuel");
  ends(leaf(21), kWho + "threw something that is no std::exception");
  ends("{misbehave: {how: 20}}",
       "1.06 s (step 53): root of tree 'bad', from libfaulty.so, threw: no fuel");
}

TEST_F(Fault, KeepsTheRunOfWhoEndsTheProgram) {
  const std::string words = "1.06 s (step 53): libfaulty.so ";
  ends(leaf(30), words + "called exit() in a decision of tree 'bad'");
  ends(leaf(31), words + "called quick_exit() in a decision of tree 'bad'");
  ends(leaf(32), words + "called std::terminate() in a decision of tree 'bad'");
  ends(leaf(33), words + "threw: no fuel, which nobody could catch in a decision of tree 'bad'");
}

TEST_F(Fault, KeepsWhatWasSeenOfWhoDoesOtherwiseEveryTime) {
  scenario("{winner_takes_all: [once]}");
  const Ran ran = run({"fly", "small.yaml", "--out", "run", "--json", "--no-debrief"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("of tree 'bad'"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("threw: thirty; the run is kept"), std::string::npos) << ran.err;
  const Ran again = run({"replay", "run"});
  EXPECT_EQ(again.code, 0) << again.out << again.err;
}

/// The behavior does nothing wrong until it is asked what if.
TEST_F(Fault, OfWhatIsAskedEndsTheQuestionAndIsSaid) {
  scenario(leaf(99));
  ASSERT_EQ(run({"fly", "small.yaml", "--out", "run", "--no-debrief"}).code, 0);
  for (const auto& [how, words] :
       {std::pair{0, "recommends what means nothing: heading is nan rad"},
        std::pair{11, "votes what means nothing: vote is -1"}, std::pair{20, "threw: no fuel"},
        std::pair{21, "threw something that is no std::exception"}})
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--branch"}, {"--at", "2"}}) {
      std::vector<std::string> arguments{"whatif",
                                         "run",
                                         "--player",
                                         "eagle2",
                                         "--json",
                                         "--set",
                                         fmt::format("root/misbehave.how={}", how)};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Ran ran = run(arguments);
      EXPECT_EQ(ran.code, 1) << how;
      EXPECT_EQ(ran.err,
                "eyrie: with this change a run ends there, so nothing was asked after it: "
                "eagle2 at " +
                    kWho + words + "\n");
      const auto said = nlohmann::json::parse(ran.out, nullptr, false);
      ASSERT_FALSE(said.is_discarded()) << ran.out;
      EXPECT_EQ(said["decisions"], more.size() == 2 ? 0 : 10);
      EXPECT_EQ(said["fault"], "eagle2 at " + kWho + words);
    }
}

TEST_F(Fault, IsNoneButNoRunToBeExplainedIfABehaviorAnswersOtherwiseEveryTime) {
  scenario("{winner_takes_all: [once]}");
  ASSERT_EQ(run({"fly", "small.yaml", "--until", "2 s", "--out", "run", "--no-debrief"}).code, 0);
  const Ran ran = run({"explain", "run", "--player", "eagle2"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("this is not the run that was recorded by eyrie "), std::string::npos);
  EXPECT_NE(ran.err.find("; a behavior of one's own must answer the same whenever it perceives and "
                         "remembers the same"),
            std::string::npos)
      << ran.err;
}

TEST_F(Fault, IsSaidWithWhateverElseIsWatching) {
  scenario(leaf(0));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--paranoid"}, {"--quiet"}, {"--no-debrief"}}) {
    std::vector<std::string> arguments{"fly", "small.yaml", "--out", "run", "--force"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.code, 1) << more[0];
    EXPECT_NE(ran.err.find("heading is nan rad; the run is kept"), std::string::npos) << ran.err;
    EXPECT_NE(ran.out.find("a fault ended it at "), std::string::npos) << ran.out;
  }
}

TEST_F(Fault, AtLoadNamesThePluginAndIsNoSuccess) {
  scenario("unborn");
  const Ran unborn = run({"validate", "small.yaml"});
  EXPECT_EQ(unborn.code, 2);
  EXPECT_EQ(unborn.err,
            "small.yaml:7:8: node 'unborn' (of libfaulty.so) could not be made: no "
            "licence found\n");
  scenario("navigate");
  for (const auto& [name, done] :
       {std::pair<std::string, std::string>{"exit_in_add", "called exit()"},
        {"exit_in_static", "called exit()"}})
    for (const std::string command : {"validate", "fly"}) {
      const auto before = folder.everything();
      const Ran ran = run_program(folder, {command, "small.yaml", "--plugin", plugin(name)});
      EXPECT_EQ(ran.code, 2) << name;
      EXPECT_EQ(ran.err,
                plugin(name) + ": lib" + name + ".so " + done + " while it was being opened\n");
      EXPECT_EQ(folder.everything(), before);
    }
}

TEST_F(Fault, AStaticObjectThatThrowsIsSaid) {
  scenario("navigate");
  for (const std::string command : {"validate", "fly"}) {
    const auto before = folder.everything();
    const Ran ran =
        run_program(folder, {command, "small.yaml", "--plugin", plugin("throw_in_static")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("libthrow_in_static.so"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("no licence found"), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(folder.everything(), before);
  }
}

}  // namespace
}  // namespace eyrie::test
