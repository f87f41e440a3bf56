// SPDX-License-Identifier: MIT
#include "model/vehicle/vehicle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/angle.hpp"
#include "core/units.hpp"

namespace eyrie::model::vehicle {
namespace {

constexpr double kStep = 0.02;

/// One vehicle on the road.
struct Drive {
  explicit Drive(double heading = 0, double speed = 0) {
    type.prepare();
    k = parked(reference, {}, heading, speed);
    command = {.heading = heading, .speed = speed};
  }
  void go(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kStep + 0.5); ++i)
      drive(type, reference, routes, command, kStep, k, driving);
  }

  VehicleType type;
  Reference reference{{si(33, "deg"), si(-68, "deg"), 0}};
  std::vector<flight::Route> routes;
  Kinematics k;
  Driving driving;
  DriveCommand command;
};

TEST(Drive, GoesStraightAndStaysOnTheSurface) {
  Drive d(si(30, "deg"), 20);
  d.go(1000);
  EXPECT_NEAR(norm(d.k.position), 20e3, 0.2);  // the chord of an arc of 20 km
  EXPECT_NEAR(d.reference.altitude_at(d.k.position), 0, 1e-6);
  EXPECT_NEAR(d.k.position.z, 20e3 * 20e3 / (2 * 6.37e6), 0.2) << "the Earth curves away";
  EXPECT_EQ(d.k.altitude, 0);
  EXPECT_NEAR(dot(d.k.velocity, d.k.down), 0, 1e-9);
}

TEST(Drive, GathersAndLosesSpeedAsItCan) {
  Drive d;
  d.command.speed = 10;
  d.go(5);
  EXPECT_NEAR(d.k.speed, 5 * d.type.acceleration, 1e-9);
  d.go(6);
  EXPECT_EQ(d.k.speed, 10);
  d.command.speed = 0;
  d.go(2);
  EXPECT_NEAR(d.k.speed, 10 - 2 * d.type.braking, 1e-9);
  d.go(10);
  EXPECT_EQ(d.k.speed, 0);
}

TEST(Drive, StandsWhenAskedToCreep) {
  Drive d(0, 2);
  d.command.speed = 0.09;
  d.go(5);
  EXPECT_EQ(d.k.speed, 0);
}

TEST(Drive, TurnsInACircleOfItsTurnRadius) {
  Drive d(0, 2);
  d.command.speed = 2;
  double east = 0;
  for (int i = 0; i < 3000; ++i) {
    d.command.heading = wrap_pi(d.k.heading + 2);  // always more to the right
    d.go(kStep);
    if (i > 200)
      east = std::max(east, d.k.position.y);
  }
  EXPECT_NEAR(d.driving.steering, d.type.steering_angle, 1e-12);
  const Vec3 one = d.k.position;
  const double half_turn = kPi * d.type.turn_radius() / 2;  // s, at 2 m/s
  for (int i = 0; i < static_cast<int>(half_turn / kStep + 0.5); ++i) {
    d.command.heading = wrap_pi(d.k.heading + 2);
    d.go(kStep);
  }
  EXPECT_NEAR(norm(d.k.position - one), 2 * d.type.turn_radius(), 0.05);
}

TEST(Drive, SlowsDownForABend) {
  Drive d(0, 20);
  d.command.heading = si(90, "deg");
  double fastest = 0;
  for (int i = 0; i < 1200; ++i) {
    d.go(kStep);
    const double side = d.k.speed * d.k.speed * std::tan(d.driving.steering) / d.type.wheelbase;
    fastest = std::max(fastest, side);
  }
  EXPECT_NEAR(d.k.heading, si(90, "deg"), 1e-3);
  EXPECT_GT(fastest, 0.5 * d.type.side_acceleration);
  EXPECT_LT(fastest, 1.1 * d.type.side_acceleration) << "at most by what a step gathers";
  EXPECT_NEAR(d.k.speed, 20, 0.5) << "and is fast again behind it";
}

TEST(Drive, FollowsItsRouteAndCountsTheLegs) {
  Drive d(0, 10);
  d.routes = {{.name = "road",
               .waypoints = {{.position = {500, 0, 0}}, {.position = {500, 500, 0}}},
               .end = flight::RouteEnd::stop}};
  for (int i = 0; i < 12000; ++i) {
    const flight::Guidance wanted =
        flight::route_guidance(d.type.guidance, d.k, d.routes[0], d.driving.nav, 10, 0);
    d.command = {wanted.heading, wanted.speed};
    d.go(kStep);
  }
  EXPECT_EQ(d.driving.nav.leg, 2);
  EXPECT_EQ(d.k.speed, 0);
  EXPECT_NEAR(d.k.position.x, 500, 5);
  EXPECT_NEAR(d.k.position.y, 500, d.type.capture_radius + 5);
}

RC_GTEST_PROP(Drive, KeepsItsLimitsWhateverIsAsked, ()) {
  Drive d(*rc::gen::map(rc::gen::inRange(-314, 314), [](int c) { return c / 100.0; }), 0);
  for (int i = 0; i < 40; ++i) {
    d.command.heading = *rc::gen::map(rc::gen::inRange(-314, 314), [](int c) { return c / 100.0; });
    d.command.speed = *rc::gen::inRange(-5, 60);
    for (int j = 0; j < 25; ++j) {
      const Kinematics before = d.k;
      const double wheels = d.driving.steering;
      d.go(kStep);
      RC_ASSERT(d.k.speed >= 0 && d.k.speed <= d.type.top_speed);
      RC_ASSERT(d.k.speed - before.speed <= d.type.acceleration * kStep + 1e-12);
      RC_ASSERT(before.speed - d.k.speed <= d.type.braking * kStep + 1e-12);
      RC_ASSERT(std::fabs(d.driving.steering) <= d.type.steering_angle);
      // back towards straight they may be turned faster: by the road
      RC_ASSERT(std::fabs(d.driving.steering) - std::fabs(wheels) <=
                d.type.steering_rate * kStep + 1e-12);
      RC_ASSERT(norm(d.k.position - before.position) <= d.k.speed * kStep + 1e-6);
      RC_ASSERT(std::fabs(d.reference.altitude_at(d.k.position)) < 1e-6);
    }
  }
}

}  // namespace
}  // namespace eyrie::model::vehicle
