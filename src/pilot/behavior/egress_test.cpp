// SPDX-License-Identifier: MIT
#include "pilot/behavior/egress.hpp"

#include <gtest/gtest.h>

#include "pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

/// `miles` east of home.
Desk from_home(double miles, double altitude = 8000) {
  Desk desk;
  const Vec3 home = *library().flights[0].home;
  desk.own = model::test::flying({home.x, miles * kNmi, -altitude}, 0, 250);
  return desk;
}

TEST(Egress, GoesStraightHome) {
  const Decided d =
      decide("{egress: {vote: 30, speed: 240 m/s, altitude: 7500 m}}", from_home(100));
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().heading, 3 * kPi / 2, 1e-9);
  EXPECT_EQ(*d.action().altitude, 7500);
  EXPECT_EQ(*d.action().speed, 240);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::hold);
  EXPECT_EQ(d.action().call, std::nullopt);
  EXPECT_EQ(d.action().target, TrackId{});  // attacks nobody
  EXPECT_EQ(d.proposal.vote, 30);
}

TEST(Egress, ComesDownOnTheWay) {
  double last = 1e9;
  for (const double miles : {60.0, 25.0, 15.0, 8.0, 3.0}) {
    const double altitude = *decide("egress", from_home(miles)).action().altitude;
    EXPECT_LE(altitude, last) << miles;
    last = altitude;
  }
  EXPECT_NEAR(last, si(5000, "ft"), 1);
}

TEST(Egress, LandsWhenItIsHomeAndLow) {
  const std::string tree = "{egress: {arrival: 4 nmi, landing_altitude: 1500 m}}";
  EXPECT_EQ(decide(tree, from_home(3.9, 1500)).action().call, Call::land);
  EXPECT_EQ(decide(tree, from_home(3.9, 1500)).status, kSuccess);
  EXPECT_EQ(decide(tree, from_home(4.1, 1500)).action().call, std::nullopt);
  EXPECT_EQ(decide(tree, from_home(3.9, 3000)).action().call, std::nullopt);
}

TEST(Egress, CirclesOverHomeWhileItIsTooHigh) {
  const Decided d = decide("egress", from_home(2, 12'000));
  EXPECT_EQ(d.action().mode, model::AutopilotMode::loiter);
  ASSERT_TRUE(d.action().follow.has_value());
  EXPECT_EQ(d.action().follow->position, *library().flights[0].home);
}

TEST(Egress, FailsWithoutAHome) {
  Desk desk;
  desk.fit.flight = 1;
  EXPECT_EQ(decide("egress", desk).status, kFailure);
}

TEST(Egress, FliesTheRouteHomeFirst) {
  Desk desk = from_home(60);
  const Decided d = decide("{egress: {route: 0}}", desk);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::route);
  desk.flying.nav.leg = 2;  // flown
  EXPECT_EQ(decide("{egress: {route: 0}}", desk).action().mode, model::AutopilotMode::hold);
}

}  // namespace
}  // namespace eyrie::pilot
