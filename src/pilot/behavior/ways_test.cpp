// SPDX-License-Identifier: MIT
#include "pilot/behavior/ways.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/pilot/testing.hpp"

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

using namespace pilot::testing;

constexpr double kFoot = si(1, "ft");

/// The rank-th of four.
Desk wingman(std::uint32_t rank) {
  Desk desk;
  desk.in_flight(4, rank);
  return desk;
}
Vec3 place(const Desk& desk) {
  return decide("follow_lead", desk).action().follow->offset;
}

TEST(FollowLead, PutsTheSecondWhereThePaperHasIt) {
  const Vec3 offset = place(wingman(2));
  EXPECT_NEAR(offset.x, -1000 * kFoot, 1e-9);
  EXPECT_NEAR(offset.y, -6000 * kFoot, 1e-9);  // left
  EXPECT_NEAR(offset.z, 500 * kFoot, 1e-9);    // below
}

TEST(FollowLead, FollowsWhereTheLeadIsNow) {
  Desk desk = wingman(2);
  desk.datalink.members[0].time -= 2;
  const Decided d = decide("{follow_lead: {vote: 20}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::follow);
  EXPECT_NEAR(d.action().follow->position.x, desk.datalink.members[0].position.x + 2 * 250, 1e-6);
  EXPECT_EQ(d.action().follow->time, desk.time);
  EXPECT_NEAR(*d.action().altitude, 8000 - 500 * kFoot, 1);
  EXPECT_EQ(d.proposal.vote, 20);
}

TEST(FollowLead, FailsForTheLead) {
  EXPECT_EQ(decide("follow_lead", wingman(1)).status, kFailure);
}

TEST(FollowLead, FailsUntilTheLeadHasBeenHeardOf) {
  Desk desk = wingman(2);
  desk.datalink.members[0].reported = 0;
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, FailsWithoutADatalink) {
  Desk desk;
  desk.fit.rank = 2;
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, FollowsTheSecondWhenTheLeadIsLost) {
  Desk desk = wingman(3);
  desk.lose(1);
  const Decided d = decide("follow_lead", desk);
  EXPECT_NEAR(d.action().follow->position.y, desk.datalink.members[1].position.y, 1e-6);
}

TEST(FollowLead, LeadsItselfWhenAllBeforeItAreLost) {
  Desk desk = wingman(3);
  desk.lose(1);
  desk.lose(2);
  EXPECT_TRUE(desk.state().leads());
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, ClosesUp) {
  const Vec3 third = place(wingman(3));
  for (const std::uint32_t dead : {1U, 2U, 3U}) {
    Desk desk = wingman(4);
    desk.lose(dead);
    EXPECT_EQ(place(desk), third) << dead;
  }
}

TEST(FollowLead, DoesNotMoveWhenSomebodyBehindIsLost) {
  Desk desk = wingman(2);
  const Vec3 before = place(desk);
  desk.lose(4);
  EXPECT_EQ(place(desk), before);
}

TEST(FollowLead, GivesEveryRankAPlaceOfItsOwn) {
  std::set<std::pair<double, double>> places;
  for (std::uint32_t rank = 1; rank <= model::kMaxFlight; ++rank) {
    const Vec3 offset = formation_offset({}, rank);
    EXPECT_TRUE(places.insert({offset.x, offset.y}).second) << rank;
  }
}

TEST(FollowLead, NeverFollowsBelowItsFloor) {
  Desk desk = wingman(2);
  desk.own = model::test::flying({0, 0, -650}, 0, 250);
  desk.in_flight(4, 2);
  EXPECT_NEAR(*decide("{follow_lead: {floor: 600 m}}", desk).action().altitude, 600, 1e-9);
}

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
