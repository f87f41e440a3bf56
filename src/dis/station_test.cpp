// SPDX-License-Identifier: MIT
#include "dis/station.hpp"

#include <gtest/gtest.h>

namespace eyrie::dis {
namespace {

TEST(Station, IsThreeNumbersBetweenDots) {
  const auto station = station_of("255.2.65534");
  ASSERT_TRUE(station);
  EXPECT_EQ(station->exercise, 255);
  EXPECT_EQ(station->site, 2);
  EXPECT_EQ(station->application, 65534);
  for (const char* text :
       {"", "1", "1.2", "1.2.", "1.2.3.", "1.2.3.4", "0.1.1", "1.0.1", "1.1.0", "256.1.1",
        "1.65535.1", "1.1.65535", "1.1.-1", "a.b.c", "1..1", ".1.1", "1.1.1 "})
    EXPECT_FALSE(station_of(text)) << text;
}

}  // namespace
}  // namespace eyrie::dis
