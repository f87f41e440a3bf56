// SPDX-License-Identifier: MIT
#include "ubf/arbiter/layers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Over = Suppress<State, Action>;

/// Probe 0 is the higher layer and asks for heading 1, probe 1 the lower one for heading 2.
Robot suppressing(double hold) {
  auto node = make<Over>(probes(2));
  node->hold = hold;
  Robot robot(std::move(node));
  robot.cue(0).action.heading = 1;
  robot.cue(1).action.heading = 2;
  return robot;
}

TEST(Suppress, ReplacesTheLowerLayerHoweverItVotes) {
  Robot robot = suppressing(0);
  robot.say(0, kSuccess, 1);
  robot.say(1, kRunning, 9);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 1);
  EXPECT_TRUE(robot.asked_now("root/probe[1]")) << "the lower layer goes on";
}

TEST(Suppress, LetsTheLowerLayerThroughWhenTheHigherOneIsSilent) {
  Robot robot = suppressing(0);
  robot.say(0, kRunning, 1);
  robot.say(1, kSuccess, 9);
  robot.tick();
  for (const Status silent : {kFailure, kRunning}) {
    robot.say(0, silent, 0);
    EXPECT_EQ(robot.tick(), kSuccess);
    EXPECT_EQ(robot.out.action.heading, 2);
    EXPECT_EQ(robot.supplier(0), "root/probe[1]");
  }
}

TEST(Suppress, HoldsTheLastProposalOfTheHigherLayer) {
  Robot robot = suppressing(2);
  robot.say(0, kSuccess, 3);
  robot.say(1, kRunning, 9);
  robot.tick_at(10);
  robot.say(0, kFailure);
  robot.cue(0).action.heading = 7;
  EXPECT_EQ(robot.tick_at(11.9), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_EQ(robot.leader(), "root/probe[0]");
  EXPECT_EQ(robot.supplier(0), "root/probe[0]");
  EXPECT_EQ(robot.tick_at(12), kRunning);
  EXPECT_EQ(robot.out.action.heading, 2);
}

TEST(Suppress, FailsWhenBothAreSilentAndForgets) {
  Robot robot = suppressing(1);
  robot.say(0, kRunning, 3);
  robot.tick_at(1);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(2), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  const std::size_t own = sizeof(SuppressMemory<Action>);
  EXPECT_TRUE(std::all_of(robot.slab.begin(), robot.slab.begin() + own,
                          [](std::byte byte) { return byte == std::byte{0}; }));
}

TEST(Suppress, HasTwoLayers) {
  EXPECT_EQ(make<Over>(probes(1))->problems(),
            std::vector<std::string>{"takes exactly 'by', 'child', but has 1 child"});
  EXPECT_EQ(make<Over>(probes(2))->problems(), std::vector<std::string>{});
}

RC_GTEST_PROP(SuppressLaw, IsTheFirstOfTwoThatIsHeard, ()) {
  const Cues cues{*any_cue(), *any_cue()};
  Cues ranked = cues;
  for (std::size_t i = 0; i < 2; ++i)
    if (cues[i].vote > 0)
      ranked[i].vote = static_cast<float>(2 - i);
  const std::size_t first = strongest(ranked);
  const Answer answer = ask<Over>(cues);
  if (first == 2)
    RC_ASSERT(answer == Answer{});
  else
    RC_ASSERT(answer ==
              (Answer{cues[first].status, {cues[first].action, cues[first].vote, kNone}}));
}

RC_GTEST_PROP(SuppressLaw, TheLowerLayerIsHeardOnlyAfterTheHold, ()) {
  const int hold = *rc::gen::inRange(1, 10);  // ticks
  Robot robot = suppressing(0.1 * hold);
  robot.say(1, kRunning, 1);
  int silent = 1000;
  for (int tick = 0; tick < 60; ++tick) {
    const bool speaks = *rc::gen::inRange(0, 4) == 0;
    robot.say(0, speaks ? kRunning : kFailure, 1);
    silent = speaks ? 0 : silent + 1;
    robot.tick();
    RC_ASSERT(robot.out.action.heading == (silent < hold ? 1 : 2));
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
