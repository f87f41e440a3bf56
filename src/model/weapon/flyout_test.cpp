// SPDX-License-Identifier: MIT
#include "model/weapon/flyout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/angle.hpp"
#include "core/draw.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

TEST(LineOfSight, OfACrossingTargetTurnsAtSpeedOverRange) {
  const LineOfSight los = line_of_sight({1000, 0, 0}, {0, 250, 0});
  EXPECT_EQ(los.direction, (Vec3{1, 0, 0}));
  EXPECT_DOUBLE_EQ(los.range, 1000);
  EXPECT_DOUBLE_EQ(los.closing, 0);
  EXPECT_EQ(los.rate, (Vec3{0, 0, 0.25}));
}

TEST(LineOfSight, OfAHeadOnTargetClosesAndDoesNotTurn) {
  const LineOfSight los = line_of_sight({0, 0, -2000}, {0, 0, 300});
  EXPECT_DOUBLE_EQ(los.closing, 300);
  EXPECT_EQ(los.rate, Vec3{});
}

TEST(Autopilot, MayAnswerAtOnce) {
  MissileType type;
  type.guidance.autopilot_lag = 1e-200;
  Flyout missile{.position = {0, 0, -8000}, .velocity = {900, 0, 0}};
  fly(type, Atmosphere{}.at(8000), {}, {0, 0, 1}, 60, 0.02, {0, 50, 0}, missile);
  EXPECT_NEAR(missile.lift.y, 50, 1e-3);
}

TEST(LineOfSight, AtNoDistanceTurnsNowhere) {
  const LineOfSight los = line_of_sight({}, {300, 0, 0});
  EXPECT_EQ(los.rate, Vec3{});
  EXPECT_DOUBLE_EQ(norm(los.direction), 1);
}

TEST(ProportionalNavigation, PullsAfterTheTarget) {
  // the target crosses to the right: the command points there, N * V * rate strong
  const LineOfSight los = line_of_sight({5000, 0, 0}, {-800, 100, 0});
  const Vec3 command = proportional_navigation(4, los.closing, los);
  EXPECT_NEAR(command.x, 0, 1e-12);
  EXPECT_NEAR(command.y, 4 * 800 * (100.0 / 5000), 1e-9);
  EXPECT_NEAR(command.z, 0, 1e-12);
}

RC_GTEST_PROP(ProportionalNavigation, AsksForNothingOnACollisionCourse, ()) {
  const auto number = [] { return *rc::gen::inRange(-10000, 10000) + 0.5; };
  const Vec3 apart{number(), number(), number()};
  const double to_go = *rc::gen::inRange(1, 100);
  const LineOfSight los = line_of_sight(apart, -apart / to_go);
  RC_ASSERT(norm(proportional_navigation(4, los.closing, los)) < 1e-6);
}

RC_GTEST_PROP(Perpendicular, LeavesNothingAlongTheAxis, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 10.0; };
  const Vec3 axis = normalized({number(), number(), number()}, {1, 0, 0});
  const Vec3 v{number(), number(), number()};
  RC_ASSERT(std::fabs(dot(perpendicular(v, axis), axis)) < 1e-10);
}

TEST(Limited, KeepsTheDirection) {
  EXPECT_EQ(limited({3, 4, 0}, 10), (Vec3{3, 4, 0}));
  const Vec3 cut = limited({30, 40, 0}, 10);
  EXPECT_NEAR(cut.x, 6, 1e-12);
  EXPECT_NEAR(cut.y, 8, 1e-12);
}

using test::kAtmosphere;
using test::kDown;
using test::short_range;

struct Shot {
  Vec3 target{6000, 0, -6000}, target_velocity{-200, 150, 0}, acceleration{};
  double gravity_bias = 1;  ///< 0: without it
};

/// Closest approach (m) of a noise-free shot from {0, 0, -6000} along x at 300 m/s.
double miss_of(const MissileType& type, const Shot& shot) {
  Flyout missile{.position = {0, 0, -6000}, .velocity = {300, 0, 0}};
  Vec3 target = shot.target, velocity = shot.target_velocity;
  double miss = 1e9;
  for (double age = 0; age < 30; age += 0.02) {
    const Vec3 apart = target - missile.position, drift = velocity - missile.velocity;
    Vec3 wanted = steer(type.guidance, line_of_sight(apart, drift), missile.velocity, kDown);
    wanted += (1 - shot.gravity_bias) * kGravity * kDown;
    fly(type, kAtmosphere.at(-missile.position.z), {}, kDown, age, 0.02, wanted, missile);
    target += 0.02 * velocity;
    velocity += 0.02 * shot.acceleration;
    const Vec3 now = target - missile.position;
    miss = std::min(miss, closest_approach(apart, (now - apart) / 0.02, 0, 0.02).distance);
  }
  return miss;
}

