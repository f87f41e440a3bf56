// SPDX-License-Identifier: MIT
#include "pilot/behavior/avoid_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

Desk at(double altitude, double pitch = 0, double speed = 250) {
  Desk desk;
  desk.own = model::test::flying({0, 0, -altitude}, 1.25, speed, pitch);
  return desk;
}

TEST(AvoidGround, FailsHighAndLevel) {
  EXPECT_EQ(decide("{avoid_ground: {floor: 500 m}}", at(501)).status, kFailure);
}

TEST(AvoidGround, PullsUpWingsLevelBelowTheFloor) {
  const Decided d = decide("{avoid_ground: {vote: 100, floor: 500 m, pull: 5}}", at(499));
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().heading, 1.25, 1e-12);
  EXPECT_GT(*d.action().altitude, 600);
  EXPECT_EQ(d.action().load_factor, 5);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::hold);
  EXPECT_EQ(d.proposal.vote, 100);
}

TEST(AvoidGround, AllowsForTheWarningTimeAndThePullOut) {
  // 30 deg down at 200 m/s: sinks 100 m/s; the arc at 5 g costs 200^2 (1 - cos 30 deg) / 4 g
  const double arc = 200.0 * 200.0 * (1 - std::sqrt(0.75)) / (4 * 9.80665);
  const double limit = 500 + 3 * 100 + arc;
  const std::string tree = "{avoid_ground: {floor: 500 m, warning_time: 3 s, pull: 5}}";
  EXPECT_EQ(decide(tree, at(limit + 1, -kPi / 6, 200)).status, kFailure);
  EXPECT_EQ(decide(tree, at(limit - 1, -kPi / 6, 200)).status, kRunning);
}

TEST(AvoidGround, LetsGoWhileClimbingAboveTheFloor) {
  EXPECT_EQ(decide("{avoid_ground: {floor: 500 m}}", at(510, 0.5)).status, kFailure);
}

}  // namespace
}  // namespace eyrie::pilot
