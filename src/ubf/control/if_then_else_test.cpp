// SPDX-License-Identifier: MIT
#include "ubf/control/branch.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using If = IfThenElse<State, Action>;

TEST(IfThenElse, AsksTheBranchThatItsConditionSays) {
  Robot robot(make<If>(probes(3)));
  robot.cue(1) = {kSuccess, 2, {.heading = 1}};
  robot.cue(2) = {kSuccess, 3, {.heading = 2}};
  robot.cue(0) = {kSuccess, 9, {.heading = 0, .altitude = 5}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1})) << "what the condition proposes is ignored";
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.heading, 2);
  EXPECT_EQ(robot.out.vote, 3);
}

TEST(IfThenElse, DoesNotAskTheConditionWhileABranchRuns) {
  Robot robot(make<If>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
  EXPECT_TRUE(robot.asked_now("root/probe[1]"));
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/probe[2]")) << "the condition is asked again";
}

TEST(IfThenElse, RunsWithoutAProposalWhileItsConditionRuns) {
  Robot robot(make<If>(probes(3)));
  robot.cue(0) = {kRunning, 9, {.heading = 0}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(IfThenElse, ClosesAnArbiterThatEnded) {
  Robot robot(make<If>(check(2), make<Wta>(probe(0), probe(1)), probe(3)));
  robot.say(2, kSuccess);
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(IfThenElse, HasThreeChildren) {
  EXPECT_EQ(make<If>(probes(2))->problems(),
            std::vector<std::string>{"takes exactly 'if', 'then', 'else', but has 2 children"});
  EXPECT_EQ(make<If>(probes(3))->problems(), std::vector<std::string>{});
}

}  // namespace
}  // namespace eyrie::ubf::testing
