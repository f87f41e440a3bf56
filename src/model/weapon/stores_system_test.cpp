// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include <gtest/gtest.h>

#include "support/model/firing_range.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kMedium;
using test::kShort;
using test::Range;
using E = EventKind;

struct StoresTest : ::testing::Test {
  Range range;
  PlayerId blue = range.add({0, 0, -8000}, 0, 280);
  PlayerId red = range.add({30e3, 0, -8000}, kPi, 280, Side::red);
  Stores& stores() { return range.row(range.aircraft().stores, blue); }
};

TEST_F(StoresTest, LaunchesAfterTheDelayOfTheRelease) {
  range.shoot(blue, red, kMedium);
  range.step();
  EXPECT_EQ(range.count(E::release), 1u);
  EXPECT_EQ(range.in_flight(), 0u);
  range.run(0.36);
  EXPECT_EQ(range.in_flight(), 0u);
  range.run(0.06);
  EXPECT_EQ(range.in_flight(), 1u);
  EXPECT_EQ(range.count(E::launch), 1u);
  EXPECT_EQ(count_of(stores(), kMedium), 1u);
}

TEST_F(StoresTest, ReleasesAgainOnlyAfterTheInterval) {
  range.shoot(blue, red, kMedium);
  range.run(1.0);  // the trigger stays pressed
  EXPECT_EQ(range.count(E::release), 1u);
  range.run(0.1);
  EXPECT_EQ(range.count(E::release), 2u);
}

TEST_F(StoresTest, GoesWinchesterOnce) {
  range.shoot(blue, red, kMedium);
  range.run(3);
  // the two short-range missiles need something to see
  const PlayerId near = range.add(
      range.row(range.aircraft().kinematics, blue).position + Vec3{3000, 0, 0}, 0, 280, Side::red);
  for (int i = 0; i < 200; ++i) {
    range.shoot(blue, near, kShort);
    range.step();
  }
  EXPECT_EQ(range.count(E::launch), 4u);
  EXPECT_EQ(range.count(E::winchester), 1u);
  EXPECT_EQ(missiles_left(stores()), 0u);
  range.run(3);
  EXPECT_EQ(range.count(E::release), 4u);
  EXPECT_EQ(range.count(E::winchester), 1u);
}

TEST_F(StoresTest, HoldsAnInfraredMissileThatSeesNobody) {
  range.shoot(blue, red, kShort);
  range.run(2);
  EXPECT_EQ(range.count(E::release), 0u);
  EXPECT_EQ(count_of(stores(), kShort), 2u);
  const auto waits = [&] {
    return waits_for_lock(range.world(), range.aircraft(), range.library(), 0, range.time());
  };
  EXPECT_TRUE(waits());
  range.shoot(blue, red, kMedium);
  EXPECT_FALSE(waits()) << "its own radar finds it later";
}

TEST_F(StoresTest, KeepsTheStoreWhenTheTrackIsLostBeforeLaunch) {
  range.shoot(blue, red, kMedium);
  range.step();
  range.row(range.aircraft().tracks, blue).count = 0;
  range.run(2);
  EXPECT_EQ(range.count(E::release), 1u);
  EXPECT_EQ(range.count(E::launch), 0u);
  EXPECT_EQ(count_of(stores(), kMedium), 2u);
}

TEST_F(StoresTest, IgnoresRequestsThatMakeNoSense) {
  Request& request = range.row(range.aircraft().request, blue);
  request.store = 200;  // no such type
  request.shoot_at = range.track(blue, red);
  range.step();
  request.store = 1;
  request.shoot_at = TrackId{77};  // no such track
  range.step();
  request.shoot_at = {};
  range.step();
  EXPECT_EQ(range.events().size(), 0u);
}

TEST_F(StoresTest, GivesUpNothingWhenTheShooterDiesBeforeLaunch) {
  range.shoot(blue, red, kMedium);
  range.step();
  const auto row = range.world().row(range.aircraft().table, blue);
  range.world().remove(range.aircraft().table, *row);
  range.world().compact();
  range.run(2);
  EXPECT_EQ(range.count(E::launch), 0u);
}

}  // namespace
}  // namespace eyrie::model::weapon
