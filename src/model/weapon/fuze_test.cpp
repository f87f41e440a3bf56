// SPDX-License-Identifier: MIT
#include "model/weapon/fuze.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/draw.hpp"

namespace eyrie::model::weapon {
namespace {

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
