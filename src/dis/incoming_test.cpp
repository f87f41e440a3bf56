// SPDX-License-Identifier: MIT
#include "dis/incoming.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace eyrie::dis {
namespace {

constexpr double kNoon = 1'767'268'800;  // s since 1970

std::vector<std::byte> state(double time, std::uint16_t entity = 1, std::uint16_t application = 2) {
  EntityState s;
  s.id = {1, application, entity};
  return encode({.timestamp = timestamp_at(time), .pdu = s});
}

TEST(Incoming, TakesEachStateOnceAndNoneThatWasOvertaken) {
  Incoming in({});
  for (const double time : {10.0, 12.0, 11.0, 12.0, 13.0})
    in.hear(state(time), kNoon + time);
  EXPECT_EQ(in.take().size(), 3u);
  EXPECT_EQ(in.counts[Unused::late], 1u);
  EXPECT_EQ(in.counts[Unused::twice], 1u);
  in.hear(state(1), kNoon + 14);                              // it began anew
  for (const double time : {1700.0, 3300.0, 3599.9, 3600.1})  // the last of the next hour
    in.hear(state(time), kNoon + time);
  EXPECT_EQ(in.take().size(), 5u);
  EXPECT_TRUE(in.take().empty());
}

TEST(Incoming, CountsWhyItUsesNothingOfTheRest) {
  Incoming in({});
  const auto good = state(10);
  auto other = good;
  other[0] = std::byte{5};
  in.hear(other, kNoon);
  other = good;
  other[1] = std::byte{9};
  in.hear(other, kNoon);
  other = good;
  other[2] = std::byte{70};
  in.hear(other, kNoon);
  in.hear(std::span(good).first(100), kNoon);
  other = good;
  other[19] = std::byte{3};  // parameters that are not there
  in.hear(other, kNoon);
  in.hear(state(10, 1, 1), kNoon);
  EntityState nowhere;
  nowhere.id = {1, 2, 3};
  nowhere.location.x = std::numeric_limits<double>::quiet_NaN();
  in.hear(encode({.pdu = nowhere}), kNoon);
  EXPECT_TRUE(in.take().empty());
  for (const Unused why : {Unused::version, Unused::exercise, Unused::kind, Unused::truncated,
                           Unused::malformed, Unused::own, Unused::implausible})
    EXPECT_EQ(in.counts[why], 1u) << words_of(why);
}

TEST(Incoming, ReadsAllOfADatagramAndTellsAShotOnce) {
  Incoming in({});
  Fire fire;
  fire.event = {1, 2, 7};
  auto both = state(1);
  const auto shot = encode({.timestamp = timestamp_at(1), .pdu = fire});
  both.insert(both.end(), shot.begin(), shot.end());
  in.hear(both, kNoon + 1);
  in.hear(encode({.timestamp = timestamp_at(3), .pdu = fire}), kNoon + 3);
  EXPECT_EQ(in.take().size(), 2u);
  EXPECT_EQ(in.counts[Unused::twice], 1u);
}

TEST(Incoming, TakesTheShotsOfAProgramThatBeganAnew) {
  Incoming in({});
  Fire fire;
  for (const double time : {1.0, 1.1, 60.0, 60.1})
    for (std::uint16_t number = 1; number <= 2; ++number) {
      fire.event = {1, 2, number};
      in.hear(encode({.timestamp = timestamp_at(time), .pdu = fire}), kNoon + time);
    }
  EXPECT_EQ(in.take().size(), 4u);
  EXPECT_EQ(in.counts[Unused::twice], 4u);
}

TEST(Incoming, KnowsWhenItWasSoByTheClockOfTheWorldOrByTheQuickestPacket) {
  Incoming in({});
  EntityState s;
  s.id = {1, 2, 1};
  in.hear(encode({.timestamp = timestamp_at(10) | 1, .pdu = s}), kNoon + 10.05);
  EXPECT_NEAR(in.take().at(0).valid, kNoon + 10, 1e-5);
  EXPECT_NEAR(in.counts.latency.mean(), 0.05, 1e-5);
  // its own clock, 100 s behind ours
  in.hear(state(1, 1, 3), kNoon + 101);
  in.hear(state(2, 1, 3), kNoon + 102.03);
  const auto heard = in.take();
  EXPECT_NEAR(heard.at(0).valid, kNoon + 101, 1e-5);
  EXPECT_NEAR(heard.at(1).valid, kNoon + 102, 1e-5);
  EXPECT_EQ(in.counts.latency.count, 1u);
}

TEST(Incoming, KnowsWhenItWasSoOfAMissionThatIsFlownMoreSlowly) {
  Incoming in({}, 0.5);
  for (int i = 0; i < 60; ++i) {
    const double late = i % 3 == 0 ? 0 : 0.03;
    in.hear(state(i * 0.5), kNoon + 4000 + i + late);
    EXPECT_NEAR(in.take().at(0).valid, kNoon + 4000 + i, 1e-4) << i;
  }
}

TEST(Incoming, KeepsNoMoreThanItsRoomWhateverComes) {
  Incoming in({});
  for (unsigned i = 0; i < 3 * Incoming::kMost; ++i)
    in.hear(state(1, static_cast<std::uint16_t>(i + 1)), kNoon);
  EXPECT_EQ(in.take().size(), Incoming::kMost);
  EXPECT_EQ(in.counts[Unused::crowded], 2 * Incoming::kMost);
  // those that are silent make room, those that speak stay
  for (const double time : {30.0, 50.0, 70.0})
    in.hear(state(time, 1), kNoon + time);
  for (unsigned i = 0; i < 2 * Incoming::kMost; ++i)
    in.hear(state(80, static_cast<std::uint16_t>(20'000 + i)), kNoon + 80);
  EXPECT_EQ(in.take().size(), 3 + Incoming::kMost - 1);
}

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
