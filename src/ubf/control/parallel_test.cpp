// SPDX-License-Identifier: MIT
#include "ubf/control/parallel.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Par = Parallel<State, Action>;

Child parallel(std::size_t children, std::optional<std::uint32_t> successes,
               std::uint32_t failures) {
  auto node = make<Par>(probes(children));
  node->success_count = successes;
  node->failure_count = failures;
  return node;
}

TEST(Parallel, SucceedsWhenAllDoUnlessToldOtherwise) {
  Robot robot(make<Par>(probes(2)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  EXPECT_EQ(robot.tick(), kRunning);
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
}

TEST(Parallel, LetsSuccessWinWhenBothThresholdsAreReachedInOneTick) {
  Robot robot(parallel(2, 1, 1));
  robot.say(0, kFailure);
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
}

TEST(Parallel, FailsWhenSuccessIsOutOfReach) {
  Robot robot(parallel(3, 2, 3));
  robot.say(0, kRunning);
  robot.say(1, kSuccess);
  robot.say(2, kFailure);
  EXPECT_EQ(robot.tick(), kRunning) << "the first may still make it two";
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
}

TEST(Parallel, MergesFieldByFieldFromTheHighestVote) {
  Robot robot(parallel(3, 2, 2));
  robot.cue(0) = {kRunning, 2, {.heading = 1, .altitude = 100}};
  robot.cue(1) = {kSuccess, 3, {.heading = 2}};
  robot.cue(2) = {kFailure, 9, {.heading = 3, .release = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2, .altitude = 100}));
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
  EXPECT_EQ(robot.supplier(1), "root/probe[0]");
}

TEST(Parallel, AlsoMergesActionsWithoutAVoteAsPlainTreesHaveThem) {
  Robot robot(parallel(2, 2, 2));
  robot.cue(0) = {kRunning, 0, {.heading = 1}};
  robot.cue(1) = {kRunning, 0, {.heading = 2, .speed = 5}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1, .speed = 5}));
  EXPECT_EQ(robot.supplier(0), "root/probe[0]");
}