TEST(Steer, HitsATargetOfConstantVelocity) {
  const MissileType type = short_range();
  for (const Vec3 velocity : {Vec3{-250, 0, 0}, Vec3{-200, 150, 0}, Vec3{0, 250, 0},
                              Vec3{200, 100, 0}, Vec3{-150, 100, 60}, Vec3{100, -150, -80}})
    EXPECT_LT(miss_of(type, {.target_velocity = velocity}), 1)
        << velocity.x << " " << velocity.y << " " << velocity.z;
}

TEST(Steer, MissesAManeuveringTargetMoreWithLessGain) {
  // Zarchan, ch. 2: the acceleration needed against a maneuver is N / (N - 2) times the target's,
  // so a gain of 2 never suffices
  MissileType type = short_range();
  const Shot shot{.acceleration = {0, 40, 0}};
  type.guidance.navigation_gain = 2;
  const double low = miss_of(type, shot);
  type.guidance.navigation_gain = 4;
  const double high = miss_of(type, shot);
  EXPECT_GT(low, 5);
  EXPECT_LT(high, low / 5);
}

TEST(Steer, TakesOutGravity) {
  // level behind a target that flies away: without the bias it sags below the line of sight
  const MissileType type = short_range();
  const LineOfSight los = line_of_sight({5000, 0, 0}, {-300, 0, 0});
  const Vec3 wanted = steer(type.guidance, los, {600, 0, 0}, kDown);
  EXPECT_EQ(wanted, (Vec3{0, 0, -kGravity}));
  const Shot away{.target_velocity = {250, 0, 0}};
  Shot sagging = away;
  sagging.gravity_bias = 0;
  EXPECT_LT(miss_of(type, away), 1);
  EXPECT_GT(miss_of(type, sagging), miss_of(type, away));
}

TEST(Steer, TurnsTowardsATargetFarOffTheFlightPath) {
  const MissileType type = short_range();
  // abeam and receding: the line of sight hardly turns, yet it must come about
  const LineOfSight los = line_of_sight({0, 20e3, 0}, {-300, 250, 0});
  const Vec3 wanted = steer(type.guidance, los, {300, 0, 0}, kDown);
  EXPECT_GT(wanted.y, 30 * kGravity);
  // and inside 45 degrees only proportional navigation speaks
  const LineOfSight ahead = line_of_sight({20e3, 10e3, 0}, {-600, 0, 0});
  const Vec3 gentle = steer(type.guidance, ahead, {300, 0, 0}, kDown);
  EXPECT_LT(norm(gentle + kGravity * kDown - proportional_navigation(4, ahead.closing, ahead)),
            1e-9);
}

TEST(Lofted, AimsAboveADistantTargetOnly) {
  const Loft loft{.angle = 0.1, .end_range = 20e3, .ceiling = 25e3};
  EXPECT_EQ(lofted(loft, {15e3, 0, 0}, kDown, 8000), (Vec3{15e3, 0, 0}));
  const Vec3 aim = lofted(loft, {50e3, 0, 0}, kDown, 8000);
  EXPECT_DOUBLE_EQ(aim.x, 50e3);
  EXPECT_NEAR(-aim.z, 30e3 * std::tan(0.1), 1e-6);
}

TEST(Lofted, StaysBelowTheCeiling) {
  const Loft loft{.angle = 0.5, .end_range = 20e3, .ceiling = 25e3};
  const Vec3 aim = lofted(loft, {100e3, 0, 0}, kDown, 10e3);
  EXPECT_NEAR(10e3 - aim.z, 25e3, 1e-6);
  EXPECT_EQ(lofted(loft, {100e3, 0, 0}, kDown, 30e3), (Vec3{100e3, 0, 0}));
}

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
  const double burn = type.motor.burn_time();
  const Flyout high =
      flown(type, {.position = {0, 0, -20e3}, .velocity = {300, 0, 0}}, 0, burn, 0.02);
  const Flyout low =
      flown(type, {.position = {0, 0, -100}, .velocity = {300, 0, 0}}, 0, burn, 0.02);
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
              0.5 * air.density * 600 * 600 * 0.01267 * type.aero.greatest_lift(mach) / 63.5, 1e-9);
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

TEST(ClosestApproach, IsExactForLinearMotion) {
  // passes 7 m abeam after a quarter of a second, between any two samples of a 20 ms step
  const ClosestApproach ca = closest_approach({250, 7, 0}, {-1000, 0, 0}, 0, 1);
  EXPECT_DOUBLE_EQ(ca.time, 0.25);
  EXPECT_DOUBLE_EQ(ca.distance, 7);
  EXPECT_EQ(ca.separation, (Vec3{0, 7, 0}));
}

