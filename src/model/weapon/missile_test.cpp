// SPDX-License-Identifier: MIT
#include "model/weapon/missile.hpp"

#include <gtest/gtest.h>

#include "model/weapon/flyout.hpp"
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

/// The highest Mach number of a straight flight from Mach 0.9 at an altitude (m).
double top_mach(const MissileType& type, double altitude) {
  const Air air = Atmosphere().at(altitude);
  Flyout flyout{.velocity = {0.9 * air.speed_of_sound, 0, 0}};
  double top = 0;
  for (double age = 0; age < 15; age += 0.02) {
    fly(type, air, {}, {0, 0, 1}, age, 0.02, {0, 0, -kGravity}, flyout);
    top = std::max(top, norm(flyout.velocity) / air.speed_of_sound);
  }
  return top;
}

TEST(Motor, OfEachMissileReachesItsPublishedSpeed) {
  // "Mach 2.5" of the AIM-9 (USAF fact sheet) and the R-73, "Mach 4" of the AIM-120 and the R-77
  // (manufacturers, in thin air): all from general knowledge
  struct Published {
    const char* name;
    double low, high;  // Mach at sea level and at 12 km, within 10 %
  };
  for (const auto& [name, low, high] :
       {Published{"aim9", 2.5, 3.2}, {"r73", 2.5, 3.2}, {"aim120", 2.6, 4}, {"r77", 2.5, 4}}) {
    const auto type = load<MissileType>(std::string("data/missiles/") + name + ".yaml");
    EXPECT_NEAR(top_mach(type, 0) / low, 1, 0.1) << name;
    EXPECT_NEAR(top_mach(type, 12e3) / high, 1, 0.1) << name;
    EXPECT_LT(top_mach(type, 0), 0.85 * top_mach(type, 12e3)) << name;
  }
}

TEST(Motor, BurnsSolidPropellantInEveryMissile) {
  // composite propellants give 180 to 260 s at sea level: Sutton & Biblarz, table 13-1
  for (const char* name : {"aim9", "r73", "aim120", "r77"}) {
    const auto type = load<MissileType>(std::string("data/missiles/") + name + ".yaml");
    EXPECT_GT(type.motor.specific_impulse(), 225) << name;
    EXPECT_LT(type.motor.specific_impulse(), 260) << name;
    // Mach 2 to 4 more than at launch, before drag
    EXPECT_GT(type.motor.ideal_speed_gain(), 650) << name;
    EXPECT_LT(type.motor.ideal_speed_gain(), 1300) << name;
  }
}

}  // namespace
}  // namespace eyrie::model::weapon
