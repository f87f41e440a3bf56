// SPDX-License-Identifier: MIT
#include "model/weapon/engagement.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kAtmosphere;
using test::medium_range;

LaunchSituation shooting_level(double altitude, double aspect) {
  return {.shooter_altitude = altitude,
          .target_altitude = altitude,
          .shooter_speed = 300,
          .target_speed = 300,
          .aspect = aspect};
}

TEST(Engagement, HitsATargetThatKeepsItsCourse) {
  for (const double aspect : {0.0, 0.5, 1.2, 2.0, kPi}) {
    const EngagementResult r =
        engage(medium_range(), kAtmosphere,
               {.situation = shooting_level(8000, aspect), .range = 10e3, .longest_step = 0.02});
    EXPECT_LT(r.miss, 1) << aspect;
    EXPECT_TRUE(r.success(medium_range())) << aspect;
  }
}

TEST(Engagement, HitsATargetThatTurnsAwayFromCloseBy) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere,
             {.situation = shooting_level(8000, 0.3), .range = 12e3, .escape = Escape::run});
  EXPECT_TRUE(r.success(medium_range()));
}

TEST(Engagement, FailsOutOfReach) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = shooting_level(8000, kPi), .range = 60e3});
  EXPECT_FALSE(r.success(medium_range()));
}

TEST(Engagement, FailsBeforeTheWarheadIsArmed) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = shooting_level(8000, 0), .range = 400});
  EXPECT_FALSE(r.armed);
  EXPECT_FALSE(r.success(medium_range()));
}

TEST(Engagement, StaysWithinTheLoadFactor) {
  LaunchSituation s = shooting_level(2000, 1.2);
  s.off_boresight = 1;
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = s, .range = 6e3, .escape = Escape::run});
  const double limit = medium_range().aero.greatest_load_factor * kGravity;
  EXPECT_GT(r.greatest_lift, 0.2 * limit);
  EXPECT_LE(r.greatest_lift, limit * (1 + 1e-12));
}

TEST(Engagement, ClimbsWhenItLofts) {
  const Engagement far{.situation = shooting_level(8000, 0), .range = 50e3};
  MissileType direct = medium_range();
  direct.guidance.loft.reset();
  const EngagementResult lofted = engage(medium_range(), kAtmosphere, far);
  const EngagementResult flat = engage(direct, kAtmosphere, far);
  EXPECT_GT(lofted.greatest_altitude, 9000);
  EXPECT_LT(flat.greatest_altitude, 8100);
  EXPECT_GT(lofted.speed, flat.speed);
}

TEST(Engagement, FliesAlmostTheSameInLongSteps) {
  Engagement e{.situation = shooting_level(9000, 0.4), .range = 35e3};
  const EngagementResult coarse = engage(medium_range(), kAtmosphere, e);
  e.longest_step = 0.02;
  const EngagementResult fine = engage(medium_range(), kAtmosphere, e);
  EXPECT_NEAR(coarse.time, fine.time, 0.02 * fine.time);
  EXPECT_NEAR(coarse.speed, fine.speed, 0.03 * fine.speed);
}

}  // namespace
}  // namespace eyrie::model::weapon
