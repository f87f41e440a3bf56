// SPDX-License-Identifier: MIT
#include "ubf/arbiter/grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"
#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

using Schema = MotorSchema<State, Action>;

constexpr double kRounding = 1e-5;  // a speed is a float

Child schema(std::size_t children, double unit_vote = 1) {
  auto node = make<Schema>(probes(children));
  EXPECT_TRUE(node->direction.choose("heading"));
  EXPECT_TRUE(node->magnitude.choose("speed"));
  node->unit_vote = unit_vote;
  return node;
}

Answer ask_schema(const Cues& cues, double unit_vote = 1) {
  Robot robot(schema(cues.size(), unit_vote));
  return ask(robot, cues);
}

/// Cues with a vector of 50 m/s and more each, or with none.
Cues any_vectors() {
  Cues cues = *any_cues_with_a_heading();
  cues.front().action.speed = 50.0F;
  for (Cue& cue : cues)
    if (!cue.action.heading || !cue.action.speed)
      cue.action = {};
  return cues;
}

TEST(MotorSchema, AddsUpVectors) {
  Robot robot(schema(2, 2));
  robot.cue(0) = {kRunning, 2, {.heading = 0, .speed = 30.0F}};
  robot.cue(1) = {kSuccess, 1, {.heading = radians(90), .speed = 80.0F}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 2);
  EXPECT_NEAR(robot.out.action.speed.value(), 50, kRounding);  // 3, 4, 5
  EXPECT_NEAR(robot.out.action.heading.value(), std::atan2(40, 30), 1e-12);
  EXPECT_EQ(robot.supplier(0), "root");
  EXPECT_EQ(robot.supplier(2), "root");
}

TEST(MotorSchema, IsNeverLongerThanTheLongestVector) {
  Robot robot(schema(2));
  robot.cue(0) = {kRunning, 3, {.heading = 1, .speed = 100.0F}};
  robot.cue(1) = {kRunning, 5, {.heading = 1, .speed = 60.0F}};
  robot.tick();
  EXPECT_NEAR(robot.out.action.speed.value(), 100, kRounding);
}

TEST(MotorSchema, StopsWhereVectorsCancel) {
  Robot robot(schema(2));
  robot.cue(0) = {kRunning, 2, {.heading = radians(90), .speed = 50.0F}};
  robot.cue(1) = {kRunning, 1, {.heading = radians(270), .speed = 100.0F}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.speed, 0.0F);
  EXPECT_EQ(robot.out.action.heading, std::nullopt);
}

TEST(MotorSchema, TakesTheOtherFieldsFromTheHighestVote) {
  Robot robot(schema(3));
  robot.cue(0) = {kRunning, 2, {.heading = 1, .altitude = 5, .release = 1}};
  robot.cue(1) = {kRunning, 1, {.heading = 2, .speed = 10.0F}};
  robot.cue(2) = {kRunning, 3, {.altitude = 7}};
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 7);
  EXPECT_EQ(robot.out.action.release, 1u);
  EXPECT_NEAR(robot.out.action.heading.value(), 2, 1e-12) << "a heading alone is no vector";
  EXPECT_EQ(robot.supplier(1), "root/probe[2]");
  EXPECT_EQ(robot.supplier(3), "root/probe[0]");
}

TEST(MotorSchema, IsReadFromAFileAndRefusesFieldsThatMakeNoVector) {
  const auto said = [](const std::string& fields) {
    return mistakes("{motor_schema: {" + fields +
                    ", unit_vote: 10, children: [{probe: {cue: 0}}]}}");
  };
  EXPECT_EQ(said("direction: heading, magnitude: speed"), "");
  EXPECT_NE(said("direction: headin, magnitude: speed").find("did you mean 'heading'?"),
            std::string::npos);
  EXPECT_NE(said("direction: heading, magnitude: release").find("is no field"), std::string::npos);
  EXPECT_NE(said("direction: heading").find("magnitude"), std::string::npos);
}

RC_GTEST_PROP(MotorSchemaLaw, VoteAndStatusAreTheStrongestsAndSilenceChangesNothing, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask_schema(cues);
  const std::size_t best = strongest(cues);
  if (best == cues.size()) {
    RC_ASSERT(answer == Answer{});
    return;
  }
  RC_ASSERT(answer.status == cues[best].status);
  RC_ASSERT(answer.proposal.vote == cues[best].vote);
  Cues heard;
  std::copy_if(cues.begin(), cues.end(), std::back_inserter(heard), is_heard);
  RC_ASSERT(ask_schema(heard) == answer);
  Answer louder = ask_schema(scaled(cues, 4), 4);
  louder.proposal.vote /= 4;
  RC_ASSERT(louder == answer);
}

RC_GTEST_PROP(MotorSchemaLaw, TurningEveryVectorTurnsTheSum, ()) {
  Cues cues = any_vectors();
  const Action before = ask_schema(cues).proposal.action;
  RC_PRE(before.heading && *before.speed > 1);
  const double turn = *any_heading();
  for (Cue& cue : cues)
    if (cue.action.heading)
      cue.action.heading = wrap_tau(*cue.action.heading + turn);
  const Action after = ask_schema(cues).proposal.action;
  RC_ASSERT(std::fabs(angle_between(*before.heading + turn, *after.heading)) <= 1e-9);
  RC_ASSERT(std::fabs(*before.speed - *after.speed) <= 1e-3F);
}

RC_GTEST_PROP(MotorSchemaLaw, AVectorAndItsOppositeAddNothing, ()) {
  Cues cues = any_vectors();
  for (Cue& cue : cues)
    cue.vote /= 64;  // so that the limit is not reached
  const Action before = ask_schema(cues).proposal.action;
  const double heading = *any_heading();
  cues.push_back({kRunning, 1, {.heading = heading, .speed = 50.0F}});
  cues.push_back({kRunning, 1, {.heading = wrap_tau(heading + kPi), .speed = 50.0F}});
  const Action after = ask_schema(cues).proposal.action;
  RC_ASSERT(std::fabs(*before.speed - *after.speed) <= 1e-3F);
  if (*before.speed > 1)
    RC_ASSERT(std::fabs(angle_between(*before.heading, *after.heading)) <= 1e-9);
}

RC_GTEST_PROP(MotorSchemaLaw, IsNeverLongerThanWhatWasAskedFor, ()) {
  const Cues cues = any_vectors();
  float longest = 0;
  for (const Cue& cue : cues)
    if (is_heard(cue) && cue.action.speed)
      longest = std::max(longest, *cue.action.speed);
  RC_ASSERT(*ask_schema(cues).proposal.action.speed <= longest);
}

}  // namespace
}  // namespace eyrie::ubf::testing
