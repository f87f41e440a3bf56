// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// Speed of `whom` along the line of sight of `who`, m/s.
double radial_speed(const Flight& f, std::string_view who, std::string_view whom) {
  const auto rows = f.world().rows(f.scenario->aircraft.kinematics);
  const auto& own = rows[f.row(who).value()];
  const auto& other = rows[f.row(whom).value()];
  return std::fabs(dot(other.velocity, normalized(other.position - own.position, {1, 0, 0})));
}

const model::Track* track(const Flight& f, std::string_view who, std::string_view whom) {
  const auto& file = f.world().rows(f.scenario->aircraft.tracks)[f.row(who).value()];
  for (std::uint32_t i = 0; i < file.count; ++i)
    if (file.tracks[i].truth == f.scenario->roster.find(whom))
      return &file.tracks[i];
  return nullptr;
}

class Notch : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Notch, HidesTheBeamingTargetAndNotTheOther) {
  Flight f(load_scenario("notch"), GetParam());

  // both come in: both are known, by radar alone
  f.fly_until(60);
  for (const char* bogey : {"coming1", "beaming1"}) {
    const model::Track* t = track(f, "eagle1", bogey);
    ASSERT_TRUE(t) << bogey;
    EXPECT_EQ(t->sources, model::kFromRadar) << bogey;
    EXPECT_EQ(t->identity, model::Identity::hostile) << bogey;
    EXPECT_GT(radial_speed(f, "eagle1", bogey), 60) << bogey;
  }

  // one beams: although it is nearer and shows its side, its track is gone
  f.fly_until(140);
  EXPECT_LT(radial_speed(f, "eagle1", "beaming1"), 60);
  EXPECT_FALSE(track(f, "eagle1", "beaming1"));
  ASSERT_TRUE(track(f, "eagle1", "coming1"));
  EXPECT_GT(track(f, "eagle1", "coming1")->sensed_time, 120);

  // it turns in again and is found again
  f.fly_until(200);
  EXPECT_GT(radial_speed(f, "eagle1", "beaming1"), 100);
  EXPECT_TRUE(track(f, "eagle1", "beaming1"));

  for (const Happened& h : f.log.of(EventKind::track_lost, "eagle1"))
    EXPECT_EQ(f.scenario->roster.name(h.event.whom), "beaming1") << h.time;
}
INSTANTIATE_TEST_SUITE_P(Seeds, Notch, testing::Range<std::uint64_t>(1, 9));

/// The same flight with a radar that has no clutter to fear: nothing is lost, so it is the notch.
TEST(NotchCounterpart, LosesNobodyWithoutANotch) {
  Flight f(load_scenario("notch", {"data.aircraft.listener.radar=clear",
                                   "data.radars={clear: {base: apg63, notch_speed: 0 m/s, "
                                   "notch_edge: 0.1 m/s}}"}));
  f.fly_until(200);
  EXPECT_EQ(f.time(), 200);
  EXPECT_TRUE(f.log.of(EventKind::track_lost, "eagle1").empty());
}

}  // namespace
}  // namespace eyrie::test
