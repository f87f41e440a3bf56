// SPDX-License-Identifier: MIT
/// \file  Fusion of some of the proposals, or of some of the fields.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"
#include "ubf/arbiter/fusion.hpp"

namespace eyrie::ubf::testing {
namespace {

using Fuse = Fusion<State, Action>;

Child fusion(std::size_t children, std::optional<std::uint32_t> top,
             Conflicts conflicts = Conflicts::blend) {
  auto node = make<Fuse>(probes(children));
  node->top = top;
  node->conflicts = conflicts;
  return node;
}

Answer ask_fusion(const Cues& cues, std::optional<std::uint32_t> top,
                  Conflicts conflicts = Conflicts::blend) {
  Robot robot(fusion(cues.size(), top, conflicts));
  return ask(robot, cues);
}

TEST(FusionOptions, BlendOnlyTheStrongest) {
  Robot robot(fusion(4, 2));
  robot.cue(0) = {kSuccess, 3, {.altitude = 1000}};
  robot.cue(1) = {kRunning, 1, {.altitude = 9000, .speed = 5}};
  robot.cue(2) = {kFailure, 9, {.altitude = 5000}};
  robot.cue(3) = {kRunning, 5, {.altitude = 2000}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_DOUBLE_EQ(robot.out.action.altitude.value(), 1625);
  EXPECT_EQ(robot.out.action.speed, std::nullopt);
  EXPECT_EQ(robot.supplier(1), "root");
}

TEST(FusionOptions, PreferTheEarlierOfEqualsAmongTheStrongest) {
  Robot robot(fusion(3, 2));
  for (std::size_t i = 0; i < 3; ++i)
    robot.cue(i) = {kRunning, 2, {.altitude = 300.0 * static_cast<double>(i)}};
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.out.action.altitude.value(), 150);
}

TEST(FusionOptions, TraceAFieldThatOnlyOneOfTheStrongestSetAsIts) {
  Robot robot(fusion(3, 2));
  robot.cue(0) = {kRunning, 1, {.altitude = 10}};
  robot.cue(1) = {kRunning, 2, {.altitude = 20}};
  robot.cue(2) = {kRunning, 3, {.heading = 1}};
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 20);
  EXPECT_EQ(robot.supplier(1), "root/probe[1]");
}

TEST(FusionOptions, DropFieldsInDispute) {
  Robot robot(fusion(3, std::nullopt, Conflicts::drop));
  robot.cue(0) = {kRunning, 3, {.heading = 1, .altitude = 10, .release = 4}};
  robot.cue(1) = {kRunning, 2, {.altitude = 20, .release = 4}};
  robot.cue(2) = {kFailure, 9, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1, .release = 4}));
}

RC_GTEST_PROP(FusionOptionsLaw, TopOneIsWinnerTakesAll, ()) {
  const Cues cues = *any_cues();
  RC_ASSERT(ask_fusion(cues, 1) == (ask<WinnerTakesAll<State, Action>>(cues)));
}

RC_GTEST_PROP(FusionOptionsLaw, TopOfAtLeastAllIsPlainFusion, ()) {
  const Cues cues = *any_cues();
  const auto top = static_cast<std::uint32_t>(cues.size());
  RC_ASSERT(ask_fusion(cues, top) == ask<Fuse>(cues));
  RC_ASSERT(ask_fusion(cues, top, Conflicts::drop) ==
            ask_fusion(cues, std::nullopt, Conflicts::drop));
}

RC_GTEST_PROP(FusionOptionsLaw, TopIsFusionOfThoseThatAreLeft, ()) {
  Cues cues = *any_cues();
  const std::uint32_t top = *rc::gen::inRange(1u, 6u);
  const Answer answer = ask_fusion(cues, top);
  Cues rest = cues, few(cues.size());
  for (std::uint32_t i = 0; i < top; ++i)
    if (const std::size_t best = strongest(rest); best != rest.size()) {
      few[best] = rest[best];
      rest[best].status = kFailure;
    }
  RC_ASSERT(answer == ask<Fuse>(few));
}

RC_GTEST_PROP(FusionOptionsLaw, DroppingKeepsExactlyWhatNobodyDisputes, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask_fusion(cues, std::nullopt, Conflicts::drop);
  for_each_field<Action>([&](const auto& f, auto) {
    const Cue* first = nullptr;
    bool disputed = false;
    for (const Cue& cue : cues) {
      if (!is_heard(cue) || !(cue.action.*f.member))
        continue;
      first = first ? first : &cue;
      disputed |= cue.action.*f.member != first->action.*f.member;
    }
    const auto& value = answer.proposal.action.*f.member;
    if (!first || disputed)
      RC_ASSERT(!value);
    else
      RC_ASSERT((value == first->action.*f.member));
  });
}

}  // namespace
}  // namespace eyrie::ubf::testing
