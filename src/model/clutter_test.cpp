// SPDX-License-Identifier: MIT
#include "model/clutter.hpp"

#include <gtest/gtest.h>

namespace eyrie::model {
namespace {

constexpr LookDown kSeeker{.altitude = 8000, .sine = 0.3, .beam = 0.2, .cell = 150};

TEST(Clutter, IsWhatOneRangeCellOfTheGroundScatters) {
  // by hand: 26,667 m to the ground, 0.003 m2 per m2, 5,333 m x 157 m of it: 2,516 m2
  const double ground = 8000 / 0.3;
  const double clutter = 0.01 * 0.3 * ground * 0.2 * 150 / std::sqrt(1 - 0.09);
  EXPECT_NEAR(clutter, 2516, 1);
  EXPECT_NEAR(signal_to_clutter(kSeeker, 30, ground), 30 / clutter, 1e-6) << "beside the ground";
}

TEST(Clutter, FallsBehindANearTargetByTheFourthPowerOfRange) {
  EXPECT_NEAR(signal_to_clutter(kSeeker, 30, 2000) / signal_to_clutter(kSeeker, 30, 4000), 16,
              1e-9);
  EXPECT_NEAR(signal_to_clutter(kSeeker, 60, 3000) / signal_to_clutter(kSeeker, 30, 3000), 2, 1e-9);
}

TEST(Clutter, GrowsAsTheRadarGoesDownAndLooksDownMore) {
  const auto at = [](double altitude, double sine) {
    LookDown look = kSeeker;
    look.altitude = altitude;
    look.sine = sine;
    return signal_to_clutter(look, 30, 3000);
  };
  EXPECT_GT(at(8000, 0.3), at(4000, 0.3));
  EXPECT_GT(at(8000, 0.1), at(8000, 0.3));
  EXPECT_LT(at(8000, 0.01) / at(8000, 0.02), 2) << "by the middle of the beam it would be 16";
  EXPECT_GT(at(8000, 1), 0) << "straight down the footprint is the cell";
  EXPECT_EQ(at(0, 0.3), 0);
}

}  // namespace
}  // namespace eyrie::model
