// SPDX-License-Identifier: MIT
#include "model/signature.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/model/flying.hpp"

namespace eyrie::model {
namespace {

constexpr Signature kFighter{.rcs_front = 10, .rcs_side = 60, .rcs_rear = 20};

TEST(RadarCrossSection, IsWhatWasGivenNoseOnAbeamAndTailOn) {
  EXPECT_DOUBLE_EQ(radar_cross_section(kFighter, 1), 10);
  EXPECT_DOUBLE_EQ(radar_cross_section(kFighter, 0), 60);
  EXPECT_DOUBLE_EQ(radar_cross_section(kFighter, -1), 20);
}

TEST(RadarCrossSection, FollowsTheSineSquaredOfTheAspect) {
  for (double degrees = 0; degrees <= 90; degrees += 7.5) {
    const double s = std::sin(radians(degrees));
    EXPECT_NEAR(radar_cross_section(kFighter, std::cos(radians(degrees))), 10 + 50 * s * s, 1e-12);
  }
}

RC_GTEST_PROP(RadarCrossSection, HasNoJumpAndStaysBetweenItsEnds, ()) {
  const double c = 0.001 * *rc::gen::inRange(-1000, 1000);
  const double here = radar_cross_section(kFighter, c);
  RC_ASSERT(here >= 10 && here <= 60);
  RC_ASSERT(std::fabs(radar_cross_section(kFighter, c + 0.001) - here) < 60 * 2 * 0.001);
}

RC_GTEST_PROP(Silhouette, IsTheSameFromLeftAndRight, ()) {
  const auto part = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
  const Axes target = body_axes(test::flying({}, 0, 200));
  const Vec3 from = normalized({part(), part(), part()}, {1, 0, 0});
  RC_ASSERT(silhouette(kFighter, target, from) ==
            silhouette(kFighter, target, test::mirrored(from)));
}

TEST(Silhouette, OfASphereIsTheSameFromEverywhere) {
  const Signature sphere{.area_front = 7, .area_side = 7, .area_top = 7};
  const Axes target = body_axes(test::flying({}, 1, 200, 0.3, 0.9));
  EXPECT_NEAR(silhouette(sphere, target, normalized({1, 2, -3}, {})), 7, 1e-12);
}

}  // namespace
}  // namespace eyrie::model
