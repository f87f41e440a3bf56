// SPDX-License-Identifier: MIT
#include "ubf/arbiter/verify.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"
#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

using Verified = Verify<State, Action>;

/// Altitudes from 100 m to 1000 m pass. The fallback is one more probe behind those checked.
Child verify(std::size_t checked, bool fallback = true) {
  auto node = make<Verified>(probes(checked + fallback));
  node->fallback = fallback;
  EXPECT_EQ(node->bounds.set("altitude", 100, 1000), "");
  return node;
}

TEST(Verify, TakesTheNextBestWhenTheBestIsOutOfBounds) {
  Robot robot(verify(3));
  robot.cue(0) = {kRunning, 9, {.altitude = 99}};
  robot.cue(1) = {kRunning, 5, {.altitude = 100}};
  robot.cue(2) = {kSuccess, 7, {.altitude = 1000, .release = 1}};
  robot.cue(3) = {kRunning, 99, {.altitude = 500}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.altitude = 1000, .release = 1}));
  EXPECT_EQ(robot.out.vote, 7);
  EXPECT_EQ(robot.supplier(1), "root/probe[2]");
}

TEST(Verify, TellsWhoeverTracesWhyItRefused) {
  auto tree = build(
      "{verify: {bounds: {altitude: {min: 100 m}}, refuse: [action.release == 7], fallback: true, "
      "children: [{probe: {cue: 0}}, {probe: {cue: 1}}, {probe: {cue: 2}}, {probe: {cue: 3}}]}}");
  Robot robot(std::move(tree));
  robot.cue(0) = {kRunning, 9, {.altitude = 99}};
  robot.cue(1) = {kRunning, 8, {.release = 7}};
  robot.cue(2) = {kRunning, 7, {.altitude = 200}};
  robot.cue(3) = {kRunning, 99, {.altitude = 1}};
  robot.tick();
  const auto why = [&](NodeIndex child) {
    const char* words = robot.trace.why(child);
    return std::string(words ? words : "");
  };
  EXPECT_EQ(why(1), "refused: altitude is out of bounds");
  EXPECT_EQ(why(2), "refused: action.release == 7");
  EXPECT_EQ(why(3), "");
  EXPECT_EQ(why(4), "");
}

