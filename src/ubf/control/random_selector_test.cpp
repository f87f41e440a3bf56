// SPDX-License-Identifier: MIT
#include "ubf/control/random_selector.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Shuffled = RandomSelector<State, Action>;

Child random_selector(std::vector<double> weights, std::size_t children) {
  auto node = make<Shuffled>(probes(children));
  node->weights = std::move(weights);
  return node;
}

/// Child i proposes altitude i, so that the result tells who was chosen.
void number(Robot& robot, std::size_t children, Status answer) {
  for (std::size_t i = 0; i < children; ++i)
    robot.cue(i) = {answer, 1, {.altitude = static_cast<double>(i)}};
}

TEST(RandomSelector, DrawsByWeight) {
  Robot robot(random_selector({1, 2, 5}, 3));
  number(robot, 3, kSuccess);
  std::array<int, 3> drawn{};
  constexpr int kDraws = 8000;
  for (int i = 0; i < kDraws; ++i) {
    EXPECT_EQ(robot.tick(), kSuccess);
    ++drawn[static_cast<std::size_t>(robot.out.action.altitude.value())];
  }
  // four standard deviations of a binomial count are 177 at most
  EXPECT_NEAR(drawn[0], kDraws / 8, 180);
  EXPECT_NEAR(drawn[1], kDraws / 4, 180);
  EXPECT_NEAR(drawn[2], kDraws * 5 / 8, 180);
}

TEST(RandomSelector, DoesNotDrawAgainWhileAChildRuns) {
  Robot robot(random_selector({}, 3));
  number(robot, 3, kRunning);
  robot.tick();
  const auto first = robot.out.action.altitude;
  for (int i = 0; i < 50; ++i) {
    robot.tick();
    ASSERT_EQ(robot.out.action.altitude, first);
  }
}

TEST(RandomSelector, DoesNotTryAChildAgainThatFailedInThisRound) {
  Robot robot(random_selector({}, 2));
  number(robot, 2, kRunning);
  robot.tick();
  const auto first = static_cast<std::size_t>(robot.out.action.altitude.value());
  robot.say(first, kFailure, 1);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.altitude, 1 - static_cast<double>(first));
  robot.say(first, kRunning, 1);
  robot.say(1 - first, kFailure, 1);
  EXPECT_EQ(robot.tick(), kFailure) << "both have failed";
}

TEST(RandomSelector, ClosesAnArbiterThatEnded) {
  Robot robot(make<Shuffled>(make<Wta>(probe(0), probe(1))));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(RandomSelector, RefusesWeightsThatDoNotFitItsChildren) {
  EXPECT_EQ(random_selector({1, 2}, 3)->problem(), "random_selector has 2 weights for 3 children");
  EXPECT_EQ(random_selector({}, 65)->problem(),
            "random_selector takes at most 64 children, here are 65");
  EXPECT_EQ(random_selector({1, 2, 3}, 3)->problem(), "");
}

RC_GTEST_PROP(RandomSelectorLaw, FailsIfAllFailAndElseStopsAtTheFirstThatDoesNot, ()) {
  const Cues cues = *any_cues();
  Robot robot(make<Shuffled>(probes(cues.size())));
  robot.step = *rc::gen::arbitrary<std::uint32_t>();
  const Answer answer = ask(robot, cues);
  std::size_t taken = 0;
  bool all_fail = true;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    const bool asked = robot.trace.row(static_cast<NodeIndex>(i + 1)).ticked;
    all_fail &= cues[i].status == kFailure;
    if (!asked || cues[i].status == kFailure)
      continue;
    ++taken;
    RC_ASSERT(answer == (Answer{cues[i].status, {cues[i].action, cues[i].vote, kNone}}));
  }
  RC_ASSERT(taken == (all_fail ? 0u : 1u));
  RC_ASSERT((answer.status == kFailure) == all_fail);
}

RC_GTEST_PROP(RandomSelectorLaw, TheSameStepDrawsTheSame, ()) {
  const Cues cues = *any_cues();
  const auto step = *rc::gen::arbitrary<std::uint32_t>();
  Robot one(make<Shuffled>(probes(cues.size()))), other(make<Shuffled>(probes(cues.size())));
  one.step = other.step = step;
  RC_ASSERT(ask(one, cues) == ask(other, cues));
}

}  // namespace
}  // namespace eyrie::ubf::testing
