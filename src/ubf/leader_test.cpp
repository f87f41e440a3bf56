// SPDX-License-Identifier: MIT
/// \file  Who led: known of every decision without a trace.
#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "support/ubf/trees.hpp"

namespace eyrie::ubf::testing {
namespace {

template <class Arbiter>
Robot two_pairs() {
  Robot robot(make<Arbiter>(make<Arbiter>(probe(0), probe(1)), make<Arbiter>(probe(2), probe(3))));
  for (std::size_t i = 0; i < 4; ++i)
    robot.cue(i) = {kRunning, static_cast<float>(1 + i % 3), {.heading = 1}};
  return robot;
}

TEST(Leader, IsTheWinnersLeafThroughTwoLevels) {
  Robot robot = two_pairs<Wta>();
  robot.tick();
  EXPECT_EQ(robot.leader(), "root/winner_takes_all[1]/probe[0]");
}

TEST(Leader, OfFieldsPutTogetherIsTheStrongestVoiceAndOfABlendTheArbiter) {
  Robot per_field = two_pairs<PerField<State, Action>>();
  per_field.tick();
  EXPECT_EQ(per_field.leader(), "root/per_field[1]/probe[0]");
  Robot fusion = two_pairs<Fusion<State, Action>>();
  fusion.tick();
  EXPECT_EQ(fusion.leader(), "root");
}

TEST(Leader, OfASequenceIsWhoMadeItsProposalAndNoCondition) {
  Robot robot(make<Sequence<State, Action>>(check(0), probe(1), check(2)));
  robot.say(0, kSuccess);
  robot.cue(1) = {kSuccess, 0, {.heading = 1}};
  robot.say(2, kSuccess);
  robot.tick();
  EXPECT_EQ(robot.leader(), "root/probe");
  robot.cue(1).action = {};
  robot.tick();
  EXPECT_EQ(robot.leader(), "") << "nobody proposed anything";
}

TEST(Leader, OfAParallelIsItsStrongestOrWithoutVotesTheFirstWhoProposes) {
  Robot robot(make<Parallel<State, Action>>(check(9), probe(0), probe(1)));
  robot.say(9, kSuccess);
  robot.cue(0) = {kRunning, 0, {.heading = 1}};
  robot.cue(1) = {kRunning, 0, {.heading = 2}};
  robot.tick();
  EXPECT_EQ(robot.leader(), "root/probe[0]");
  robot.cue(1).vote = 1;
  robot.tick();
  EXPECT_EQ(robot.leader(), "root/probe[1]");
}

TEST(Leader, StaysTheSilentChildWhileACommitmentHolds) {
  auto node = make<Commitment<State, Action>>(make<Wta>(probe(0), probe(1)));
  node->hold = 1;
  Robot robot(std::move(node));
  robot.cue(1) = {kRunning, 2, {.heading = 1}};
  robot.tick();
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.leader(), "root/winner_takes_all/probe[1]");
}

TEST(Leader, IsNobodyAfterAFailure) {
  Robot robot = two_pairs<Wta>();
  for (std::size_t i = 0; i < 4; ++i)
    robot.say(i, kFailure);
  robot.tick();
  EXPECT_EQ(robot.leader(), "");
}

TEST(Leader, OfATreeOfOneLeafIsThatLeaf) {
  Robot robot(probe(0));
  robot.cue(0) = {kRunning, 2, {.heading = 1}};
  robot.tick();
  EXPECT_EQ(robot.leader(), "root");
}

TEST(Leader, OfEveryTreeIsALeafOrABlendingArbiterIfThereIsAProposal) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    for (int i = 0; i < 20; ++i) {
      weather.blow(robot.state);
      robot.tick();
      ASSERT_EQ(robot.out.leader == kNone, robot.out.is_empty()) << "tree " << seed;
      if (robot.out.leader != kNone) {
        const Node& leader = robot.tree.node(robot.out.leader);
        const std::set<std::string_view> blending{"fusion", "paper_fusion", "motor_schema",
                                                  "vote_grid", "utility"};
        ASSERT_TRUE(leader.children().empty() || blending.contains(leader.type()))
            << "tree " << seed << ": " << robot.leader();
      }
    }
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
