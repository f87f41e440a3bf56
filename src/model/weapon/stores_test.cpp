// SPDX-License-Identifier: MIT
#include "model/weapon/stores.hpp"

#include <gtest/gtest.h>

#include "support/model/stores.hpp"

namespace eyrie::model::weapon {
namespace {

Shelf<MissileType> shelf() {
  Shelf<MissileType> missiles;
  missiles.add("medium", {.release_interval = 1, .launch_delay = 0.4});
  missiles.add("short", {.release_interval = 0.1, .launch_delay = 0.2});
  return missiles;
}
constexpr std::uint16_t kLong = 0, kDogfight = 1;

Stores loaded_stores(const Shelf<MissileType>& missiles) {
  return load_stores(std::vector<StationFit>{{"short", 1}, {"medium", 2}, {"medium", 1}}, missiles);
}

TEST(LoadStores, PutsEachStoreOnItsStation) {
  const auto missiles = shelf();
  const Stores stores = loaded_stores(missiles);
  EXPECT_EQ(stores.stations[0].store, kDogfight + 1);
  EXPECT_EQ(stores.stations[1].count, 2);
  EXPECT_EQ(stores.stations[3].store, 0);
  EXPECT_EQ(count_of(stores, kLong), 3u);
  EXPECT_EQ(count_of(stores, kDogfight), 1u);
  EXPECT_EQ(missiles_left(stores), 4u);
}

TEST(Release, TakesTheStoreWhenTheLaunchDelayIsOver) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  begin_release(stores, kLong, missiles[kLong], TrackId{5}, 10);
  EXPECT_EQ(count_of(stores, kLong), 3u);
  EXPECT_FALSE(finish_release(stores, true, 10.38));
  const auto ejection = finish_release(stores, true, 10.4);
  ASSERT_TRUE(ejection);
  EXPECT_EQ(ejection->station, 1);
  EXPECT_EQ(ejection->type, kLong);
  EXPECT_EQ(ejection->track, TrackId{5});
  EXPECT_EQ(count_of(stores, kLong), 2u);
  EXPECT_FALSE(finish_release(stores, true, 10.42));
}

TEST(Release, KeepsItsInterval) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  begin_release(stores, kLong, missiles[kLong], TrackId{5}, 10);
  EXPECT_FALSE(can_release(stores, kLong, 10.2));  // one is on its way
  ASSERT_TRUE(finish_release(stores, true, 10.4));
  EXPECT_FALSE(can_release(stores, kLong, 10.98));
  EXPECT_TRUE(can_release(stores, kLong, 11));
}

TEST(Release, IsNeverShorterApartThanTheLaunchDelay) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  begin_release(stores, kDogfight, missiles[kDogfight], TrackId{5}, 10);
  EXPECT_DOUBLE_EQ(stores.ready_time, 10.2);
}

TEST(Release, LeavesTheStoreWhenTheTrackIsGone) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  begin_release(stores, kLong, missiles[kLong], TrackId{5}, 10);
  EXPECT_FALSE(finish_release(stores, false, 10.4));
  EXPECT_EQ(count_of(stores, kLong), 3u);
  EXPECT_FALSE(stores.pending_track);
  EXPECT_TRUE(can_release(stores, kLong, 11));
}

TEST(Release, IsRefusedWithoutAStoreOfTheType) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  begin_release(stores, kDogfight, missiles[kDogfight], TrackId{5}, 10);
  ASSERT_TRUE(finish_release(stores, true, 10.2));
  EXPECT_FALSE(can_release(stores, kDogfight, 100));
  EXPECT_TRUE(can_release(stores, kLong, 100));
}

TEST(Release, TellsTheLastMissileOnce) {
  const auto missiles = shelf();
  Stores stores = loaded_stores(missiles);
  int last = 0;
  double time = 0;
  for (const std::uint16_t type : {kLong, kLong, kDogfight, kLong}) {
    time += 10;
    ASSERT_TRUE(can_release(stores, type, time));
    begin_release(stores, type, missiles[type], TrackId{1}, time);
    const auto ejection = finish_release(stores, true, time + 1);
    ASSERT_TRUE(ejection);
    last += ejection->last;
    EXPECT_EQ(ejection->last, missiles_left(stores) == 0);
  }
  EXPECT_EQ(last, 1);
  EXPECT_EQ(stores.winchester, 1);
}

}  // namespace
}  // namespace eyrie::model::weapon
