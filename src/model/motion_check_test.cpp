// SPDX-License-Identifier: MIT
#include "model/motion_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace eyrie::model {
namespace {

TEST(MotionProblem, NamesWhatIsNoNumberOrAbsurd) {
  Kinematics motion;
  EXPECT_EQ(motion_problem(motion), "");
  const std::pair<double*, const char*> parts[]{{&motion.position.x, "position.x"},
                                                {&motion.velocity.z, "velocity.z"},
                                                {&motion.altitude, "altitude"},
                                                {&motion.heading, "heading"},
                                                {&motion.speed, "speed"}};
  for (const auto& [part, name] : parts)
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL, 1e300}) {
      const auto before = std::exchange(*part, bad);
      EXPECT_TRUE(motion_problem(motion).starts_with(std::string("kinematics.") + name + " is "))
          << motion_problem(motion);
      *part = before;
    }
  EXPECT_EQ(motion_problem(motion), "");
}

TEST(MotionProblem, LetsPassWhateverFlies) {
  Kinematics motion;
  motion.position = {400e3, -400e3, -60e3};
  motion.velocity = {2000, -2000, 1500};
  motion.altitude = 80e3;
  motion.heading = motion.roll = 6.28;
  motion.speed = 3200;
  motion.load_factor = 40;
  EXPECT_EQ(motion_problem(motion), "");
}

}  // namespace
}  // namespace eyrie::model
