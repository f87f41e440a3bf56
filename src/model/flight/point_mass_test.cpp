// SPDX-License-Identifier: MIT
#include "model/flight/point_mass.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "model/flight/energy.hpp"
#include "support/model/lone_flight.hpp"

namespace eyrie::model::flight {
namespace {

using test::ideal_airframe;
using test::simple_airframe;
using test::TestFlight;

TEST(PointMass, FliesStraightOnWhereMeridiansMeet) {
  for (const double latitude : {0.0, 60.0, 89.0}) {
    TestFlight f(simple_airframe());
    f.reference = Reference(Geodetic{.latitude = radians(latitude), .longitude = radians(10)});
    f.start(5000, kPi / 2, 250);
    for (int i = 0; i < 50 * 800; ++i) {
      const FlightCondition c = f.condition();
      f.step(Controls{.load_factor = std::cos(f.kinematics.pitch),
                      .throttle = Engine::throttle_for(c.thrust, c.drag(1), true)});
    }
    EXPECT_GT(f.kinematics.position.y, 180e3) << latitude;
    EXPECT_LT(std::abs(f.kinematics.position.x), 150) << latitude;
  }
}

TEST(PointMass, KeepsItsEnergyWithoutThrustAndDrag) {
  TestFlight f(ideal_airframe());
  f.start(8000, 1, 300);
  const double start = f.energy();
  double lowest = f.kinematics.altitude, highest = lowest;
  for (int i = 0; i < 50 * 120; ++i) {
    const double t = f.time;
    f.step({.load_factor = 1 + 2 * std::sin(0.3 * t), .bank = 1.2 * std::sin(0.17 * t)});
    ASSERT_NEAR((f.energy() - start) / kGravity, 0, 0.05) << "after " << t << " s";
    lowest = std::min(lowest, f.kinematics.altitude);
    highest = std::max(highest, f.kinematics.altitude);
  }
  EXPECT_GT(highest - lowest, 500) << "the test must climb and dive";
}

RC_GTEST_PROP(PointMass, KeepsItsEnergyInAnyIdealManeuver, ()) {
  TestFlight f(ideal_airframe());
  f.start(10000, 0, *rc::gen::inRange(150, 500));
  const double start = f.energy();
  const double rhythm = *rc::gen::inRange(1, 100) * 0.02;
  const double pull = *rc::gen::inRange(-20, 80) * 0.1;
  const double bank = *rc::gen::inRange(-31, 31) * 0.1;
  for (int i = 0; i < 50 * 20; ++i) {
    f.step({.load_factor = pull, .bank = bank * std::sin(rhythm * f.time)});
    if (f.kinematics.altitude < 0 || f.kinematics.speed < 60)
      break;  // the midpoint rule needs a path that curves less than a radian per step
  }
  RC_ASSERT(std::fabs(f.energy() - start) / kGravity < 0.5);
}

TEST(PointMass, GainsTheEnergyThatThrustAndDragLeave) {
  // specific excess power (T - D) V / m; Raymer, eq. 17.89
  for (const double bank : {0.0, 1.0})
    for (const double throttle : {0.0, 1.0, 2.0}) {
      TestFlight f(simple_airframe());
      f.start(6000, 0.5, 280);
      f.kinematics.load_factor = 3;
      f.kinematics.roll = bank;
      f.propulsion.throttle = throttle;
      const FlightCondition c = f.condition();
      const double speed = f.kinematics.speed, before = f.energy();
      f.step({.load_factor = 3, .bank = bank, .throttle = throttle});
      const double power = (Engine::thrust_of(c.thrust, throttle) - c.drag(3)) / c.mass * 0.5 *
                           (speed + f.kinematics.speed);
      EXPECT_NEAR((f.energy() - before) / test::kDt, power, 0.05 + 1e-4 * std::fabs(power));
    }
}

struct Turn {
  double speed, load_factor;     // m/s, g
  double degrees_per_s, radius;  // closed form: g sqrt(n^2 - 1) / V and V^2 / (g sqrt(n^2 - 1))
};

TEST(PointMass, TurnsAtTheRateAndRadiusOfTheClosedForm) {
  for (const Turn& turn : {Turn{250, 9, 20.1, 713}, {300, 5, 9.2, 1873}, {200, 7, 19.5, 589}}) {
    TestFlight f(ideal_airframe());
    f.start(5000, 0, turn.speed);
    const double bank = std::acos(1 / turn.load_factor);
    f.kinematics.load_factor = turn.load_factor;
    f.kinematics.roll = bank;
    double turned = 0, last = 0;
    const Vec3 start = f.kinematics.position;
    double farthest = 0;
    while (turned < kTau) {
      f.step({.load_factor = turn.load_factor, .bank = bank});
      turned += angle_between(last, f.kinematics.heading);
      last = f.kinematics.heading;
      farthest = std::max(farthest, norm(f.kinematics.position - start));
      ASSERT_NEAR(f.kinematics.altitude, 5000, 0.5);
    }
    const double closed = kGravity * std::sqrt(turn.load_factor * turn.load_factor - 1);
    EXPECT_NEAR(degrees(turned / f.time), degrees(closed / turn.speed), 0.005);
    EXPECT_NEAR(degrees(turned / f.time), turn.degrees_per_s, 0.06);
    EXPECT_NEAR(farthest / 2, turn.speed * turn.speed / closed, 1);
    EXPECT_NEAR(farthest / 2, turn.radius, 1.5);
  }
}

TEST(PointMass, FliesLeftAsItFliesRight) {
  TestFlight right(simple_airframe()), left(simple_airframe());
  for (TestFlight* f : {&right, &left})
    f->start(6000, 0, 250);
  for (int i = 0; i < 50 * 60; ++i) {
    const double n = 1 + 3 * std::fabs(std::sin(0.2 * right.time)), bank = std::sin(right.time);
    right.step({.load_factor = n, .bank = bank, .throttle = 1.5});
    left.step({.load_factor = n, .bank = -bank, .throttle = 1.5});
    const Kinematics &r = right.kinematics, &l = left.kinematics;
    ASSERT_NEAR(r.position.x, l.position.x, 1e-6);
    ASSERT_NEAR(r.position.y, -l.position.y, 1e-6);
    ASSERT_NEAR(r.altitude, l.altitude, 1e-6);
    ASSERT_NEAR(r.heading, -l.heading, 1e-8);
    ASSERT_NEAR(r.speed, l.speed, 1e-9);
    ASSERT_NEAR(r.roll, -l.roll, 1e-9);
  }
  EXPECT_GT(norm(right.kinematics.position), 1000);
}

TEST(PointMass, PullsNoHarderThanTheWingAndTheStructureAllow) {
  TestFlight slow(simple_airframe());
  slow.start(3000, 0, 110);
  const double limit = slow.condition().lift_limit;
  // q S C_Lmax / W
  const Air air = standard_air(3000);
  EXPECT_NEAR(limit, 0.5 * air.density * 110 * 110 * 30 * 1.2 / (13000 * kGravity), 1e-6);
  for (int i = 0; i < 100; ++i)
    slow.step({.load_factor = 9, .throttle = 1});
  EXPECT_LE(slow.kinematics.load_factor, slow.condition().lift_limit * 1.05);

  TestFlight fast(simple_airframe());
  fast.start(1000, 0, 330);
  for (int i = 0; i < 150; ++i)
    fast.step({.load_factor = 20, .bank = 1.4, .throttle = 2});
  EXPECT_DOUBLE_EQ(fast.kinematics.load_factor, 9);
}

TEST(PointMass, RollsAndPullsAtItsRates) {
  TestFlight f(simple_airframe());
  const FlightLimits& limits = f.model.airframe().limits;
  f.start(5000, 0, 300);
  f.step({.load_factor = 5, .bank = 1.5});
  EXPECT_NEAR(f.kinematics.roll, limits.roll_rate * test::kDt, 1e-12);
  EXPECT_NEAR(f.kinematics.load_factor, 1 + limits.load_factor_rate * test::kDt, 1e-12);
  f.kinematics.roll = radians(170);
  f.step({.bank = radians(-170)});
  EXPECT_GT(std::fabs(f.kinematics.roll), radians(170)) << "the short way is through inverted";
}

TEST(PointMass, FliesALoop) {
  TestFlight f(ideal_airframe());
  f.start(5000, radians(30), 300);
  f.kinematics.load_factor = 4;
  double highest = 0;
  bool inverted = false;
  int steps = 0;
  do {
    f.step({.load_factor = 4, .bank = f.kinematics.roll});
    highest = std::max(highest, f.kinematics.altitude);
    inverted = inverted || std::fabs(f.kinematics.roll) > 3;
    ASSERT_LE(std::fabs(f.kinematics.pitch), kPi / 2 + 1e-12);
  } while (++steps < 50 * 120 &&
           !(inverted && std::fabs(f.kinematics.roll) < 0.1 && f.kinematics.pitch > -0.05));
  EXPECT_TRUE(inverted);
  EXPECT_GT(highest, 6000);
  EXPECT_NEAR(degrees(f.kinematics.heading), 30, 0.5);
  EXPECT_NEAR(f.kinematics.roll, 0, 0.01);
}

TEST(PointMass, IsBlownAlongByTheWind) {
  TestFlight f(ideal_airframe());
  const std::vector<WindLayer> west = {{.speed = 30, .from = radians(270)}};
  f.environment.wind = Wind(west);
  f.start(5000, 0, 250);
  EXPECT_NEAR(dot(f.kinematics.velocity, f.kinematics.east), 30, 1e-9);
  const Vec3 start = f.kinematics.position;
  for (int i = 0; i < 500; ++i)
    f.step({});
  const Vec3 moved = f.kinematics.position - start;
  EXPECT_NEAR(moved.x, 2500, 2);
  EXPECT_NEAR(moved.y, 300, 1);
  EXPECT_NEAR(f.kinematics.speed, 250, 0.1) << "wind does not change the airspeed";
}

TEST(PointMass, HasTheTablesOfItsAirframe) {
  Airframe a = simple_airframe();
  a.aerodynamics.zero_lift_drag = Table1({0, 0.9, 1.1, 2}, {0.02, 0.02, 0.045, 0.035});
  a.aerodynamics.induced_drag = Table1({0, 1, 2}, {0.12, 0.13, 0.3});
  a.engine.military = Table2({0, 0.8, 1.5}, {0, 8000, 15000}, {9, 6, 3, 8, 6, 4, 7, 5, 3});
  a.engine.afterburner = Table2({0, 1.2}, {0, 11000}, {20, 12, 24, 15});
  const PointMass model(a);
  for (double mach = 0.05; mach < 2.2; mach += 0.07)
    for (double altitude = 0; altitude < 18000; altitude += 700) {
      const Air air = standard_air(altitude);
      Kinematics k;
      k.speed = mach * air.speed_of_sound;
      k.altitude = altitude;
      const FlightCondition c = Equations<double>({&model}).condition(k, air, 1000.0, {});
      const double qs = 0.5 * air.density * k.speed * k.speed * 30;
      ASSERT_NEAR(c.zero_lift_drag / qs, a.aerodynamics.zero_lift_drag(c.mach), 1e-9);
      ASSERT_NEAR(c.thrust.military, a.engine.military(c.mach, altitude), 1e-9);
      ASSERT_NEAR(c.thrust.afterburner, a.engine.afterburner(c.mach, altitude), 1e-9);
      const double weight = c.mass * kGravity;
      ASSERT_NEAR(c.induced_drag * qs / (weight * weight), a.aerodynamics.induced_drag(c.mach),
                  1e-9);
    }
}

TEST(PointMass, CarriesItsFuelAndStores) {
  TestFlight f(simple_airframe());
  const FlightCondition clean = f.condition();
  EXPECT_DOUBLE_EQ(clean.mass, 13000);
  f.load = {.mass = 600, .drag_area = 0.1};
  f.propulsion.fuel = 1000;
  const FlightCondition loaded = f.condition();
  EXPECT_DOUBLE_EQ(loaded.mass, 11600);
  const double q = 0.5 * standard_air(f.kinematics.altitude).density * 250 * 250;
  EXPECT_NEAR(loaded.zero_lift_drag - clean.zero_lift_drag, 0.1 * q, 1e-3);
}

TEST(PointMass, DragGrowsFasterOnceTheFlowSeparates) {
  Airframe a = simple_airframe();
  a.aerodynamics.separation_lift = 0.4;
  a.aerodynamics.separation_drag = 0.3;
  TestFlight f(a);
  const FlightCondition c = f.condition();
  const double qs = 0.5 * standard_air(f.kinematics.altitude).density * 250 * 250 * 30;
  const double weight = c.mass * kGravity;
  for (const double lift : {0.2, 0.4, 0.8, 1.1}) {
    const double n = lift * qs / weight, beyond = std::max(lift - 0.4, 0.0);
    const double closed = 0.02 + 0.12 * lift * lift + 0.3 * beyond * beyond;
    EXPECT_NEAR(c.drag(n) / qs, closed, 1e-6) << lift;
    EXPECT_NEAR(c.drag(-n) / qs, closed, 1e-6) << lift;
  }
}

TEST(PointMass, HasNeitherThrustNorFlowWithoutFuel) {
  TestFlight f(simple_airframe());
  f.propulsion = {.fuel = 0, .flow = 1, .throttle = 2, .thrust = 1};
  f.step({.throttle = 2});
  EXPECT_EQ(f.propulsion.thrust, 0);
  EXPECT_EQ(f.propulsion.flow, 0);
  EXPECT_EQ(f.propulsion.throttle, 0);
}

TEST(PointMass, IsIntegratedToSecondOrder) {
  // a pull-up with roll, at two step lengths, against a much shorter one
  const auto end = [](double dt) {
    TestFlight f(ideal_airframe());
    f.start(6000, 0, 250);
    Kinematics k = f.kinematics;
    k.load_factor = 4;
    k.roll = 0.7;
    const FlightCondition condition = f.condition();
    for (int i = 0; i < static_cast<int>(std::lround(6 / dt)); ++i)
      Equations<double>({&f.model})
          .step(k, math::sin_cos(k.pitch), f.propulsion, condition, {.load_factor = 4, .bank = 0.7},
                {}, dt);
    return k.position;
  };
  const Vec3 exact = end(0.001);
  const double coarse = norm(end(0.1) - exact), fine = norm(end(0.02) - exact);
  EXPECT_LT(fine, coarse / 20);
  EXPECT_LT(fine, 0.05);
}

TEST(PointMass, PushesNoHarderThanTheWingAllows) {
  TestFlight f(simple_airframe());
  f.start(3000, 0, 105);
  const double limit = f.condition().lift_limit;
  ASSERT_LT(limit, 3);
  for (int i = 0; i < 50; ++i)
    f.step({.load_factor = -3});
  EXPECT_NEAR(f.kinematics.load_factor, -f.condition().lift_limit, 0.05);
}

TEST(PointMass, KnowsTheEnergyOfItsAircraft) {
  Airframe a = test::simple_airframe();
  for (const double separation : {100.0, 0.4}) {
    a.aerodynamics.separation_lift = separation;
    a.aerodynamics.separation_drag = 0.2;
    TestFlight f(a);
    f.start(3000, 0, 200);
    const FlightCondition c = f.condition();
    const EnergyOf<double> energy = energy_of<double>({&f.model}, c, 200);
    EXPECT_NEAR(energy.available, std::min(9.0, c.lift_limit), 1e-5);
    // what is sustained is what makes drag equal thrust
    ASSERT_LT(energy.sustained, energy.available);
    EXPECT_NEAR(c.drag(energy.sustained), c.thrust.afterburner, 1e-4 * c.thrust.afterburner);
    EXPECT_NEAR(energy.excess_power, (c.thrust.afterburner - c.drag(1)) * 200 / (c.mass * kGravity),
                1e-3);
    f.start(3000, 0, energy.corner_speed);
    EXPECT_NEAR(f.condition().lift_limit, 9, 0.01) << "at corner speed the wing gives the limit";
  }
}

TEST(PointMass, FindsCornerSpeedWhereLiftFallsWithTheMachNumber) {
  Airframe a = test::simple_airframe();
  a.aerodynamics.max_lift = Table1({0, 0.5, 1, 1.5}, {1.6, 1.4, 1, 0.7});
  for (const double speed : {120.0, 250.0, 400.0}) {
    TestFlight f(a);
    f.start(6000, 0, speed);
    const EnergyOf<double> energy = energy_of<double>({&f.model}, f.condition(), speed);
    f.start(6000, 0, energy.corner_speed);
    EXPECT_NEAR(f.condition().lift_limit, 9, 0.2) << speed;
  }
}

}  // namespace
}  // namespace eyrie::model::flight
