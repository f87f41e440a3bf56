// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Invert = Inverter<State, Action>;

TEST(Inverter, TurnsSuccessIntoFailureAndBackAndLeavesRunning) {
  Robot robot(make<Invert>(probe(0)));
  for (const auto& [says, answer] :
       {std::pair{kFailure, kSuccess}, {kRunning, kRunning}, {kSuccess, kFailure}}) {
    robot.cue(0) = {says, 3, {.heading = 1}};
    EXPECT_EQ(robot.tick(), answer);
    EXPECT_EQ(robot.out.is_empty(), says != kRunning) << to_text(says);
  }
}

TEST(Inverter, OfARunningChildHandsOnItsProposal) {
  Robot robot(make<Invert>(probe(0)));
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_EQ(robot.supplier(0), "root/probe");
}

TEST(Inverter, MakesAnArbiterBelowItStandAsLongAsItIsAsked) {
  Robot robot(make<Selector<State, Action>>(probe(0), make<Invert>(make<Wta>(probe(1), probe(2)))));
  robot.say(1, kSuccess, 5);
  robot.say(2, kRunning, 1);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/inverter/winner_takes_all/probe[1]"), 2u);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.asked("root/inverter/winner_takes_all/probe[1]"), 0u);
}

TEST(Inverter, NeedsExactlyOneChild) {
  EXPECT_EQ(make<Invert>()->problems(),
            std::vector<std::string>{"takes exactly 'child', but has 0 children"});
  EXPECT_EQ(make<Invert>(probe(0), probe(1))->problems(),
            std::vector<std::string>{"takes exactly 'child', but has 2 children"});
  EXPECT_EQ(make<Invert>(probe(0))->problems(), std::vector<std::string>{});
}

}  // namespace
}  // namespace eyrie::ubf::testing
