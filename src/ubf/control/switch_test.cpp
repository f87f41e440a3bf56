// SPDX-License-Identifier: MIT
#include "ubf/control/branch.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

/// Children for phases 0 and 1, and with `has_default` one for the rest.
Robot by_phase(bool has_default) {
  auto node = make<Switch<State, Action>>(probes(has_default ? 3 : 2));
  node->look_at([](const State& s) { return static_cast<double>(s.phase); }, {0, 1});
  return Robot(std::move(node));
}

TEST(Switch, AsksTheChildOfTheValueAndHandsItsProposalOn) {
  Robot robot = by_phase(true);
  for (std::uint8_t phase = 0; phase < 3; ++phase) {
    robot.state.phase = phase;
    robot.cue(phase) = {kSuccess, static_cast<float>(phase + 1), {.heading = phase}};
    EXPECT_EQ(robot.tick(), kSuccess);
    EXPECT_EQ(robot.out.vote, phase + 1);
    EXPECT_EQ(robot.leader(), fmt::format("root/probe[{}]", phase));
    for (int other = 0; other < 3; ++other)
      EXPECT_EQ(robot.asked_now(fmt::format("root/probe[{}]", other)), other == phase);
  }
}

TEST(Switch, FailsWithoutAChildForTheValueAndWithoutAValue) {
  Robot robot = by_phase(false);
  robot.state.phase = 2;
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty() || robot.status == kFailure);
  auto node = make<Switch<State, Action>>(probes(2));
  node->look_at([](const State&) { return kNoValue; }, {0});
  Robot unknown(std::move(node));
  unknown.say(1, kRunning, 1);
  EXPECT_EQ(unknown.tick(), kRunning) << "the default";
}

TEST(Switch, MakesTheChildItTurnsAwayFromForgetOnce) {
  Robot robot = by_phase(false);
  robot.say(0, kRunning, 1);
  robot.say(1, kRunning, 1);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[0]"), 2u);
  robot.state.phase = 1;
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
  EXPECT_EQ(robot.asked("root/probe[0]"), 0u);
  robot.state.phase = 2;
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/probe[0]"), 0);
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
}

TEST(Switch, IsReadWithItsCases) {
  Robot robot(
      build("{switch: {on: phase, cases: {fetch: {probe: {cue: 1}}, home: {probe: {cue: 2}}}, "
            "default: {probe: {cue: 3}}, vote_scale: 2}}"));
  const auto vote = [&](std::uint8_t phase) {
    for (std::size_t i = 1; i < 4; ++i)
      robot.say(i, kRunning, static_cast<float>(i));
    robot.state.phase = phase;
    robot.tick();
    return robot.out.vote;
  };
  EXPECT_EQ(vote(0), 6);
  EXPECT_EQ(vote(1), 2);
  EXPECT_EQ(vote(2), 4);
}

TEST(Switch, MistakesAreSaid) {
  EXPECT_EQ(mistakes("{switch: {on: phas, cases: {home: {probe: {cue: 1}}}}}"),
            "test.yaml:1:15: there is no state field 'phas'; did you mean 'phase'?");
  EXPECT_EQ(mistakes("{switch: {on: phase, cases: {hom: {probe: {cue: 1}}}}}"),
            "test.yaml:1:30: 'phase' is never 'hom'; did you mean 'home'?");
  EXPECT_EQ(mistakes("{switch: {on: alarm, cases: {yes: {probe: {cue: 1}}}}}"),
            "test.yaml:1:30: 'alarm' is never 'yes'");
  EXPECT_EQ(mistakes("{switch: {on: count, cases: {1: {probe: {cue: 1}}, 1.0: {probe: "
                     "{cue: 1}}}}}"),
            "test.yaml:1:52: there are two cases '1.0'");
  EXPECT_EQ(mistakes("{switch: {on: phase}}"),
            "test.yaml:1:2: switch needs 'cases', a map from values to nodes");
}

}  // namespace
}  // namespace eyrie::ubf::testing
