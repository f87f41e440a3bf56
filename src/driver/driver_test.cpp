// SPDX-License-Identifier: MIT
/// \file  What drivers decide: the behaviors of every platform, and their own.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/angle.hpp"
#include "driver/behaviors.hpp"
#include "support/driver/cab.hpp"

namespace eyrie::driver {
namespace {

using driver::testing::decide;
using driver::testing::Decided;
using driver::testing::Desk;
using driver::testing::Driver;

Desk in_column(std::uint32_t rank) {
  Desk desk;
  desk.in_convoy(4, rank);
  return desk;
}

TEST(DriverNavigate, DrivesAlongTheRouteAtTheSpeedOfTheLeg) {
  const Decided d = decide("{navigate: {vote: 7, speed: 40 km/h}}", Desk());
  EXPECT_EQ(d.status, Status::running);
  EXPECT_NEAR(*d.action().heading, 0, 1e-9);
  EXPECT_EQ(d.action().speed, 12);
  EXPECT_EQ(d.proposal.vote, 7);
  Desk second;
  second.own = model::test::flying({2e3, 100, 0}, 0, 10);
  second.driving.nav.leg = 1;
  const Decided there = decide("{navigate: {speed: 36 km/h}}", second);
  EXPECT_NEAR(*there.action().heading, kPi / 2, 1e-9);
  EXPECT_EQ(there.action().speed, 10) << "the leg gives no speed";
}

TEST(DriverNavigate, StandsAtTheEndOfTheRoute) {
  Desk desk;
  desk.driving.nav.leg = 2;
  const Decided d = decide("navigate", desk);
  EXPECT_EQ(d.status, Status::success);
  EXPECT_EQ(d.action().speed, 0);
  EXPECT_EQ(decide("route_done", desk).status, Status::success);
}

TEST(DriverNavigate, FailsWithoutSuchARoute) {
  EXPECT_EQ(decide("{navigate: {route: 1}}", Desk()).status, Status::failure);
}

TEST(DriverFollowLead, KeepsItsDistanceBehindTheVehicleAhead) {
  Desk desk = in_column(3);
  const Decided d = decide("follow_lead", desk);
  EXPECT_EQ(d.status, Status::running);
  EXPECT_NEAR(*d.action().heading, 0, 1e-9);
  EXPECT_NEAR(*d.action().speed, 10, 1e-9) << "in its place already";
  desk.spacing.gap = 30;
  EXPECT_NEAR(*decide("follow_lead", desk).action().speed,
              10 + 20 * testing::library().vehicles[0].gap_gain, 1e-9);
}

TEST(DriverFollowLead, ClosesUpWhenTheVehicleAheadIsLost) {
  Desk desk = in_column(3);
  desk.lose(2);
  EXPECT_NEAR(*decide("follow_lead", desk).action().speed,
              10 + 50 * testing::library().vehicles[0].gap_gain, 1e-9);
}

TEST(DriverFollowLead, FailsForWhoeverLeads) {
  EXPECT_EQ(decide("follow_lead", in_column(1)).status, Status::failure);
  Desk desk = in_column(3);
  desk.lose(1);
  EXPECT_EQ(decide("follow_lead", desk).status, Status::running);
  EXPECT_EQ(decide("is_lead", desk).status, Status::failure);
  desk.lose(2);
  EXPECT_EQ(decide("follow_lead", desk).status, Status::failure);
  EXPECT_EQ(decide("is_lead", desk).status, Status::success);
}

TEST(DriverFollowLead, WaitsInsteadOfTurningBackWhenItIsTooClose) {
  Desk desk = in_column(2);
  desk.spacing.gap = 500;
  const Decided d = decide("follow_lead", desk);
  EXPECT_EQ(*d.action().speed, 0);
  EXPECT_NEAR(std::remainder(*d.action().heading, kTau), 0, 1e-9);
}

TEST(Scatter, LeavesTheRoadOnTheSideOfItsRank) {
  std::set<double> headings;
  for (const std::uint32_t rank : {1u, 2u}) {
    Desk desk = in_column(rank);
    desk.see(7000);
    const Decided d = decide("{scatter: {angle: 70 deg, speed: 8 m/s}}", desk);
    EXPECT_EQ(d.status, Status::running);
    EXPECT_EQ(d.action().call, Call::scatter);
    EXPECT_EQ(d.action().speed, 8);
    headings.insert(wrap_pi(*d.action().heading));
  }
  EXPECT_NEAR(*headings.begin(), radians(-70), 1e-9);
  EXPECT_NEAR(*headings.rbegin(), radians(70), 1e-9);
}

TEST(Scatter, StandsOffTheRoadUntilItIsCalm) {
  Driver driver("{scatter: {distance: 200 m, calm: 30 s}}");
  Desk desk = in_column(2);
  desk.see(5000);
  EXPECT_GT(*driver.decide(desk).action().speed, 0);
  desk.own.position = {60, -200, 0};
  desk.lookout = {};
  desk.time += 20;
  EXPECT_EQ(driver.decide(desk).action().speed, 0) << "that is far enough";
  desk.see(7000);  // again
  desk.time += 5;
  EXPECT_EQ(driver.decide(desk).status, Status::running);
  desk.lookout = {};
  desk.time += 29;
  EXPECT_EQ(driver.decide(desk).status, Status::running);
  desk.time += 2;
  EXPECT_EQ(driver.decide(desk).status, Status::failure);
}

TEST(Scatter, IgnoresFriendsAndWhatIsFar) {
  Desk desk;
  desk.see(3000, model::Identity::friendly);
  desk.see(9000);
  EXPECT_EQ(decide("{scatter: {range: 8 km}}", desk).status, Status::failure);
  desk.see(7900, model::Identity::unknown);
  EXPECT_EQ(decide("{scatter: {range: 8 km}}", desk).status, Status::running);
}

TEST(DriverWords, ReadTheDriversState) {
  Desk desk = in_column(3);
  desk.lose(4);
  const auto holds = [&](const std::string& words) {
    return decide("{holds: " + words + "}", desk).status == Status::success;
  };
  EXPECT_TRUE(holds("rank == 3 and alive == 3 and not leads"));
  EXPECT_TRUE(holds("speed > 35 km/h and gap > 49 m and gap < 51 m"));
  EXPECT_TRUE(holds("aircraft == 0"));
  EXPECT_FALSE(holds("aircraft_range < 100 km")) << "no value without an aircraft";
  desk.see(4000);
  EXPECT_TRUE(holds("aircraft_range < 5 km and hostile and aircraft == 1"));
}

TEST(DriverWords, LoopOverTheAircraftInSight) {
  Desk desk;
  desk.see(3000, model::Identity::friendly);
  desk.see(6000);
  EXPECT_EQ(
      decide("{for_each: {over: aircraft, child: {holds: aircraft_range < 4 km}}}", desk).status,
      Status::success);
  EXPECT_EQ(decide("{holds: aircraft_range < 4 km}", desk).status, Status::failure);
}

}  // namespace
}  // namespace eyrie::driver
