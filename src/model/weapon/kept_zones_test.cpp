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

/// Missiles that are flown for ten seconds, so that their zones are flown soon.
MissileType brief(MissileType type) {
  type.greatest_time = 10;
  return type;
}
const MissileType& far() {
  static const MissileType type = brief(test::medium_range());
  return type;
}
const MissileType& near() {
  static const MissileType type = brief(test::short_range());
  return type;
}

const ZoneTable& flown_medium() {
  static const ZoneTable table = fly_zone(far());
  return table;
}
/// A file with the zones of both missiles.
const std::string& both() {
  static const std::string file = [] {
    const std::array types{far(), near()};
    return KeptZones().encode(types);
  }();
  return file;
}
/// The first section of a file, changed, under a checksum that fits.
std::string sealed(std::string file) {
  const std::size_t body = file.size() - sizeof(std::uint64_t);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span<const char>(file.data(), body)));
  std::memcpy(file.data() + body, &sum, sizeof sum);
  return file;
}
const std::string& medium() {
  static const std::string file = [] {
    const std::array types{far()};
    return KeptZones().encode(types);
  }();
  return file;
}

TEST(KeptZones, FlyAZoneOnceAndGiveItsBitsFromThenOn) {
  KeptZones zones;
  EXPECT_EQ(*zones.of(far()).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 1U);
  EXPECT_EQ(zones.of(far()).table(), zones.of(far()).table());
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, OfAFileAreNotFlownAndHaveTheBitsOfFlownOnes) {
  KeptZones zones;
  EXPECT_EQ(zones.take(both()), 2U);
  EXPECT_EQ(*zones.of(far()).table(), flown_medium());
  EXPECT_EQ(*zones.of(near()).table(), fly_zone(near()));
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
  behind.off_boresight = near().seeker.gimbal + 0.01;
  EXPECT_FALSE(zones.of(near()).at(behind).possible());
  EXPECT_TRUE(zones.of(far()).at(behind).possible());
}

TEST(KeptZones, ServeATypeWithAnotherLabel) {
  KeptZones zones;
  zones.take(both());
  MissileType renamed = far();
  renamed.label = "another";
  EXPECT_EQ(*zones.of(renamed).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 0U);
}

TEST(KeptZones, AreFlownWhenTheLastBitOfAParameterDiffers) {
  KeptZones zones;
  zones.take(both());
  MissileType other = far();
  other.greatest_time = std::nextafter(other.greatest_time, 0.0);
  static_cast<void>(zones.of(other));
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, AreNotBelievedWhenTheMissileNowFliesOtherwise) {
  // behind the sizes of the body and of the key, and the key: how its trial flights ended
  std::string file = medium();
  const std::size_t key_size = file.find('\n') + 1 + sizeof(std::uint64_t);
  std::uint64_t key = 0;
  std::memcpy(&key, file.data() + key_size, sizeof key);
  file[key_size + sizeof key + key] ^= 1;
  KeptZones zones;
  EXPECT_EQ(zones.take(sealed(file)), 1U);
  EXPECT_EQ(*zones.of(far()).table(), flown_medium());
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, AreTakenFromTheStoreAndGivenToIt) {
  std::map<std::uint64_t, std::string> kept;
  std::size_t told = 0;
  const ZoneStore store{.load = [&](std::uint64_t key) { return kept[key]; },
                        .save = [&](std::uint64_t key, std::string_view file) { kept[key] = file; },
                        .progress = [&](const MissileType&, double) { ++told; }};
  for (const std::size_t flown : {1U, 0U}) {
    KeptZones zones;
    zones.use(store);
    EXPECT_EQ(*zones.of(far()).table(), flown_medium());
    EXPECT_EQ(zones.flown(), flown);
  }
  EXPECT_GT(told, 10U);
  EXPECT_EQ(kept.size(), 1U);
  kept.begin()->second = "nonsense";
  KeptZones zones;
  zones.use(store);
  static_cast<void>(zones.of(far()));
  EXPECT_EQ(zones.flown(), 1U);
}

TEST(KeptZones, OfADamagedFileAreFlown) {
  const std::size_t half = both().size() / 2;
  for (std::size_t at = 0; at < both().size(); at += 1979) {
    std::string flipped = both();
    flipped[at] ^= 0x10;
    const std::size_t whole = at < half ? 0 : 1;
    EXPECT_EQ(KeptZones().take(flipped), whole) << at;
    EXPECT_EQ(KeptZones().take(both().substr(0, at)), whole) << at;
  }
  EXPECT_EQ(KeptZones().take(both() + "x"), 2U);
  EXPECT_EQ(KeptZones().take(""), 0U);
}

TEST(KeptZones, OfAFileThatClaimsTooMuchAreFlown) {
  // each length and each cut under a checksum that fits
  for (std::size_t cut = 30; cut < 4000; cut += 61)
    EXPECT_EQ(KeptZones().take(sealed(medium().substr(0, cut))), 0U) << cut;
  const std::size_t magic = medium().find('\n') + 1;
  for (const std::size_t at : {magic, magic + sizeof(std::uint64_t)})
    for (const std::uint64_t length :
         {std::uint64_t{0}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
      std::string file = medium();
      std::memcpy(file.data() + at, &length, sizeof length);
      EXPECT_EQ(KeptZones().take(sealed(file)), 0U) << length;
    }
}

TEST(KeptZones, ForgetTheOldestWhenThereAreTooMany) {
  // impossible at once: it never gets faster than it must be
  MissileType lame = far();
  lame.greatest_time = 0.01;
  constexpr std::size_t kMost = 8;
  KeptZones zones(kMost);
  static_cast<void>(zones.of(lame));
  for (std::size_t i = 0; i < kMost; ++i) {
    MissileType other = lame;
    other.release_interval = 100.0 + static_cast<double>(i);
    static_cast<void>(zones.of(other));
  }
  EXPECT_EQ(zones.flown(), kMost + 1);
  static_cast<void>(zones.of(lame));
  EXPECT_EQ(zones.flown(), kMost + 2);
}

}  // namespace
}  // namespace eyrie::model::weapon
