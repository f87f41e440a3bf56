// SPDX-License-Identifier: MIT
#include "model/map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"

namespace eyrie {
namespace {

TEST(Map, IsTrueFromItsMiddle) {
  const Map map({.latitude = radians(33), .longitude = radians(-68)});
  const MapPlace middle = map.at(map.middle());
  EXPECT_NEAR(middle.east, 0, 1e-6);
  EXPECT_NEAR(middle.north, 0, 1e-6);
  EXPECT_EQ(middle.turn, 0);
  // one minute of latitude at 33 degrees: 1848.4 m (WGS-84)
  const MapPlace north = map.at({.latitude = radians(33 + 1.0 / 60), .longitude = radians(-68)});
  EXPECT_NEAR(north.north, 1848.5, 0.5);
  EXPECT_NEAR(north.east, 0, 1e-6);
}

TEST(Map, TurnsHeadingsWhereMeridiansLean) {
  const Map map({.latitude = radians(33), .longitude = radians(-68)});
  // two degrees of longitude east of the middle a meridian leans by about 2 sin(33) degrees
  const Geodetic place{.latitude = radians(33), .longitude = radians(-66)};
  const MapPlace at = map.at(place);
  const MapPlace ahead = map.at({.latitude = radians(33.001), .longitude = radians(-66)});
  const double heading_on_map = std::atan2(ahead.east - at.east, ahead.north - at.north);
  EXPECT_NEAR(at.turn, heading_on_map, 1e-3);
  EXPECT_NEAR(degrees(at.turn), -2 * std::sin(radians(33)), 0.1);
}

}  // namespace
}  // namespace eyrie
