// SPDX-License-Identifier: MIT
#include "model/flight/laero.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/model/lone_flight.hpp"

namespace eyrie::model::flight {
namespace {

using test::kDt;
using test::simple_airframe;
using test::TestFlight;

TestFlight laero() {
  TestFlight f(simple_airframe(), Dynamics::laero);
  f.start(6000, 0, 250);
  return f;
}

TEST(Laero, KeepsTheHeadingItStartsWith) {
  TestFlight f = laero();
  f.start(6000, radians(-135), 250);
  f.run(10);
  EXPECT_NEAR(degrees(f.kinematics.heading), -135, 0.01) << "as meridians meet, it turns";
  EXPECT_NEAR(f.kinematics.altitude, 6000, 0.1);
  EXPECT_NEAR(f.kinematics.speed, 250, 1e-9);
}

TEST(Laero, TurnsTheShortWay) {
  for (const double from : {170.0, -170.0}) {
    TestFlight f = laero();
    f.start(6000, radians(from), 250);
    f.command.heading = radians(-from);
    double turned = 0;
    for (int i = 0; i < 50 * 30; ++i) {
      const double before = f.kinematics.heading;
      f.step();
      turned += angle_between(before, f.kinematics.heading);
    }
    EXPECT_NEAR(degrees(turned), from > 0 ? 20 : -20, 0.01);
    EXPECT_NEAR(degrees(angle_between(f.kinematics.heading, radians(-from))), 0, 0.01);
  }
}

TEST(Laero, TurnsAtTheLeastOfTurnRateBankAndLoadFactor) {
  const Laero limits;
  // 30 deg of bank: g tan(30 deg) / V is below 3 deg/s from 108 m/s on
  EXPECT_NEAR(limits.turn_rate_limit(250, 5), kGravity * std::tan(kPi / 6) / 250, 1e-12);
  EXPECT_NEAR(degrees(limits.turn_rate_limit(100, 5)), 3, 1e-12);
  EXPECT_NEAR(limits.turn_rate_limit(250, 1.1), kGravity * std::sqrt(0.21) / 250, 1e-12);
  EXPECT_EQ(limits.turn_rate_limit(250, 1), 0);

  TestFlight f = laero();
  f.command.heading = radians(90);
  f.run(20);
  EXPECT_NEAR(f.kinematics.heading, 20 * kGravity * std::tan(kPi / 6) / 250, 1e-3);
  EXPECT_NEAR(degrees(f.kinematics.roll), 30, 0.1) << "the bank of the turn, for show";
}

TEST(Laero, ClimbsAndDescendsAtItsRate) {
  TestFlight f = laero();
  f.command.altitude = 8000;
  f.run(60);
  const double before = f.kinematics.altitude;
  f.run(10);
  EXPECT_NEAR((f.kinematics.altitude - before) / 10, si(2000, "ft/min"), 0.01);
  f.run(240);
  EXPECT_NEAR(f.kinematics.altitude, 8000, 0.5);
  EXPECT_NEAR(f.kinematics.pitch, 0, 1e-4);
}

TEST(Laero, ChangesSpeedAtItsRate) {
  TestFlight f = laero();
  f.command.speed = 300;
  f.run(10);
  EXPECT_NEAR(f.kinematics.speed, 250 + 10 * si(5, "kt"), 1e-6);
  f.run(30);
  EXPECT_NEAR(f.kinematics.speed, 300, 1e-3);
}

TEST(Laero, NeverOvershootsAHeadingByMoreThanATenthOfADegree) {
  TestFlight f = laero();
  f.command.heading = radians(60);
  double most = 0;
  for (int i = 0; i < 50 * 120; ++i) {
    f.step();
    most = std::max(most, f.kinematics.heading);
  }
  EXPECT_LT(degrees(most), 60.1);
  EXPECT_NEAR(degrees(f.kinematics.heading), 60, 0.01);
}

TEST(Laero, IntegratesASteadyTurnToSecondOrder) {
  // the distance from the circle of the closed form after one turn, at two step lengths
  const auto error = [](double dt) {
    Laero limits;
    TestFlight f = laero();
    Flying memory;
    Kinematics k = f.kinematics;
    const double rate = limits.turn_rate_limit(250, 5), radius = 250 / rate;
    const int steps = static_cast<int>(std::lround(100 / dt));
    for (int i = 0; i < steps; ++i) {
      const Guidance on{.heading = k.heading + 1, .altitude = k.altitude, .speed = 250};
      limits.step(k, memory, on, rate, f.propulsion, standard_air(6000), {}, dt);
    }
    const double turned = rate * 100;
    const Vec3 moved = k.position - f.kinematics.position;
    return std::hypot(moved.x - radius * std::sin(turned),
                      moved.y - radius * (1 - std::cos(turned)));
  };
  const double coarse = error(0.2), fine = error(0.05);
  EXPECT_LT(fine, coarse / 8) << coarse << " m and " << fine << " m";
}

TEST(Laero, SinksWithoutFuel) {
  Airframe a = simple_airframe();
  a.laero.fuel_flow = 1;
  a.internal_fuel = 10;
  TestFlight f(a, Dynamics::laero);
  f.start(6000, 0, 250);
  int dry = 0;
  for (int i = 0; i < 50 * 60; ++i)
    dry += f.step();
  EXPECT_EQ(dry, 1);
  EXPECT_EQ(f.propulsion.fuel, 0);
  EXPECT_NEAR(f.kinematics.altitude, 6000 - 50 * si(2000, "ft/min"), 10);
  EXPECT_LT(f.kinematics.speed, 150);
}

TEST(Laero, ClosesAHeadingErrorAsTheExponentialOfItsTime) {
  TestFlight f = laero();
  f.command.heading = 0.01;
  f.run(1);
  // Adams-Bashforth is within 2e-4 of it, Euler's method would be 1 % off
  EXPECT_NEAR(0.01 - f.kinematics.heading, 0.01 * std::exp(-1.0), 0.01 * 5e-4);
}

TEST(Laero, KeepsItsSpeedLimits) {
  TestFlight f = laero();
  f.command.speed = 5000;
  f.run(300);
  EXPECT_NEAR(f.kinematics.speed, si(1200, "kt"), 1e-3);
  f.command.speed = 0;
  f.run(300);
  EXPECT_NEAR(f.kinematics.speed, si(100, "kt"), 1e-3);
}

}  // namespace
}  // namespace eyrie::model::flight