TEST(Parallel, ProposesNothingWhenItFails) {
  Robot robot(parallel(2, 2, 1));
  robot.cue(0) = {kRunning, 5, {.heading = 1}};
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Parallel, MakesChildrenThatStillRunForgetOnceWhenItEnds) {
  Robot robot(parallel(3, 1, 3));
  robot.say(0, kRunning);
  robot.say(1, kFailure);
  robot.say(2, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[0]"), 0);
  robot.say(2, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
  EXPECT_EQ(robot.asked("root/probe[0]"), 0u);
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
  EXPECT_EQ(robot.asked("root/probe[1]"), 2u) << "it had ended by itself";
  EXPECT_EQ(robot.halts("root/probe[2]"), 0);
}

TEST(Parallel, ClosesItsArbitersWhenItEnds) {
  Robot robot(make<Par>(make<Wta>(probe(0), probe(1))));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(Parallel, AsksEachChildOnceIfToldTo) {
  auto node = make<Par>(probe(0), probe(1));
  node->once = true;
  Robot robot(std::move(node));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  EXPECT_EQ(robot.tick(), kRunning);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning) << "it has succeeded";
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.say(1, kRunning);
  EXPECT_EQ(robot.tick(), kFailure) << "it begins anew, and ends with the first that fails";
  EXPECT_TRUE(robot.asked_now("root/probe[0]"));
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
  EXPECT_EQ(robot.halts("root/probe[0]"), 0);
}

TEST(Parallel, ForgetsAnArbiterThatEndedOnceAtOnce) {
  auto node = make<Par>(make<Wta>(probe(0), probe(1)), probe(2));
  node->once = true;
  Robot robot(std::move(node));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  robot.say(2, kRunning);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
  robot.say(2, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 0) << "not twice";
}

TEST(Parallel, RefusesThresholdsThatCannotBeReached) {
  EXPECT_EQ(parallel(3, 4, 1)->problem(), "success_count is 4, but there are 3 children");
  EXPECT_EQ(parallel(1, 1, 2)->problem(), "failure_count is 2, but there is 1 child");
  EXPECT_EQ(parallel(65, 1, 1)->problem(), "parallel takes at most 64 children, here are 65");
  EXPECT_EQ(parallel(64, 64, 64)->problem(), "");
}

TEST(Parallel, HaltsTheLastOfSixtyFourChildren) {
  auto node = make<Par>(probes(State::kCues));
  Children many;
  for (std::size_t i = 0; i < Par::kMostInABitSet; ++i)
    many.push_back(probe(i < 63 ? 0 : 1));
  node->adopt(std::move(many));
  node->success_count = 63;
  Robot robot(std::move(node));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/probe[63]"), 1);
  EXPECT_EQ(robot.halts("root/probe[62]"), 0);
}

using All = ParallelAll<State, Action>;

Child parallel_all(std::size_t children, std::uint32_t failures) {
  auto node = make<All>(probes(children));
  node->failure_count = failures;
  return node;
}

TEST(ParallelAll, WaitsForTheLastChildAndAsksNoneAgainThatEnded) {
  Robot robot(parallel_all(3, 1));
  robot.say(0, kSuccess);
  robot.say(1, kFailure);
  robot.say(2, kRunning);
  EXPECT_EQ(robot.tick(), kRunning) << "a failure does not cut the others short";
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
  EXPECT_FALSE(robot.asked_now("root/probe[1]"));
  robot.say(2, kSuccess);
  EXPECT_EQ(robot.tick(), kFailure) << "child 1 failed in the first tick";
  EXPECT_EQ(robot.tick(), kSuccess) << "it begins anew";
  EXPECT_TRUE(robot.asked_now("root/probe[0]"));
}

TEST(ParallelAll, FailsAtThatManyFailures) {
  for (std::uint32_t limit = 1; limit <= 3; ++limit)
    for (std::uint32_t failures = 0; failures <= 3; ++failures) {
      Robot robot(parallel_all(3, limit));
      for (std::uint32_t i = 0; i < 3; ++i)
        robot.say(i, i < failures ? kFailure : kSuccess);
      EXPECT_EQ(robot.tick(), failures >= limit ? kFailure : kSuccess);
    }
}

TEST(ParallelAll, MergesWhatIsProposedInThisTick) {
  Robot robot(parallel_all(2, 1));
  robot.cue(0) = {kSuccess, 3, {.heading = 1}};
  robot.cue(1) = {kRunning, 2, {.heading = 2, .altitude = 7}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1, .altitude = 7}));
  EXPECT_EQ(robot.out.vote, 3);
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2, .altitude = 7}));
  EXPECT_EQ(robot.out.vote, 2);
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
}

TEST(ParallelAll, ClosesAnArbiterThatEnded) {
  Robot robot(make<All>(make<Wta>(probe(0), probe(1)), probe(2)));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  robot.say(2, kRunning);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(ParallelAll, RefusesWhatCannotBeReached) {
  EXPECT_EQ(parallel_all(2, 3)->problem(), "failure_count is 3, but there are 2 children");
  EXPECT_EQ(parallel_all(65, 1)->problem(), "parallel_all takes at most 64 children, here are 65");
  EXPECT_EQ(parallel_all(64, 64)->problem(), "");
}

TEST(ParallelAll, RemembersTheLastOfSixtyFourChildren) {
  Children many;
  for (std::size_t i = 0; i < All::kMostInABitSet; ++i)
    many.push_back(probe(i < 63 ? 0 : 1));
  Robot robot(make<All>(std::move(many)));
  robot.say(0, kRunning);
  robot.say(1, kFailure);
  robot.tick();
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_FALSE(robot.asked_now("root/probe[63]"));
}

}  // namespace
}  // namespace eyrie::ubf::testing
