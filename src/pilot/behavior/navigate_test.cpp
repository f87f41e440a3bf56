// SPDX-License-Identifier: MIT
#include "pilot/behavior/navigate.hpp"

#include <gtest/gtest.h>

#include "pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(Navigate, FliesToTheWaypointOfTheLeg) {
  Desk desk;
  desk.own = model::test::flying({0, -20e3, -8000}, 2, 250);  // the first waypoint is north-east
  const Decided d = decide("{navigate: {vote: 10, speed: 240 m/s}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().heading, kPi / 4, 1e-9);
  EXPECT_EQ(d.action().altitude, 7000);
  EXPECT_EQ(d.action().speed, 240);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::route);
  EXPECT_EQ(d.proposal.vote, 10);
}

TEST(Navigate, GoesOnFromTheLegThatTheAutopilotHasReached) {
  Desk desk;
  desk.own = model::test::flying({30e3, 20e3, -8000}, 0, 250);
  const double first = *decide("navigate", desk).action().heading;
  desk.flying.nav.leg = 1;
  const double second = *decide("navigate", desk).action().heading;
  EXPECT_GT(angle_between(0, first), -kPi);
  EXPECT_LT(angle_between(0, first), -kPi / 2);   // back to the first waypoint
  EXPECT_GT(angle_between(0, second), -kPi / 2);  // on to the second one, and to the leg
  EXPECT_LT(angle_between(0, second), 0);
}

TEST(Navigate, SucceedsPastTheLastWaypointAndKeepsFlying) {
  Desk desk;
  desk.flying.nav.leg = 2;
  const Decided d = decide("navigate", desk);
  EXPECT_EQ(d.status, kSuccess);
  EXPECT_TRUE(d.action().heading.has_value());
}

TEST(Navigate, FailsWithoutARoute) {
  Desk desk;
  desk.fit.flight = 1;
  EXPECT_EQ(decide("navigate", desk).status, kFailure);
  desk.fit.flight = 0;
  EXPECT_EQ(decide("{navigate: {route: 1}}", desk).status, kFailure);
}

TEST(Navigate, StartsAnotherRouteAtItsBeginning) {
  Desk desk;
  desk.flying.nav = {.leg = 2, .route = 1};
  EXPECT_EQ(decide("navigate", desk).status, kRunning);
}

}  // namespace
}  // namespace eyrie::pilot
