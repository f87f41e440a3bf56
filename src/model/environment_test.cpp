// SPDX-License-Identifier: MIT
#include "model/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/angle.hpp"

namespace eyrie::model {
namespace {

/// One printed line of U.S. Standard Atmosphere 1976 (NASA-TM-X-74335): table I gives temperature,
/// pressure and density by geometric altitude, table III the speed of sound.
struct Line {
  double altitude;        ///< m, geometric
  double temperature;     ///< K, printed to 0.001
  double millibar;        ///< printed to 5 digits
  double density;         ///< kg/m3, printed to 5 digits
  double speed_of_sound;  ///< m/s, printed to 0.01
};

const std::vector<Line> kPrinted = {
    {0, 288.150, 1.01325e3, 1.2250e0, 340.29},     {1000, 281.651, 8.9876e2, 1.1117e0, 336.43},
    {2000, 275.154, 7.9501e2, 1.0066e0, 332.53},   {5000, 255.676, 5.4048e2, 7.3643e-1, 320.55},
    {10000, 223.252, 2.6499e2, 4.1351e-1, 299.53}, {11000, 216.774, 2.2699e2, 3.6480e-1, 295.15},
    {15000, 216.650, 1.2111e2, 1.9476e-1, 295.07}, {20000, 216.650, 5.5293e1, 8.8910e-2, 295.07},
    {25000, 221.552, 2.5492e1, 4.0084e-2, 298.39}, {30000, 226.509, 1.1970e1, 1.8410e-2, 301.71},
    {32000, 228.490, 8.8906e0, 1.3555e-2, 303.02},
};

/// One unit of the fifth digit: the publication cuts digits off where it should round (it prints
/// 264.99 mb at 10 km, where 264.9990 follows from its own constants).
double last_digit(double printed) {
  return std::pow(10.0, std::floor(std::log10(printed)) - 4);
}

TEST(StandardAir, ReproducesThePublishedTableToThePrintedDigits) {
  for (const Line& line : kPrinted) {
    const Air air = standard_air(line.altitude);
    EXPECT_NEAR(air.temperature, line.temperature, 0.0005 + 1e-9) << line.altitude;
    EXPECT_NEAR(air.pressure / 100, line.millibar, last_digit(line.millibar)) << line.altitude;
    EXPECT_NEAR(air.density, line.density, last_digit(line.density)) << line.altitude;
    EXPECT_NEAR(air.speed_of_sound, line.speed_of_sound, 0.005 + 1e-9) << line.altitude;
  }
}

TEST(StandardAir, HasThePressuresOfTheLayersBases) {
  // ICAO Doc 7488/3 and ISO 2533, by geopotential altitude
  const auto geometric = [](double height) { return 6356766 * height / (6356766 - height); };
  EXPECT_NEAR(standard_air(geometric(11000)).pressure, 22632.06, 0.005);
  EXPECT_NEAR(standard_air(geometric(20000)).pressure, 5474.889, 0.0005);
  EXPECT_NEAR(standard_air(geometric(32000)).pressure, 868.0187, 0.00005);
}

TEST(StandardAir, UsesGeopotentialAltitude) {
  EXPECT_DOUBLE_EQ(geopotential(0.0), 0);
  // table I prints Z = 11019 m beside H = 11000 m, Z = 32162 m beside H = 32000 m
  EXPECT_NEAR(geopotential(11019.0), 11000, 0.5);
  EXPECT_NEAR(geopotential(32162.0), 32000, 0.5);
  EXPECT_GT(standard_air(11018).temperature, 216.65);
  EXPECT_DOUBLE_EQ(standard_air(11020).temperature, 216.65);
}

TEST(StandardAir, IsInHydrostaticBalance) {
  for (double z = -1500; z < 31900; z += 437) {
    const double step = 1;
    const double rise = geopotential(z + step) - geopotential(z - step);
    const double fall = standard_air(z - step).pressure - standard_air(z + step).pressure;
    EXPECT_NEAR(fall / rise, standard_air(z).density * kGravity, 2e-6 * fall / rise) << z;
  }
}

TEST(Atmosphere, AgreesWithItsDefinitionWithinTwoInTenMillion) {
  const Atmosphere atmosphere;
  double worst = 0;
  for (double z = -2500; z < 34000; z += 3.7) {
    const Air fast = atmosphere.at(z), exact = standard_air(z);
    worst = std::max(worst, std::fabs(fast.pressure / exact.pressure - 1));
    worst = std::max(worst, std::fabs(fast.density / exact.density - 1));
    ASSERT_EQ(fast.temperature, exact.temperature) << z;
    ASSERT_EQ(fast.speed_of_sound, exact.speed_of_sound) << z;
  }
  EXPECT_LT(worst, 2e-7);
  EXPECT_GT(worst, 1e-10) << "nothing was compared";
}

TEST(Atmosphere, ThinsOutWithoutAStep) {
  const Atmosphere atmosphere;
  for (double z = -1900; z < 32000; z += 1) {
    const double below = atmosphere.at(z).density, above = atmosphere.at(z + 1).density;
    ASSERT_LT(above, below) << z;
    ASSERT_GT(above, below * 0.9997) << z;
  }
}

TEST(Atmosphere, StaysAtItsLimitsBeyondThem) {
  const Atmosphere atmosphere;
  EXPECT_EQ(atmosphere.at(40e3).density, atmosphere.at(33e3).density);
  EXPECT_EQ(atmosphere.at(-5e3).density, atmosphere.at(-3e3).density);
  EXPECT_NEAR(atmosphere.at(40e3).pressure, 868.02, 0.005);
}

TEST(Wind, IsCalmWithoutLayers) {
  EXPECT_EQ(Wind().at(5000), Vec3{});
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

TEST(Wind, TurnsNoNose) {
  const std::vector<WindLayer> west = {{.altitude = 0, .speed = 20, .from = radians(270)}};
  const Wind wind(west);
  const Kinematics drifts{
      .velocity = {200, 20, 0}, .north = {1, 0, 0}, .east = {0, 1, 0}, .down = {0, 0, 1}};
  EXPECT_NEAR(through_air(drifts, wind).y, 0, 1e-12);
  EXPECT_NEAR(nose_of(drifts, wind).x, 1, 1e-12);
  EXPECT_EQ(through_air(drifts, Wind()), drifts.velocity);
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