TEST(Verify, FallsBackUncheckedWhenNobodyPassesOrSpeaks) {
  Robot robot(verify(2));
  robot.cue(0) = {kRunning, 9, {.altitude = 99}};
  robot.cue(1) = {kRunning, 5, {.altitude = 1001}};
  robot.cue(2) = {kSuccess, 2, {.altitude = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.altitude, 1);
  EXPECT_EQ(robot.out.vote, 2);
  robot.say(0, kFailure, 9);
  robot.say(1, kRunning, 0);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Verify, FailsWithoutAFallbackWhenNobodyPasses) {
  Robot robot(verify(1, false));
  robot.cue(0) = {kRunning, 9, {.altitude = 99}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Verify, LetsEveryDirectionPassWithinAWholeCircle) {
  for (const double least : {0.0, -kPi, 1.0}) {
    auto node = make<Verified>(probes(1));
    EXPECT_EQ(node->bounds.set("heading", least, least + kTau), "");
    Robot robot(std::move(node));
    for (const double heading : {0.0, 1.5, 3.2, 6.2, -2.0}) {
      robot.cue(0) = {kRunning, 9, {.heading = heading}};
      EXPECT_EQ(robot.tick(), kRunning) << heading;
    }
  }
  Robot file(
      build("{verify: {bounds: {heading: {min: 0 deg, max: 360 deg}}, children: "
            "[{probe: {cue: 0}}]}}"));
  file.cue(0) = {kRunning, 9, {.heading = radians(90)}};
  EXPECT_EQ(file.tick(), kRunning);
}

TEST(Verify, LetsAFieldPassThatIsNotSet) {
  Robot robot(verify(1));
  robot.cue(0) = {kRunning, 9, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
}

TEST(Bounds, OfADirectionAreAnArcClockwise) {
  Bounds<Action> bounds;
  EXPECT_EQ(bounds.set("heading", radians(350), radians(20)), "");
  for (const double deg : {350.0, 359.0, 0.0, 10.0, 370.0, 20.0})
    EXPECT_TRUE(bounds.hold({.heading = radians(deg)})) << deg;
  for (const double deg : {349.0, 21.0, 180.0})
    EXPECT_FALSE(bounds.hold({.heading = radians(deg)})) << deg;
}

TEST(Bounds, OfAnArcIncludeItsEndsHoweverTheyAreWritten) {
  for (int min = -360; min < 360; min += 10) {
    Bounds<Action> bounds;
    ASSERT_EQ(bounds.set("heading", radians(min), radians(min + 20)), "");
    for (const int turns : {-360, 0, 360})
      for (const int inside : {0, 10, 20})
        EXPECT_TRUE(bounds.hold({.heading = radians(min + inside + turns)})) << min << inside;
  }
}

TEST(Bounds, LetNoNanPass) {
  Bounds<Action> bounds;
  bounds.set("altitude", 100, std::nullopt);
  bounds.set("heading", 0, 1);
  EXPECT_FALSE(bounds.hold({.altitude = std::nan("")}));
  EXPECT_FALSE(bounds.hold({.heading = std::nan("")}));
}

TEST(Bounds, SayWhatIsWrongWithThem) {
  Bounds<Action> bounds;
  EXPECT_EQ(bounds.set("altitud", 1, 2),
            "an action has no field 'altitud'; did you mean 'altitude'?");
  EXPECT_EQ(bounds.set("altitude", 2, 1), "'altitude': 'min' is greater than 'max'");
  EXPECT_EQ(bounds.set("altitude", {}, {}), "'altitude' needs a 'min' or a 'max'");
  EXPECT_EQ(bounds.set("heading", 1, {}),
            "'heading' is a direction and needs both 'min' and 'max'");
  EXPECT_TRUE(bounds.empty());
}

TEST(Verify, IsReadFromAFileWithUnits) {
  EXPECT_EQ(mistakes("{verify: {bounds: {altitude: {min: 1000 ft}, heading: {min: 0 deg, max: 90 "
                     "deg}}, fallback: true, children: [{probe: {cue: 0}}, {probe: {cue: 1}}]}}"),
            "");
  const RobotTree tree =
      build("{verify: {bounds: {altitude: {min: 1 km}}, children: [{probe: {cue: 0}}]}}");
  const auto& bounds = dynamic_cast<const Verified&>(tree.root()).bounds;
  EXPECT_TRUE(bounds.hold({.altitude = 1000}));
  EXPECT_FALSE(bounds.hold({.altitude = 999}));
}

TEST(Verify, RefusesWhatAConditionInWordsSaysOfStateAndProposal) {
  Robot robot(
      build("{verify: {refuse: [action.release == 7 and not alarm, action.altitude < 500 m], "
            "children: [{probe: {cue: 0}}, {probe: {cue: 1}}]}}"));
  robot.cue(0) = {kRunning, 9, {.altitude = 600, .release = 7}};
  robot.cue(1) = {kRunning, 1, {.heading = 1}};
  const auto vote = [&] {
    robot.tick();
    return robot.out.vote;
  };
  EXPECT_EQ(vote(), 1) << "a release without alarm";
  robot.state.alarm = true;
  EXPECT_EQ(vote(), 9);
  robot.state.cues[0].action.altitude = 499;
  EXPECT_EQ(vote(), 1);
  robot.state.cues[0].action.altitude = {};
  EXPECT_EQ(vote(), 9) << "a field that is not set passes";
}

TEST(Verify, ReadsDirectionsOfAProposalAsThoseOfAState) {
  Robot robot(
      build("{verify: {refuse: [action.heading < -45 deg], children: [{probe: {cue: 0}}]}}"));
  const auto passes = [&](double heading) {
    robot.cue(0) = {kRunning, 9, {.heading = radians(heading)}};
    return robot.tick() == kRunning;
  };
  EXPECT_FALSE(passes(270)) << "-90 deg";
  EXPECT_FALSE(passes(-90));
  EXPECT_TRUE(passes(180));
  EXPECT_TRUE(passes(350));
}

TEST(Verify, TellsEveryMistakeInAFile) {
  const auto has = [](std::string_view text, std::string_view words) {
    const std::string said = mistakes(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  has("{verify: {children: [{probe: {cue: 0}}]}}", "verify needs 'bounds' or 'refuse' to check");
  has("{verify: {refuse: [action.altitud < 1 m], children: [{probe: {cue: 0}}]}}",
      "test.yaml:1:20: there is no state field 'action.altitud'; did you mean 'action.altitude'?");
  has("{verify: {refuse: [action.heading > 270 deg], children: [{probe: {cue: 0}}]}}",
      "'action.heading' is from -180 deg to 180 deg, never 270 deg: that is -90 deg");
  has("{verify: {bounds: {}, children: [{probe: {cue: 0}}]}}",
      "verify needs 'bounds' or 'refuse' to check");
  has("{verify: {bounds: {altitude: {min: 1 m}}, fallback: true, children: [{probe: {cue: 0}}]}}",
      "verify needs a child to check before the fallback");
  has("{verify: {bounds: 3, children: [{probe: {cue: 0}}]}}",
      "bounds: expected a map from fields to limits");
  has("{verify: {bounds: {speedd: {min: 1 m/s}}, children: [{probe: {cue: 0}}]}}",
      "did you mean 'speed'?");
  has("{verify: {bounds: {altitude: {min: 3}}, children: [{probe: {cue: 0}}]}}", "unit");
}

RC_GTEST_PROP(VerifyLaw, IsWinnerTakesAllOfThoseThatPass, ()) {
  Cues cues = *any_cues();
  Robot robot(verify(cues.size(), false));
  const Answer answer = ask(robot, cues);
  for (Cue& cue : cues)
    if (cue.action.altitude && !(*cue.action.altitude >= 100 && *cue.action.altitude <= 1000))
      cue.status = kFailure;
  RC_ASSERT(answer == (ask<WinnerTakesAll<State, Action>>(cues)));
}

RC_GTEST_PROP(VerifyLaw, NothingOutOfBoundsGoesUpExceptTheFallback, ()) {
  const Cues cues = *any_cues();
  RC_PRE(cues.size() > 1);
  Robot robot(verify(cues.size() - 1));
  const Answer answer = ask(robot, cues);
  const Cue& last = cues.back();
  const auto altitude = answer.proposal.action.altitude;
  const bool passes = !altitude || (*altitude >= 100 && *altitude <= 1000);
  RC_ASSERT(passes ||
            (is_heard(last) && answer == Answer{last.status, {last.action, last.vote, kNone}}));
}

}  // namespace
}  // namespace eyrie::ubf::testing
