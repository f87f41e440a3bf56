// SPDX-License-Identifier: MIT
#include "model/weapon/line_of_sight.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/angle.hpp"

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

}  // namespace
}  // namespace eyrie::model::weapon
