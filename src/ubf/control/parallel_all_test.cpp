// SPDX-License-Identifier: MIT
#include "ubf/control/parallel.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

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
  EXPECT_EQ(parallel_all(2, 3)->problem(), "failure_count is 3, but the number of children is 2");
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
