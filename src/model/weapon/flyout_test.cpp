// SPDX-License-Identifier: MIT
#include "model/weapon/flyout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "model/weapon/line_of_sight.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kAtmosphere;
using test::kDown;
using test::short_range;

/// Flies for `seconds` with a constant wish.
Flyout flown(const MissileType& type, Flyout state, double age, double seconds, double dt,
             const Vec3& wanted = {}) {
  const int steps = static_cast<int>(std::lround(seconds / dt));
  for (int i = 0; i < steps; ++i)
    fly(type, kAtmosphere.at(-state.position.z), {}, kDown, age + i * dt, dt, wanted, state);
  return state;
}

TEST(Flyout, FallsLikeAStoneWhereThereIsNoAir) {
  MissileType type = short_range();
  type.motor.thrust = Table1({0, 1}, {0, 0});
  type.motor.nozzle_area = 0;
  Flyout state{.position = {}, .velocity = {200, 0, 0}};
  for (int i = 0; i < 50; ++i)
    fly(type, Air{.speed_of_sound = 300}, {}, kDown, 0, 0.02, {}, state);
  EXPECT_NEAR(state.position.x, 200, 0.05);
  EXPECT_NEAR(state.position.z, kGravity / 2, 0.02);
  EXPECT_NEAR(norm2(state.velocity) / 2 - kGravity * state.position.z, 20000, 10);
}

TEST(Flyout, GainsWhatTheMotorGivesLessDrag) {
  const MissileType type = short_range();
  const Flyout high = flown(type, {.position = {0, 0, -20e3}, .velocity = {300, 0, 0}}, 0, 3, 0.02);
  const Flyout low = flown(type, {.position = {0, 0, -100}, .velocity = {300, 0, 0}}, 0, 3, 0.02);
  const double ideal = type.motor.ideal_speed_gain();
  // the nozzle gives more in thin air than at sea level, where the ideal gain is counted
  EXPECT_GT(norm(high.velocity) - 300, 0.97 * ideal);
  EXPECT_LT(norm(high.velocity) - 300, 1.08 * ideal);
  EXPECT_LT(norm(low.velocity) - 300, 0.85 * ideal);
}

TEST(Flyout, NeverPullsMoreThanItsLoadFactor) {
  const MissileType type = short_range();
  const double limit = type.aero.greatest_load_factor * kGravity;
  Flyout state{.position = {0, 0, -1000}, .velocity = {900, 0, 0}};
  double greatest = 0;
  for (int i = 0; i < 50; ++i) {
    state = flown(type, state, 10, 0.02, 0.02, 1e5 * cross(kDown, state.velocity));
    greatest = std::max(greatest, norm(state.lift));
  }
  EXPECT_LE(greatest, limit * (1 + 1e-12));
  EXPECT_GT(greatest, 0.99 * limit);
}

TEST(Flyout, HasLessLiftInThinnerAirAndAtLessSpeed) {
  const MissileType type = short_range();
  const auto limit = [&](double altitude, double speed) {
    return flyout_forces(type, kAtmosphere.at(altitude), speed, 10).lift_limit;
  };
  EXPECT_LT(limit(15e3, 600), limit(10e3, 600));
  EXPECT_LT(limit(15e3, 400), limit(15e3, 600));
  // q S C_L / m, away from the load factor limit: a closed form
  const Air air = kAtmosphere.at(15e3);
  const double mach = 600 / air.speed_of_sound;
  EXPECT_NEAR(limit(15e3, 600),
              0.5 * air.density * 600 * 600 * 0.01767 * type.aero.greatest_lift(mach) / 38.6, 1e-9);
}

TEST(Flyout, BleedsEnergyInATurn) {
  const MissileType type = short_range();
  const Flyout start{.position = {0, 0, -6000}, .velocity = {900, 0, 0}};
  const double straight = norm(flown(type, start, 5, 2, 0.02, {0, 0, -kGravity}).velocity);
  const double turning = norm(flown(type, start, 5, 2, 0.02, {0, 150, -kGravity}).velocity);
  EXPECT_LT(turning, straight - 20);
  EXPECT_LT(straight, 900);
}

