// SPDX-License-Identifier: MIT
#include "pilot/geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "model/flight/flight_system.hpp"
#include "model/frames.hpp"

namespace eyrie::pilot {
namespace {

TEST(Formation, PutsEagle2WhereThePaperDoes) {
  const Vec3 place = formation_offset(Formation{}, 2);
  EXPECT_NEAR(place.x, -si(1000, "ft"), 1e-9);
  EXPECT_NEAR(place.y, -si(6000, "ft"), 1e-9);
  EXPECT_NEAR(place.z, si(500, "ft"), 1e-9);
}

TEST(Formation, LeavesTheLeadWhereHeIs) {
  EXPECT_EQ(formation_offset(Formation{}, 1), Vec3{});
  EXPECT_EQ(formation_offset(Formation{}, 0), Vec3{});
}

TEST(Formation, PutsTheThirdAndFourthOnTheRight) {
  const Formation wall{.abreast = 100, .behind = 10, .below = 1};
  EXPECT_EQ(formation_offset(wall, 3), (Vec3{-10, 100, 1}));
  EXPECT_EQ(formation_offset(wall, 4), (Vec3{-20, 200, 2}));
  EXPECT_EQ(formation_offset(wall, 5), (Vec3{-20, -200, 2}));
}

TEST(Formation, GivesNobodyThePlaceOfAnother) {
  const Formation wall{.abreast = 100, .behind = 0, .below = 0};
  std::vector<double> places;
  for (std::uint32_t rank = 1; rank <= 8; ++rank)
    places.push_back(formation_offset(wall, rank).y);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_EQ(places[i] - places[i - 1], 100);  // no gap either
}

double number(double low, double high) {
  return *rc::gen::inRange(0, 1'000'001) * 1e-6 * (high - low) + low;
}
Vec3 vector(double size) {
  return {number(-size, size), number(-size, size), number(-size, size)};
}

TEST(Geometry, CountsBearingsClockwiseFromNorth) {
  EXPECT_DOUBLE_EQ(bearing_of({1, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(bearing_of({0, 1, 0}), kPi / 2);
  EXPECT_DOUBLE_EQ(bearing_of({-1, 0, 0}), kPi);
  EXPECT_DOUBLE_EQ(bearing_of({0, -1, 0}), -kPi / 2);
  EXPECT_DOUBLE_EQ(bearing_of({0, 0, 5}), 0);
  EXPECT_NEAR(elevation_of({3, 4, -5}), kPi / 4, 1e-15);
}

TEST(Geometry, ReadsAltitudesOverTheCurveOfTheEarth) {
  const Reference reference(Geodetic{.latitude = radians(40), .longitude = radians(10)});
  const auto own = model::flight::placed(reference, model::Environment{}, {0, 0, -8000}, 0.5, 250);
  for (const double range : {1e3, 30e3, 120e3}) {
    const Vec3 there{range * 0.6, range * -0.8, -9000};
    const double seen = altitude_of(own, to_ned(own, there - own.position));
    EXPECT_NEAR(seen, reference.altitude_at(there), 1e-4 * range) << range;
  }
}

TEST(TimeToMeet, SolvesAHeadOnMerge) {
  // 10 km apart, 300 and 200 m/s towards each other
  EXPECT_NEAR(*time_to_meet({10e3, 0, 0}, {-200, 0, 0}, 300), 20, 1e-12);
}

TEST(TimeToMeet, SolvesAStern) {
  EXPECT_NEAR(*time_to_meet({1000, 0, 0}, {200, 0, 0}, 300), 10, 1e-12);
}

TEST(TimeToMeet, KnowsWhoCannotBeCaught) {
  EXPECT_FALSE(time_to_meet({1000, 0, 0}, {300, 0, 0}, 300));
  EXPECT_FALSE(time_to_meet({1000, 0, 0}, {400, 0, 0}, 300));
  EXPECT_FALSE(time_to_meet({1000, 0, 0}, {300, 300, 0}, 300));
  // faster, but he comes by
  EXPECT_NEAR(*time_to_meet({1000, 0, 0}, {-400, 0, 0}, 300), 1000 / 700.0, 1e-12);
}

RC_GTEST_PROP(TimeToMeetLaw, IsTheFirstMeetingOfTheTwoPaths, ()) {
  const Vec3 offset = vector(50e3), velocity = vector(400);
  const double speed = number(50, 600);
  RC_PRE(norm(offset) > 1);
  const auto time = time_to_meet(offset, velocity, speed);
  if (!time) {
    RC_ASSERT(norm(velocity) >= speed * (1 - 1e-9));  // the faster one always can
    return;
  }
  RC_ASSERT(*time > 0);
  const Vec3 there = offset + *time * velocity;
  RC_ASSERT(std::fabs(norm(there) - speed * *time) <= 1e-6 * (norm(offset) + speed * *time));
  for (const double part : {0.25, 0.5, 0.75, 0.99}) {
    const Vec3 before = offset + part * *time * velocity;
    RC_ASSERT(norm(before) > speed * part * *time);  // not there yet
  }
}

RC_GTEST_PROP(GeometryLaw, AxesTurnThereAndBack, ()) {
  const Reference reference(
      Geodetic{.latitude = radians(number(-80, 80)), .longitude = radians(number(-180, 180))});
  const Vec3 place{number(-3e5, 3e5), number(-3e5, 3e5), -5000};
  const auto own =
      model::flight::placed(reference, model::Environment{}, place, number(-3, 3), 250);
  const Vec3 v = vector(1000);
  RC_ASSERT(norm(from_ned(own, to_ned(own, v)) - v) < 1e-9);
  RC_ASSERT(std::fabs(norm(to_ned(own, v)) - norm(v)) < 1e-9);
  RC_ASSERT(norm(to_ned(own, own.velocity) - own.speed * nose_of(own)) < 1e-6);
}

}  // namespace
}  // namespace eyrie::pilot
