// SPDX-License-Identifier: MIT
#include "model/flight/collision.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace eyrie::model::flight {
namespace {

TEST(Collision, LooksBackAlongTheWayThatWasFlown) {
  // 50 m past each other after a head-on pass at 600 m/s: a twelfth of a second ago they met
  EXPECT_TRUE(collided({50, 0, 0}, {600, 0, 0}, 0.1));
  EXPECT_FALSE(collided({50, 0, 0}, {600, 0, 0}, 0.05)) << "that was before";
  EXPECT_FALSE(collided({50, 0, 0}, {-600, 0, 0}, 0.1)) << "they are still to meet";
  EXPECT_TRUE(collided({50, kCollision - 0.1, 0}, {600, 0, 0}, 0.1));
  EXPECT_FALSE(collided({50, kCollision + 0.1, 0}, {600, 0, 0}, 0.1));
  EXPECT_TRUE(collided({0, 0, kCollision / 2}, {}, 0.1)) << "side by side";
}

RC_GTEST_PROP(Collision, IsTheSameForBoth, ()) {
  const auto number = [] { return *rc::gen::inRange(-200, 200) / 2.0; };
  const Vec3 apart{number(), number(), number()}, relative{number(), number(), number()};
  RC_ASSERT(collided(apart, relative, 0.5) == collided(-apart, -relative, 0.5));
}

RC_GTEST_PROP(Collision, FindsWhatEveryPairAskedAloneWouldSay, ()) {
  std::vector<Kinematics> all(*rc::gen::inRange<std::size_t>(2, 600));
  std::uint32_t draw = 1;
  const auto next = [&] { return double((draw = draw * 1664525U + 1013904223U) >> 8) / (1 << 24); };
  for (Kinematics& k : all) {
    k.position = {300 * next(), 300 * next(), 30 * next()};
    k.velocity = {200 * next(), 200 * next(), 0};
  }
  std::vector<std::pair<std::size_t, std::size_t>> found, wanted;
  for_each_collision(all, 0, all.size(), 0.1, [&](auto i, auto j) { found.emplace_back(i, j); });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j)
      if (i != j &&
          collided(all[j].position - all[i].position, all[j].velocity - all[i].velocity, 0.1))
        wanted.emplace_back(i, j);
  std::sort(found.begin(), found.end());
  RC_ASSERT(found == wanted);
}

}  // namespace
}  // namespace eyrie::model::flight
