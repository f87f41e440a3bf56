// SPDX-License-Identifier: MIT
#include "model/weapon/kept_zones.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>

#include "core/hash.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

using test::medium_range;
using test::short_range;

const ZoneTable& flown_medium() {
  static const ZoneTable table = fly_zone(medium_range());
  return table;
}
/// A file with the zones of both missiles.
const std::string& both() {
  static const std::string file = [] {
    const std::array types{medium_range(), short_range()};
    return KeptZones().encode(types);
  }();
  return file;
}
std::string sealed(std::string file) {
  const std::size_t body = file.size() - sizeof(std::uint64_t);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span<const char>(file.data(), body)));
  std::memcpy(file.data() + body, &sum, sizeof sum);
  return file;
}

TEST(KeptZones, FlyAZoneOnceAndGiveItsBitsFromThenOn) {
  KeptZones zones;
  EXPECT_EQ(*zones.of(medium_range()).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 1U);
  EXPECT_EQ(zones.of(medium_range()).table(), zones.of(medium_range()).table());
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, OfAFileAreNotFlownAndHaveTheBitsOfFlownOnes) {
  KeptZones zones;
  EXPECT_EQ(zones.take(both()), 2U);
  EXPECT_EQ(*zones.of(medium_range()).table(), flown_medium());
  EXPECT_EQ(*zones.of(short_range()).table(), fly_zone(short_range()));
  EXPECT_EQ(zones.flown(), 0U);
}

TEST(KeptZones, KeepTheSeekerOfTheTypeThatAsks) {
  KeptZones zones;
  zones.take(both());
  LaunchSituation behind{.shooter_altitude = 6000,
                         .target_altitude = 6000,
                         .shooter_speed = 250,
                         .target_speed = 250,
                         .aspect = kPi};
  behind.off_boresight = short_range().seeker.gimbal + 0.01;
  EXPECT_FALSE(zones.of(short_range()).at(behind).possible());
  EXPECT_TRUE(zones.of(medium_range()).at(behind).possible());
}

TEST(KeptZones, ServeATypeWithAnotherLabel) {
  KeptZones zones;
  zones.take(both());
  MissileType renamed = medium_range();
  renamed.label = "another";
  EXPECT_EQ(*zones.of(renamed).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 0U);
}

TEST(KeptZones, AreFlownWhenTheLastBitOfAParameterDiffers) {
  KeptZones zones;
  zones.take(both());
  MissileType other = medium_range();
  other.greatest_time = std::nextafter(other.greatest_time, 0.0);
  static_cast<void>(zones.of(other));
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, AreNotBelievedWhenTheMissileNowFliesOtherwise) {
  // the words behind the first key are how its trial flights ended
  std::string file = both();
  const std::size_t magic = file.find('\n') + 1;
  std::uint64_t key = 0;
  std::memcpy(&key, file.data() + magic, sizeof key);
  file[magic + sizeof key + key] ^= 1;
  KeptZones zones;
  EXPECT_EQ(zones.take(sealed(file)), 2U);
  EXPECT_EQ(*zones.of(medium_range()).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, OfADamagedFileAreFlown) {
  for (std::size_t at = 0; at < both().size(); at += 97) {
    std::string flipped = both();
    flipped[at] ^= 0x10;
    EXPECT_EQ(KeptZones().take(flipped), 0U) << at;
    EXPECT_EQ(KeptZones().take(both().substr(0, at)), 0U) << at;
  }
  EXPECT_EQ(KeptZones().take(both() + "x"), 0U);
  EXPECT_EQ(KeptZones().take(""), 0U);
}

TEST(KeptZones, OfAFileThatClaimsTooMuchAreFlown) {
  // each length and each cut under a checksum that fits
  for (std::size_t cut = 30; cut < 4000; cut += 61)
    EXPECT_EQ(KeptZones().take(sealed(both().substr(0, cut))), 0U) << cut;
  std::string file = both();
  const std::size_t magic = file.find('\n') + 1;
  for (const std::uint64_t length : {std::uint64_t{0}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::memcpy(file.data() + magic, &length, sizeof length);
    EXPECT_EQ(KeptZones().take(sealed(file)), 0U) << length;
  }
}

TEST(KeptZones, ForgetTheOldestWhenThereAreTooMany) {
  // impossible at once: it never gets faster than it must be
  MissileType lame = medium_range();
  lame.greatest_time = 0.01;
  KeptZones zones;
  static_cast<void>(zones.of(lame));
  for (std::size_t i = 0; i < KeptZones::kMost; ++i) {
    MissileType other = lame;
    other.release_interval = 100.0 + static_cast<double>(i);
    static_cast<void>(zones.of(other));
  }
  EXPECT_EQ(zones.flown(), KeptZones::kMost + 1);
  static_cast<void>(zones.of(lame));
  EXPECT_EQ(zones.flown(), KeptZones::kMost + 2);
}

}  // namespace
}  // namespace eyrie::model::weapon
