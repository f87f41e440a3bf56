// SPDX-License-Identifier: MIT
#include "model/weapon/guidance.hpp"

#include <gtest/gtest.h>

#include "model/weapon/closest_approach.hpp"
#include "model/weapon/flyout.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

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

}  // namespace
}  // namespace eyrie::model::weapon
