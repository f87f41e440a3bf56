// SPDX-License-Identifier: MIT
#include "scenario/path.hpp"

#include <gtest/gtest.h>

namespace eyrie::scenario {
namespace {

TEST(Path, CoversItselfAndWhatIsBelowItHoweverBothAreSpelled) {
  EXPECT_TRUE(covers("until", "until"));
  EXPECT_TRUE(covers("until", "\"until\"=3 s"));
  EXPECT_TRUE(covers("route.0=home", "\"route\".00.north"));
  EXPECT_TRUE(covers("trees.wall.children.0", "trees.wall.0.navigate.children.speed"));
  EXPECT_TRUE(covers("trees.\"break.2\"", "trees.\"break.2\".vote=\"a=b\""));
}

TEST(Path, CoversNothingElse) {
  EXPECT_FALSE(covers("route.0.north", "route.0"));
  EXPECT_FALSE(covers("route.0", "route.10"));
  EXPECT_FALSE(covers("route", "routes"));
  EXPECT_FALSE(covers("trees.break.2", "trees.\"break.2\""));
  EXPECT_FALSE(covers("wall.children", "wall.vote"));
  EXPECT_FALSE(covers("", "until"));
}

TEST(Path, SetAgainCountsWhereTheLaterCoversTheEarlier) {
  const std::vector<std::string> sets{"a.b=1", "until=3 s", "a={c: 2}", "a.d=3", "a=4"};
  std::vector<std::pair<std::size_t, std::size_t>> twice;
  for (const auto& [first, again] : set_twice(sets))
    twice.emplace_back(first, again);
  EXPECT_EQ(twice, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}, {2, 4}, {3, 4}}));
}

}  // namespace
}  // namespace eyrie::scenario
