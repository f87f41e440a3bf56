// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pilot/testing.hpp"
using namespace eyrie::pilot::testing;

TEST(Dodge, TurnsItsBackOnWhoIsNear) {
  Desk desk;
  desk.track({0, 6000, 0});  // in the east
  EXPECT_EQ(decide("{dodge: {within: 5 km}}", desk).status, kFailure);
  EXPECT_NEAR(*decide("{dodge: {within: 7 km}}", desk).action().heading, 270 * kDegree, 1e-9);
}
