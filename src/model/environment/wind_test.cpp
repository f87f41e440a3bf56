// SPDX-License-Identifier: MIT
#include "model/environment/wind.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/angle.hpp"

namespace eyrie::model {
namespace {

TEST(Wind, IsCalmWithoutLayers) {
  EXPECT_TRUE(Wind().calm());
  EXPECT_EQ(Wind().at(5000), Vec3());
}

TEST(Wind, BlowsAwayFromWhereItComesFrom) {
  const std::vector<WindLayer> west = {{.altitude = 0, .speed = 20, .from = radians(270)}};
  const Vec3 v = Wind(west).at(12000);
  EXPECT_NEAR(v.x, 0, 1e-12);
  EXPECT_NEAR(v.y, 20, 1e-12);
  EXPECT_EQ(v.z, 0);
}

TEST(Wind, ChangesLinearlyBetweenLayersAndStaysBeyondThem) {
  const Wind wind(std::vector<WindLayer>{{.altitude = 1000, .speed = 10, .from = 0},
                                         {.altitude = 3000, .speed = 30, .from = 0}});
  EXPECT_NEAR(wind.at(0).x, -10, 1e-12);
  EXPECT_NEAR(wind.at(1500).x, -15, 1e-12);
  EXPECT_NEAR(wind.at(2000).x, -20, 1e-12);
  EXPECT_NEAR(wind.at(20000).x, -30, 1e-12);
}

TEST(Wind, RefusesLayersOutOfOrder) {
  const std::vector<WindLayer> same = {{.altitude = 1000, .speed = 10},
                                       {.altitude = 1000, .speed = 20}};
  ASSERT_TRUE(Wind::problem(same));
  EXPECT_NE(Wind::problem(same)->find("low to high"), std::string::npos);
  EXPECT_THROW(Wind{same}, std::logic_error);
}

}  // namespace
}  // namespace eyrie::model