TEST(ClosestApproach, StaysInsideItsInterval) {
  EXPECT_DOUBLE_EQ(closest_approach({250, 7, 0}, {-1000, 0, 0}, 0, 0.1).time, 0.1);
  EXPECT_DOUBLE_EQ(closest_approach({250, 7, 0}, {1000, 0, 0}, 0, 0.1).time, 0);
  EXPECT_DOUBLE_EQ(closest_approach({-5, 7, 0}, {-1000, 0, 0}, -0.02, 0).time, -0.005);
}

TEST(ClosestApproach, OfTwoThatDoNotMoveIsNow) {
  EXPECT_DOUBLE_EQ(closest_approach({3, 4, 0}, {}, 0, 1).distance, 5);
}

RC_GTEST_PROP(ClosestApproach, IsNoFartherThanAnySample, ()) {
  const auto number = [](int limit) { return *rc::gen::inRange(-limit, limit) / 7.0; };
  const Vec3 apart{number(2000), number(2000), number(2000)};
  const Vec3 drift{number(9000), number(9000), number(9000)};
  const ClosestApproach ca = closest_approach(apart, drift, -0.02, 0);
  for (int i = 0; i <= 50; ++i)
    RC_ASSERT(ca.distance <= norm(apart + (-0.02 + 0.0004 * i) * drift) + 1e-9);
}

constexpr double kTick = 0.02;

TEST(Passage, HappensInExactlyOneStepOfAFlyBy) {
  // 1 km/s past each other, 5 m abeam, sampled every 20 m: wherever the samples lie, one step has
  // it
  for (int offset = 0; offset < 40; ++offset) {
    int passages = 0;
    double miss = 0;
    for (int i = 0; i <= 40; ++i) {
      const Vec3 apart{400.0 + offset * 0.5 - 20.0 * i, 5, 0};
      const Passage p = passage(apart, {-1000, 0, 0}, kTick);
      // a later step sees the same passage again, but the missile is gone by then
      if (p.passing && passages++ == 0)
        miss = p.nearest.distance;
    }
    EXPECT_GE(passages, 1) << offset;
    EXPECT_NEAR(miss, 5, 1e-9) << offset;
  }
}

TEST(Passage, SurvivesAVelocityThatChangesBetweenSteps) {
  // at the end of the last step it was still closing; now it has long been opening
  const Passage p = passage({22, 3, 0}, {1000, 0, 0}, kTick);
  EXPECT_TRUE(p.passing);
  EXPECT_NEAR(p.nearest.distance, norm(Vec3{2, 3, 0}), 1e-9);
}

TEST(Passage, IsNoneWhileClosingAndNoneLongAfterwards) {
  EXPECT_FALSE(passage({30, 0, 0}, {-1000, 0, 0}, kTick).passing);
  EXPECT_FALSE(passage({60, 0, 0}, {1000, 0, 0}, kTick).passing);
}

TEST(KillProbability, FollowsTheDiffuseGaussian) {
  const Warhead warhead{.lethal_radius = 8, .best_kill = 0.9};
  EXPECT_DOUBLE_EQ(kill_probability(warhead, 0), 0.9);
  EXPECT_NEAR(kill_probability(warhead, 8), 0.9 * 0.36787944117144233, 1e-15);
  EXPECT_LT(kill_probability(warhead, 30), 1e-6);
}

TEST(KillProbability, HasTheLethalAreaOfADiskOfTheLethalRadius) {
  const Warhead warhead{.lethal_radius = 8, .best_kill = 1};
  double area = 0;
  for (double r = 0.005; r < 60; r += 0.01)
    area += kill_probability(warhead, r) * kTau * r * 0.01;
  EXPECT_NEAR(area, kPi * 64, 0.01);
}

TEST(KillProbability, IsMetByDraws) {
  const Warhead warhead{.lethal_radius = 8, .best_kill = 0.9};
  const double expected = kill_probability(warhead, 4);
  int kills = 0;
  constexpr int kShots = 20000;
  for (int i = 0; i < kShots; ++i)
    kills += Draw(7, PlayerId{static_cast<std::uint32_t>(i + 1)}, Stream::lethality, 100)
                 .chance(expected);
  const double sigma = std::sqrt(expected * (1 - expected) / kShots);
  EXPECT_NEAR(double(kills) / kShots, expected, 4 * sigma);
}

RC_GTEST_PROP(KillProbability, NeverRisesWithTheMiss, ()) {
  const Warhead warhead;
  const double a = *rc::gen::inRange(0, 3000) / 100.0, b = *rc::gen::inRange(0, 3000) / 100.0;
  RC_ASSERT(kill_probability(warhead, std::min(a, b)) >= kill_probability(warhead, std::max(a, b)));
}

}  // namespace
}  // namespace eyrie::model::weapon
