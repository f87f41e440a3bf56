// SPDX-License-Identifier: MIT
#include "model/weapon/missile.hpp"

#include <gtest/gtest.h>

#include "support/data_file.hpp"

namespace eyrie::model::weapon {
namespace {

using eyrie::test::load;

TEST(Motor, SumsATrapezoidExactly) {
  const Motor motor{.mass = Table1({0, 2}, {10, 8}), .thrust = Table1({0, 1, 2}, {1000, 3000, 0})};
  EXPECT_DOUBLE_EQ(motor.total_impulse(), 2000 + 1500);
  EXPECT_DOUBLE_EQ(motor.launch_mass(), 10);
  EXPECT_DOUBLE_EQ(motor.burnout_mass(), 8);
  EXPECT_DOUBLE_EQ(motor.burn_time(), 2);
}

TEST(Motor, OfTheShortRangeMissileIsThatOfThePublishedOne) {
  // CADAC AIM5: its thrust table integrates to 60.9 kN s and, with its mass table, an ideal speed
  // gain of 1214 m/s
  const auto type = load<MissileType>("data/missiles/aim9.yaml");
  EXPECT_NEAR(type.motor.total_impulse(), 60.9e3, 0.1e3);
  EXPECT_NEAR(type.motor.ideal_speed_gain(), 1214, 1);
}

TEST(Motor, BurnsSolidPropellantInEveryMissile) {
  // composite propellants give 180 to 260 s at sea level: Sutton & Biblarz, table 13-1
  for (const char* name : {"aim9", "r73", "aim120", "r77"}) {
    const auto type = load<MissileType>(std::string("data/missiles/") + name + ".yaml");
    EXPECT_GT(type.motor.specific_impulse(), 225) << name;
    EXPECT_LT(type.motor.specific_impulse(), 260) << name;
    // Mach 3 to 4 from Mach 0.9 in thin air
    EXPECT_GT(type.motor.ideal_speed_gain(), 900) << name;
    EXPECT_LT(type.motor.ideal_speed_gain(), 1300) << name;
  }
}

}  // namespace
}  // namespace eyrie::model::weapon
