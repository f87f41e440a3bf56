// SPDX-License-Identifier: MIT
#include "pilot/formation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

}  // namespace
}  // namespace eyrie::pilot
