// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/model/lone_flight.hpp"

namespace eyrie::model::flight {
namespace {

using test::simple_airframe;
using test::TestFlight;

TEST(Steering, TurnsLevelWithTheLoadFactorItMayUse) {
  TestFlight f(simple_airframe());
  f.start(3000, 0, 250);
  f.command.heading = radians(179);
  f.command.load_factor = 4;
  f.run(4);
  double lowest = 1e9, highest = 0, most = 0;
  const double before = f.kinematics.heading, start = f.time;
  while (f.kinematics.heading < radians(140)) {
    f.step();
    lowest = std::min(lowest, f.kinematics.altitude);
    highest = std::max(highest, f.kinematics.altitude);
    most = std::max(most, f.kinematics.load_factor);
  }
  EXPECT_LE(most, 4 + 1e-9);
  EXPECT_GT(lowest, 2970);
  EXPECT_LT(highest, 3030);
  const double rate = kGravity * std::sqrt(15.0) / f.kinematics.speed;
  EXPECT_NEAR((f.kinematics.heading - before) / (f.time - start), rate, 0.06 * rate);
}

TEST(Steering, DoesNotOvershootTheHeading) {
  TestFlight f(simple_airframe());
  f.command.heading = radians(120);
  f.command.load_factor = 7;
  double most = 0;
  for (int i = 0; i < 50 * 60; ++i) {
    f.step();
    most = std::max(most, f.kinematics.heading);
  }
  EXPECT_LT(degrees(most), 121);
  EXPECT_NEAR(degrees(f.kinematics.heading), 120, 0.1);
}

TEST(Steering, DescendsWithLevelWingsAndStopsWithTheLiftItMayUse) {
  for (const double load_factor : {1.0, 1.5, 2.0, 7.0}) {
    TestFlight f(simple_airframe());
    f.start(8000, 0.3, 240);
    f.command.altitude = 300;
    f.command.heading = 0.3 + 1e-4;
    f.command.load_factor = load_factor;
    double lowest = 1e9, most_roll = 0;
    for (int i = 0; i < 50 * 400; ++i) {
      f.step();
      lowest = std::min(lowest, f.kinematics.altitude);
      most_roll = std::max(most_roll, std::abs(f.kinematics.roll));
    }
    EXPECT_GT(lowest, 250) << load_factor;
    EXPECT_LT(degrees(most_roll), 3) << load_factor;
    EXPECT_NEAR(f.kinematics.altitude, 300, load_factor > 1 ? 5 : 200) << load_factor;
  }
}

TEST(Steering, ClimbsOnExcessThrustAtTheSpeedAskedFor) {
  TestFlight f(simple_airframe());
  f.start(2000, 0, 230);
  f.command.altitude = 9000;
  f.run(40);
  const FlightCondition c = f.condition();
  const double steady = (c.thrust.military - c.drag(f.kinematics.load_factor)) /
                        (c.mass * kGravity);  // sine of the steepest climb at constant speed
  EXPECT_NEAR(std::sin(f.kinematics.pitch), steady, 0.02);
  EXPECT_NEAR(f.kinematics.speed, 230, 8);
  EXPECT_EQ(f.flying.afterburner, 0) << "a climb alone does not light it";
  f.run(200);
  EXPECT_NEAR(f.kinematics.altitude, 9000, 2);
  EXPECT_NEAR(f.kinematics.speed, 230, 1);
}

TEST(Steering, ClimbsInATurnOnlyWithWhatTheTurnLeaves) {
  const auto slowest_of = [](double altitude) {
    TestFlight f(simple_airframe());
    f.start(6000, 0, 250);
    f.command.altitude = altitude;
    f.command.heading = radians(170);
    f.command.load_factor = 6;
    double slowest = 1e9;
    for (int i = 0; i < 50 * 60; ++i) {
      f.step();
      slowest = std::min(slowest, f.kinematics.speed);
    }
    EXPECT_GT(degrees(f.kinematics.heading), 169);
    EXPECT_GE(f.kinematics.altitude, std::min(altitude, 7500.0) - 20) << "then it climbs";
    return slowest;
  };
  const double level = slowest_of(6000);
  EXPECT_LT(level, 235) << "the turn alone costs speed";
  EXPECT_GT(slowest_of(9000), level - 8);
}

TEST(Steering, LightsTheAfterburnerToAccelerateAndPutsItOut) {
  TestFlight f(simple_airframe());
  f.command.speed = 330;
  f.run(3);
  EXPECT_EQ(f.flying.afterburner, 1);
  double most = 0;
  for (int i = 0; i < 50 * 80; ++i) {
    f.step();
    most = std::max(most, f.propulsion.throttle);
  }
  EXPECT_NEAR(most, 2, 1e-9);
  EXPECT_NEAR(f.kinematics.speed, 330, 1.5);
  EXPECT_EQ(f.flying.afterburner, 0);
  EXPECT_LT(f.propulsion.throttle, 1);
}

TEST(Steering, KeepsTheAfterburnerWhereMilitaryPowerIsNotEnough) {
  Airframe a = simple_airframe();
  a.engine.military = Table2::constant(20e3);
  TestFlight f(a);
  f.start(5000, 0, 320);
  f.run(120);
  EXPECT_NEAR(f.kinematics.speed, 320, 2);
  int switches = 0;
  std::uint8_t last = f.flying.afterburner;
  for (int i = 0; i < 50 * 60; ++i) {
    f.step();
    switches += f.flying.afterburner != last;
    last = f.flying.afterburner;
  }
  EXPECT_EQ(last, 1);
  EXPECT_EQ(switches, 0) << "steady, not on and off";
}

TEST(Steering, NeverStallsInAClimbThatItCannotMake) {
  Airframe a = simple_airframe();
  a.engine.military = Table2::constant(15e3);
  a.engine.afterburner = Table2::constant(16e3);
  TestFlight f(a);
  f.start(4000, 0, 160);
  f.command.altitude = 20e3;
  f.command.speed = 160;
  double least = 1e9;
  for (int i = 0; i < 50 * 400; ++i) {
    f.step();
    least = std::min(least, f.condition().lift_limit);
  }
  EXPECT_GT(least, 1.05) << "the wing can always carry the aircraft";
  EXPECT_GT(f.kinematics.altitude, 4000);
}

TEST(Steering, RecoversFromTooSlowByPuttingTheNoseDown) {
  TestFlight f(simple_airframe());
  f.start(6000, 0, 75);
  f.command.speed = 0;
  ASSERT_LT(f.condition().lift_limit, 1);
  double lowest = 6000;
  for (int i = 0; i < 50 * 90; ++i) {
    f.step();
    lowest = std::min(lowest, f.kinematics.altitude);
  }
  EXPECT_GT(f.condition().lift_limit, 1.2);
  EXPECT_NEAR(f.kinematics.speed,
              Equations<double>({&f.model}).slowest_speed(f.kinematics, f.condition()), 3);
  EXPECT_GT(lowest, 4000);
}

TEST(Steering, KeepsTheSpeedLimits) {
  Airframe a = simple_airframe();
  a.engine.afterburner = Table2::constant(300e3);
  a.limits.max_mach = 1.1;
  a.limits.max_equivalent_airspeed = 280;
  for (const double altitude : {500.0, 12000.0}) {
    TestFlight f(a);
    f.start(altitude, 0, 250);
    f.command.speed = 900;
    f.run(120);
    const Air air = standard_air(altitude);
    const double limit =
        std::min(1.1 * air.speed_of_sound, 280 / std::sqrt(air.density / kSeaLevelDensity));
    EXPECT_NEAR(f.kinematics.speed, limit, 2) << altitude;
  }
}

TEST(Steering, DivesHardWhenSpeedIsAskedForToo) {
  TestFlight f(simple_airframe());
  f.start(9000, 0, 250);
  f.command.altitude = 1500;
  f.command.heading = radians(150);
  f.command.speed = 400;
  f.command.load_factor = 7;
  double steepest = 0, lowest = 1e9;
  for (int i = 0; i < 50 * 90; ++i) {
    f.step();
    steepest = std::min(steepest, f.kinematics.pitch);
    lowest = std::min(lowest, f.kinematics.altitude);
  }
  EXPECT_LT(degrees(steepest), -35);
  EXPECT_GE(degrees(steepest), -42);
  EXPECT_GT(lowest, 1450) << "levels off without going through";
  EXPECT_NEAR(f.kinematics.altitude, 1500, 5);
}

TEST(Steering, SinksAsTheGlideRatioSaysWithoutFuel) {
  TestFlight f(simple_airframe());
  f.propulsion.fuel = 0;
  f.start(8000, 0, 150);
  f.run(120);
  const double before = f.energy();
  const Vec3 from = f.kinematics.position;
  f.run(60);
  // lift over drag from the polar, at the lift coefficient of the glide
  const FlightCondition c = f.condition();
  const double qs = c.zero_lift_drag / 0.02, lift = c.mass * kGravity / qs;
  const double glide = lift / (0.02 + 0.12 * lift * lift);
  const double flown = norm(f.kinematics.position - from);
  EXPECT_NEAR(flown / ((before - f.energy()) / kGravity), glide, 0.02 * glide);
}

TEST(Steering, BurnsTheFuelThatItsThrustCosts) {
  TestFlight f(simple_airframe());
  f.run(60);
  const double before = f.propulsion.fuel;
  const Table1& part_power = f.model.airframe().engine.part_power;
  double burned = 0;
  for (int i = 0; i < 50 * 300; ++i) {
    const FlightCondition c = f.condition();
    f.step();
    // at military power TSFC (C1 + C2 M) sqrt(theta) times thrust, eq. 3.12 of Mattingly; a share
    // of that at part power
    const double tsfc =
        si(0.9, "lb/lbf/h") * (1 + c.mach / 3) * std::sqrt(c.temperature / kSeaLevelTemperature);
    const double share = f.propulsion.thrust / c.thrust.military;
    burned += tsfc * c.thrust.military * part_power(share) * test::kDt;
  }
  EXPECT_NEAR(before - f.propulsion.fuel, burned, 1e-3 * burned);
  EXPECT_GT(burned, 50);
}

TEST(Steering, DivesNoFasterThanTheSpeedLimit) {
  Airframe a = simple_airframe();
  a.limits.max_mach = 0.9;
  TestFlight f(a);
  f.start(10000, 0, 260);
  f.command.speed = 400;
  f.command.altitude = 2000;
  double fastest = 0;
  while (f.kinematics.altitude > 4000 && f.time < 600) {
    f.step();
    fastest = std::max(fastest, f.kinematics.mach);
  }
  EXPECT_LT(f.time, 600);
  EXPECT_GT(fastest, 0.88);
  EXPECT_LT(fastest, 0.96);
}

TEST(Steering, FliesLevelEvenIfNoLoadFactorIsGranted) {
  TestFlight f(simple_airframe());
  f.command.load_factor = 0;
  f.run(30);
  EXPECT_NEAR(f.kinematics.altitude, 5000, 5);
}

/// A unit vector, north-east-down.
Vec3 direction(double heading, double climb) {
  return {std::cos(climb) * std::cos(heading), std::cos(climb) * std::sin(heading),
          -std::sin(climb)};
}

TEST(Steering, AimsAtADirectionWhicheverWayUp) {
  for (const double heading : {0.5, 2.0, -2.5, kPi})
    for (const double climb : {-0.6, 0.0, 0.9}) {
      TestFlight f(simple_airframe());
      f.start(5000, 0, 280);
      f.command = {.heading = heading, .speed = 280, .climb = climb, .load_factor = 6};
      f.command.mode = AutopilotMode::aim;
      double least = kPi;
      for (int i = 0; i < 50 * 25; ++i) {
        f.step();
        least = std::min(least, angle_between(direction(heading, climb),
                                              direction(f.kinematics.heading, f.kinematics.pitch)));
      }
      EXPECT_LT(least, radians(2)) << heading << " " << climb;
    }
}

/// The path bends straight at the direction: up, over the top and inverted, within the vertical
/// plane; not by a turn.
TEST(Steering, GoesOverTheTopToWhatIsRightBehindAndAbove) {
  TestFlight f(simple_airframe());
  f.start(5000, 0, 300);
  f.command = {.heading = kPi, .speed = 300, .climb = 0.3, .load_factor = 7};
  f.command.mode = AutopilotMode::aim;
  double highest = 0, aside = 0;
  for (int i = 0; i < 50 * 14; ++i) {
    f.step();
    highest = std::max(highest, f.kinematics.altitude);
    aside = std::max(aside, std::fabs(f.kinematics.position.y));
  }
  EXPECT_GT(highest, 6500);
  EXPECT_LT(aside, 150);
}

/// Handed over while it stands upright, as by a maneuver that another behavior ends.
TEST(Steering, PullsOutOfASteepClimbInsteadOfHangingInIt) {
  for (const double heading : {0.0, 2.0, kPi}) {
    TestFlight f(simple_airframe());
    f.start(5000, 0, 300);
    f.command = {.speed = 300, .climb = radians(85), .load_factor = 7};
    f.command.mode = AutopilotMode::aim;
    while (f.kinematics.pitch < radians(80))
      f.step();
    f.command = {.heading = heading, .altitude = 7500, .speed = 250, .load_factor = 3};
    double slowest = 1e9;
    for (int i = 0; i < 50 * 25; ++i) {
      f.step();
      slowest = std::min(slowest, f.kinematics.speed);
      if (i > 50 * 12) {
        EXPECT_LT(std::fabs(f.kinematics.pitch), radians(45)) << heading;
      }
    }
    EXPECT_GT(slowest, 90) << heading;
  }
}

TEST(Steering, LetsGoInsteadOfRollingOverForALittleDownwards) {
  TestFlight f(simple_airframe());
  f.command.climb = radians(-8);
  f.command.load_factor = 7;
  f.command.mode = AutopilotMode::aim;
  double steepest = 0;
  for (int i = 0; i < 50 * 5; ++i) {
    f.step();
    steepest = std::max(steepest, std::fabs(f.kinematics.roll));
  }
  EXPECT_LT(degrees(steepest), 1);
  EXPECT_NEAR(degrees(f.kinematics.pitch), -8, 0.5);
}

}  // namespace
}  // namespace eyrie::model::flight