TEST(Flyout, TurnsOnACircleOfSpeedSquaredOverLift) {
  MissileType type = short_range();
  type.aero.drag_power_off = Table1::constant(1e-9);
  type.aero.induced_drag = Table1::constant(0);
  Flyout state{.position = {0, 0, -5000}, .velocity = {800, 0, 0}, .lift = {0, 200, 0}};
  const double quarter = (kPi / 2) * 800 / 200;
  const int steps = static_cast<int>(std::lround(quarter / 0.002));
  for (int i = 0; i < steps; ++i) {
    const Vec3 across = cross(kDown, normalized(state.velocity, {1, 0, 0}));
    fly(type, kAtmosphere.at(5000), {}, kDown, 10, 0.002, 200 * across - kGravity * kDown, state);
  }
  const double radius = 800.0 * 800 / 200;
  EXPECT_NEAR(state.position.x, radius, 0.01 * radius);
  EXPECT_NEAR(state.position.y, radius, 0.01 * radius);
  EXPECT_NEAR(norm(state.velocity), 800, 1);
}

TEST(Flyout, FollowsItsAutopilotWithTheLag) {
  const MissileType type = short_range();
  Flyout state{.position = {0, 0, -3000}, .velocity = {900, 0, 0}};
  // after one time constant 63 % of the wish is there
  state = flown(type, state, 10, 0.1, 0.02, {0, 0, -100});
  EXPECT_NEAR(norm(state.lift), 63.2, 1.5);
}

TEST(Flyout, DoesNotDependOnTheLengthOfTheStep) {
  const MissileType type = short_range();
  const Flyout start{.position = {0, 0, -8000}, .velocity = {280, 0, 0}};
  const Vec3 wish{0, 40, -kGravity};
  const Flyout coarse = flown(type, start, 0, 12, 0.02, wish);
  const Flyout fine = flown(type, start, 0, 12, 0.001, wish);
  EXPECT_NEAR(norm(coarse.velocity), norm(fine.velocity), 0.005 * norm(fine.velocity));
  EXPECT_LT(norm(coarse.position - fine.position), 0.005 * norm(fine.position - start.position));
}

TEST(Flyout, IsCarriedByTheWind) {
  const MissileType type = short_range();
  Flyout calm{.position = {0, 0, -8000}, .velocity = {700, 0, 0}};
  Flyout windy{.position = {0, 0, -8000}, .velocity = {700, 30, 0}};
  const Vec3 wind{0, 30, 0};
  for (int i = 0; i < 100; ++i) {
    const Air air = kAtmosphere.at(8000);
    fly(type, air, {}, kDown, 5, 0.02, {0, 0, -kGravity}, calm);
    fly(type, air, wind, kDown, 5, 0.02, {0, 0, -kGravity}, windy);
  }
  EXPECT_NEAR(windy.position.y - calm.position.y, 30 * 2, 1e-6);
  EXPECT_NEAR(windy.position.x, calm.position.x, 1e-6);
}

RC_GTEST_PROP(Flyout, OfAMirroredSceneIsTheMirrorImage, ()) {
  const MissileType type = short_range();
  const auto mirror = [](const Vec3& v) { return Vec3{v.x, -v.y, v.z}; };
  const auto number = [](int limit) { return *rc::gen::inRange(-limit, limit) / 3.0; };
  const Flyout start{.position = {0, 10, -9000}, .velocity = {600, number(900), number(300)}};
  const Vec3 wish{number(300), number(900), number(900)};
  const Flyout left = flown(type, start, 0, 2, 0.02, wish);
  const Flyout right =
      flown(type, {.position = mirror(start.position), .velocity = mirror(start.velocity)}, 0, 2,
            0.02, mirror(wish));
  // bit for bit: a change of sign commutes with every operation
  RC_ASSERT(right.position == mirror(left.position));
  RC_ASSERT(right.velocity == mirror(left.velocity));
  RC_ASSERT(right.lift == mirror(left.lift));
}

}  // namespace
}  // namespace eyrie::model::weapon
