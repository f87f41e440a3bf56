// SPDX-License-Identifier: MIT
#include "model/kinematics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/model/flying.hpp"

namespace eyrie::model {
namespace {

using test::flying;

TEST(BodyAxes, FollowTheNoseTheRightWingAndTheBelly) {
  const Axes climbing_right = body_axes(flying({}, radians(90), 200, radians(30), radians(90)));
  EXPECT_NEAR(norm(climbing_right.forward - Vec3{0, std::cos(kPi / 6), -0.5}), 0, 1e-12);
  EXPECT_NEAR(norm(climbing_right.right - Vec3{0, 0.5, std::cos(kPi / 6)}), 0, 1e-12);
  EXPECT_NEAR(norm(climbing_right.down - Vec3{1, 0, 0}), 0, 1e-12);
}

RC_GTEST_PROP(BodyAxes, AreARotationOfTheLocalAxes, ()) {
  const auto angle = [] { return radians(0.1 * *rc::gen::inRange(-1800, 1801)); };
  const Axes a = body_axes(flying({}, angle(), 100, angle() / 2, angle()));
  RC_ASSERT(std::fabs(norm(a.forward) - 1) < 1e-12);
  RC_ASSERT(norm(cross(a.forward, a.right) - a.down) < 1e-12);
}

TEST(LevelAxes, IgnorePitchAndRoll) {
  const Kinematics k = flying({}, radians(30), 200, radians(50), radians(-70));
  const Axes level = level_axes(k, k.heading);
  EXPECT_NEAR(level.forward.z, 0, 1e-15);
  EXPECT_NEAR(level.right.x, -0.5, 1e-12);
  EXPECT_EQ(level.down, k.down);
}

TEST(BearingOf, CountsFromNorthAndFromTheHorizontal) {
  const Bearing b = bearing_of(flying({}, radians(77), 200), normalized({0, -3, -3}, {}));
  EXPECT_NEAR(degrees(b.azimuth), -90, 1e-9);
  EXPECT_NEAR(degrees(b.elevation), 45, 1e-9);
}

TEST(HorizonRange, IsTheWellKnownRuleOfThumb) {
  // FS-1037C and textbooks: 1.23 nmi per root foot of height, for each of the two
  const double expected = 1.23 * (std::sqrt(20000.0) + std::sqrt(500.0));
  const double range = horizon_range(si(20000, "ft"), si(500, "ft"), kRadioEarth);
  EXPECT_NEAR(in_unit(range, "nmi"), expected, 0.005 * expected);
}

TEST(HorizonRange, IsNearerForTheEyeAndIgnoresDepth) {
  EXPECT_LT(horizon_range(1000, 1000, 1), horizon_range(1000, 1000, kRadioEarth));
  EXPECT_EQ(horizon_range(1000, -50, 1), horizon_range(1000, 0, 1));
}

}  // namespace
}  // namespace eyrie::model
