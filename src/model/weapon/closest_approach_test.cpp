// SPDX-License-Identifier: MIT
#include "model/weapon/closest_approach.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace eyrie::model::weapon {
namespace {

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

}  // namespace
}  // namespace eyrie::model::weapon
