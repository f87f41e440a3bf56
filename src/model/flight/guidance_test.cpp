// SPDX-License-Identifier: MIT
#include "model/flight/guidance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"

namespace eyrie::model::flight {
namespace {

/// Level flight in axes that are those of the local frame.
Kinematics placed_at(double north, double east, double heading = 0, double speed = 250) {
  Kinematics k;
  k.position = {north, east, 0};
  k.velocity = {speed * std::cos(heading), speed * std::sin(heading), 0};
  k.north = {1, 0, 0};
  k.east = {0, 1, 0};
  k.down = {0, 0, 1};
  k.heading = heading;
  k.speed = speed;
  return k;
}

constexpr GuidanceGains kGains;

TEST(Follow, FliesAsTheLeadOnceInPlace) {
  const FollowOrder order{.position = {0, 0, 0},
                          .velocity = {0, 240, 0},
                          .lead_heading = radians(90),
                          .offset = {-305, -1829, 0},
                          .altitude = 5000};
  // 305 m behind and 1829 m left of a lead that flies east
  const Guidance g = follow_guidance(kGains, placed_at(1829, -305, radians(90)), order);
  EXPECT_NEAR(degrees(g.heading), 90, 1e-9);
  EXPECT_NEAR(g.speed, 240, 1e-9);
  EXPECT_EQ(g.altitude, 5000);
}

TEST(Follow, AddsFiveMetersPerSecondForAHundredMeters) {
  const FollowOrder order{.velocity = {240, 0, 0}};
  const Guidance behind = follow_guidance(kGains, placed_at(-100, 0), order);
  EXPECT_NEAR(behind.speed, 245, 1e-9);
  EXPECT_NEAR(behind.heading, 0, 1e-9);
  const Guidance left = follow_guidance(kGains, placed_at(0, -100), order);
  EXPECT_NEAR(left.heading, std::atan2(5, 240), 1e-9);
}

TEST(Follow, KeepsItsSpeedLimits) {
  const FollowOrder order{.velocity = {240, 0, 0}};
  EXPECT_EQ(follow_guidance(kGains, placed_at(-50e3, 0), order).speed, 350);
  EXPECT_EQ(follow_guidance(kGains, placed_at(3000, 0), order).speed, 150);
}

TEST(Follow, FliesTowardsSomebodyWhoComesHeadOn) {
  const FollowOrder order{
      .position = {40e3, 3e3, 0}, .velocity = {-250, 0, 0}, .lead_heading = kPi, .altitude = 6000};
  const Guidance g = follow_guidance(kGains, placed_at(0, 0), order);
  EXPECT_NEAR(g.heading, std::atan2(0.05 * 3e3, 0.05 * 40e3 - 250), 1e-9);
}

TEST(LowPass, TakesTheShortWayAndItsTimeConstant) {
  double heading = radians(179);
  heading = low_pass_heading(heading, radians(-179), 0.02, 2);
  EXPECT_GT(degrees(heading), 179);
  double smooth = 0;
  for (int i = 0; i < 100; ++i)
    smooth = low_pass_heading(smooth, 1, 0.02, 2);
  EXPECT_NEAR(smooth, 1 - std::exp(-1.0), 0.003);  // 2 s at a time constant of 2 s
  EXPECT_EQ(low_pass_heading(0.3, 1, 0.02, 0), 1);
}

TEST(Loiter, FliesTheTangentOnTheCircle) {
  const Guidance east = loiter_guidance(kGains, placed_at(0, 5000), {}, 5000, 6000, 200);
  EXPECT_NEAR(degrees(east.heading), 180, 1e-9) << "clockwise: south when east of the center";
  EXPECT_NEAR(east.turn_rate, 200.0 / 5000, 1e-12);
  EXPECT_EQ(east.altitude, 6000);
  EXPECT_EQ(east.speed, 200);
}

TEST(Loiter, ClosesInFromOutsideAndOpensUpFromInside) {
  const double outside = loiter_guidance(kGains, placed_at(50e3, 0), {}, 5000, 0, 200).heading;
  EXPECT_NEAR(degrees(outside), 180, 4) << "far away: straight to the center";
  const double inside = loiter_guidance(kGains, placed_at(2500, 0), {}, 5000, 0, 200).heading;
  EXPECT_LT(degrees(inside), 90);
  EXPECT_GT(degrees(inside), 0);
}

TEST(Loiter, KnowsHowFastItsHeadingTurns) {
  for (const double distance : {2e3, 4.9e3, 5.1e3, 9e3, 30e3}) {
    const Kinematics here = placed_at(distance, 0);
    const Guidance g = loiter_guidance(kGains, here, {}, 5000, 0, 200);
    const double dt = 0.01;
    const Kinematics later =
        placed_at(distance + 200 * dt * std::cos(g.heading), 200 * dt * std::sin(g.heading));
    const double next = loiter_guidance(kGains, later, {}, 5000, 0, 200).heading;
    EXPECT_NEAR(angle_between(g.heading, next) / dt, g.turn_rate, 1e-4) << distance;
  }
}

Route route(RouteEnd end = RouteEnd::loiter) {
  return {.name = "mission",
          .waypoints = {{.position = {20e3, 0, 0}, .altitude = 6000, .speed = 240},
                        {.position = {20e3, 40e3, 0}, .altitude = 7000, .speed = {}},
                        {.position = {0, 40e3, 0}, .altitude = 5000, .speed = 200}},
          .end = end};
}

TEST(RouteGuidance, FliesStraightToTheFirstWaypoint) {
  const Guidance g = route_guidance(kGains, placed_at(0, -5e3), route(), {}, 300, 0);
  EXPECT_NEAR(g.heading, std::atan2(5e3, 20e3), 1e-9);
  EXPECT_EQ(g.altitude, 6000);
  EXPECT_EQ(g.speed, 240);
}

TEST(RouteGuidance, ClosesInOnTheLeg) {
  const NavState second{.leg = 1};
  EXPECT_NEAR(
      degrees(route_guidance(kGains, placed_at(20e3, 10e3), route(), second, 300, 0).heading), 90,
      1e-9);
  // 1500 m left of it (north): aims at the leg 15 s ahead
  const Guidance g = route_guidance(kGains, placed_at(21.5e3, 10e3), route(), second, 300, 0);
  EXPECT_NEAR(g.heading, kPi / 2 + std::atan2(1500, 300 * 15), 1e-9);
  EXPECT_EQ(g.speed, 300) << "this waypoint leaves the speed to the command";
}

TEST(RouteGuidance, EndsAsTheRouteSays) {
  const NavState past{.leg = 3};
  const Kinematics k = placed_at(-500, 40e3, kPi);
  const Guidance circle = route_guidance(kGains, k, route(), past, 300, 4e3);
  const Guidance same = loiter_guidance(kGains, k, {0, 40e3, 0}, 4e3, 5000, 200);
  EXPECT_EQ(circle.heading, same.heading);
  EXPECT_EQ(circle.altitude, 5000);
  const Guidance on = route_guidance(kGains, k, route(RouteEnd::straight), past, 300, 0);
  EXPECT_NEAR(std::fabs(on.heading), kPi, 1e-9);
}

TEST(RouteGuidance, GoesOnWithoutWaypoints) {
  const Guidance g = route_guidance(kGains, placed_at(0, 0, 1), Route{}, {}, 222, 0);
  EXPECT_EQ(g.heading, 1);
  EXPECT_EQ(g.speed, 222);
  EXPECT_EQ(advance_leg(kGains, placed_at(0, 0), Route{}, {}, 1000).leg, 0);
}

TEST(RouteGuidance, CrabsAgainstTheWind) {
  const Vec3 wind{0, 40, 0};  // from the west
  EXPECT_NEAR(crab(0, 250, wind), -std::asin(40.0 / 250), 1e-12);
}

TEST(AdvanceLeg, CountsAWaypointInsideTheCaptureRadius) {
  const NavState on{.leg = 0};
  EXPECT_EQ(advance_leg(kGains, placed_at(20e3 - 1000, 0), route(), on, 0).leg, 0);
  EXPECT_EQ(advance_leg(kGains, placed_at(20e3 - 900, 0), route(), on, 0).leg, 1);
}

TEST(AdvanceLeg, AnticipatesTheTurnOntoTheNextLeg) {
  // a right angle: radius * tan(45 deg) before the waypoint
  const NavState on{.leg = 1};
  EXPECT_EQ(advance_leg(kGains, placed_at(20e3, 36.9e3, kPi / 2), route(), on, 3000).leg, 1);
  EXPECT_EQ(advance_leg(kGains, placed_at(20e3, 37.1e3, kPi / 2), route(), on, 3000).leg, 2);
}

TEST(AdvanceLeg, CountsAWaypointPassedAbeam) {
  const NavState on{.leg = 1};
  EXPECT_EQ(advance_leg(kGains, placed_at(26e3, 40.1e3, kPi / 2), route(), on, 0).leg, 2);
  EXPECT_EQ(advance_leg(kGains, placed_at(60e3, 40.1e3, kPi / 2), route(), on, 0).leg, 1)
      << "too far aside";
  // the first leg has no direction: behind the wings counts
  EXPECT_EQ(advance_leg(kGains, placed_at(21e3, 5e3, 0), route(), {}, 0).leg, 1);
  EXPECT_EQ(advance_leg(kGains, placed_at(19e3, 5e3, 0), route(), {}, 0).leg, 0);
}

TEST(AdvanceLeg, StartsAgainIfTheRouteRepeats) {
  const NavState last{.leg = 2};
  EXPECT_EQ(advance_leg(kGains, placed_at(100, 40e3, kPi), route(RouteEnd::repeat), last, 0).leg,
            0);
  EXPECT_EQ(advance_leg(kGains, placed_at(100, 40e3, kPi), route(), last, 0).leg, 3);
}

TEST(AdvanceLeg, DoesNotCountAWaypointThatItIsFarFrom) {
  // behind the wings, or on the way onto the next leg, but ten capture radii away or more
  EXPECT_EQ(advance_leg(kGains, placed_at(25e3, 9e3, 0), route(), {}, 3000).leg, 0);
  const NavState on{.leg = 1};
  EXPECT_EQ(advance_leg(kGains, placed_at(20e3 + 9.4e3, 37.5e3, kPi / 2), route(), on, 3000).leg,
            1);
}

TEST(AdvanceLeg, AnticipatesATurnBackByThreeRadiiAtMost) {
  const Route back{.name = "back",
                   .waypoints = {{.position = {50e3, 0, 0}}, {.position = {0, 10, 0}}}};
  EXPECT_EQ(advance_leg(kGains, placed_at(50e3 - 3100, 0), back, {}, 1000).leg, 0);
  EXPECT_EQ(advance_leg(kGains, placed_at(50e3 - 2900, 0), back, {}, 1000).leg, 1);
}

}  // namespace
}  // namespace eyrie::model::flight
