// SPDX-License-Identifier: MIT
#include "ubf/arbiter/weighted_random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Random = WeightedRandom<State, Action>;

/// Child i proposes altitude i, so that the result tells who was chosen.
Robot robot_voting(std::vector<float> votes, double keep = 0) {
  auto node = make<Random>(probes(votes.size()));
  node->keep = keep;
  Robot robot(std::move(node));
  for (std::size_t i = 0; i < votes.size(); ++i)
    robot.cue(i) = {kRunning, votes[i], {.altitude = static_cast<double>(i)}};
  return robot;
}

TEST(WeightedRandom, DrawsWithTheProbabilityOfTheVotes) {
  Robot robot = robot_voting({1, 0, 2, 5});
  std::array<int, 4> drawn{};
  constexpr int kDraws = 8000;
  for (int i = 0; i < kDraws; ++i) {
    robot.tick();
    ++drawn[static_cast<std::size_t>(robot.out.action.altitude.value())];
  }
  // four standard deviations of a binomial count are 177 at most
  EXPECT_NEAR(drawn[0], kDraws / 8, 180);
  EXPECT_EQ(drawn[1], 0) << "who abstains is not in the draw";
  EXPECT_NEAR(drawn[2], kDraws / 4, 180);
  EXPECT_NEAR(drawn[3], kDraws * 5 / 8, 180);
}

TEST(WeightedRandom, KeepsADrawForItsTime) {
  Robot robot = robot_voting({1, 1, 1, 1, 1, 1}, 1);
  std::vector<double> draws;
  for (int i = 0; i < 1000; ++i) {
    robot.tick_at(0.1 * i);
    const double now = robot.out.action.altitude.value();
    if (i % 10 == 0)
      draws.push_back(now);
    ASSERT_EQ(now, draws.back()) << "tick " << i;
  }
  for (const double child : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0})
    EXPECT_NE(std::count(draws.begin(), draws.end(), child), 0) << child;
}

TEST(WeightedRandom, DrawsAnewWhenTheChosenChildFallsSilent) {
  Robot robot = robot_voting({1, 1}, 100);
  robot.tick();
  const auto chosen = static_cast<std::size_t>(robot.out.action.altitude.value());
  robot.say(chosen, kFailure);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1 - static_cast<double>(chosen));
  robot.say(chosen, kRunning, 1000);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1 - static_cast<double>(chosen)) << "that draw stands now";
}

TEST(WeightedRandom, FailsIfEveryoneFailsOrAbstains) {
  Robot robot = robot_voting({0, 3});
  robot.say(1, kFailure, 3);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

RC_GTEST_PROP(WeightedRandomLaw, IsOneOfThoseThatAreHeardUnchanged, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask<Random>(cues);
  const bool somebody = strongest(cues) != cues.size();
  bool found = false;
  for (const Cue& cue : cues)
    found |= is_heard(cue) && answer == Answer{cue.status, {cue.action, cue.vote, kNone}};
  RC_ASSERT(found == somebody);
  RC_ASSERT(somebody || answer == Answer{});
}

RC_GTEST_PROP(WeightedRandomLaw, SilenceAndACommonFactorChangeNothing, ()) {
  const Cues cues = *any_cues();
  Cues heard;
  std::copy_if(cues.begin(), cues.end(), std::back_inserter(heard), is_heard);
  RC_PRE(!heard.empty());
  const Answer answer = ask<Random>(cues);
  RC_ASSERT(ask<Random>(heard) == answer);
  Answer louder = ask<Random>(scaled(cues, 4));
  louder.proposal.vote /= 4;
  RC_ASSERT(louder == answer);
}

RC_GTEST_PROP(WeightedRandomLaw, TheSameStepDrawsTheSame, ()) {
  const Cues cues = *any_cues();
  const auto step = *rc::gen::arbitrary<std::uint32_t>();
  Robot one(make<Random>(probes(cues.size()))), other(make<Random>(probes(cues.size())));
  one.step = other.step = step;
  RC_ASSERT(ask(one, cues) == ask(other, cues));
}

}  // namespace
}  // namespace eyrie::ubf::testing
