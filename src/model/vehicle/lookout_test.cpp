// SPDX-License-Identifier: MIT
#include "model/vehicle/lookout.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/units.hpp"
#include "model/datalink/datalink.hpp"
#include "support/model/flying.hpp"

namespace eyrie::model::vehicle {
namespace {

Sighted at(std::uint32_t id, double north, double time = 0) {
  return {.position = {north, 0, 0}, .time = time, .seen_time = time, .truth = PlayerId{id}};
}

TEST(Lookout, KeepsTheNearestAndForgetsTheRest) {
  Lookout lookout;
  for (std::uint32_t i = 1; i <= 6; ++i)
    sight(lookout, {}, at(i, 7000.0 - 1000 * i));
  EXPECT_EQ(lookout.count, Lookout::kAircraft);
  for (std::uint32_t i = 3; i <= 6; ++i)
    EXPECT_TRUE(lookout.find(PlayerId{i})) << i;
  sight(lookout, {}, at(7, 9000));
  EXPECT_FALSE(lookout.find(PlayerId{7})) << "farther than all others";

  sight(lookout, {}, at(6, 900, 10));
  forget(lookout, 10 + kSightedMemory);
  EXPECT_EQ(lookout.count, 1u);
  EXPECT_EQ(lookout.sighted[0].truth, PlayerId{6});
  EXPECT_EQ(lookout.sighted[1].truth, PlayerId{}) << "an empty place is zero";
}

TEST(Lookout, RemembersWhoItWasWhenItIsTooFarToTell) {
  Lookout lookout;
  Sighted close = at(1, 1000, 1);
  close.identity = Identity::hostile;
  sight(lookout, {}, close);
  sight(lookout, {}, at(1, 5000, 2));
  EXPECT_EQ(lookout.sighted[0].identity, Identity::hostile);
  EXPECT_EQ(lookout.sighted[0].position.x, 5000);
  sight(lookout, {}, at(1, 900, 1.5));
  EXPECT_EQ(lookout.sighted[0].position.x, 5000) << "that was before";
}

/// A hundred looks of a driver at one aircraft `range` (m) to the north; how many saw it.
int looks_that_see(double range, Lookout& lookout, std::uint64_t seed = 1, bool told = false) {
  const sensor::Visual visual;
  const Kinematics driver = test::flying({}, 0, 0);
  const std::vector<PlayerId> ids{PlayerId{9}};
  const std::vector<Fit> fit{{.side = Side::red}};
  const std::vector<Kinematics> there{test::flying({range, 0, -600}, kPi, 200)};
  const Signature signature;
  const std::vector<const Signature*> signatures{&signature};
  int seen = 0;
  for (std::uint64_t step = 1; step <= 100; ++step) {
    const double time = static_cast<double>(step);
    if (told)
      sight(lookout, {}, {.position = {range, 0, -600}, .time = time - 0.5, .truth = PlayerId{9}});
    const Watcher watcher{.own = driver,
                          .id = PlayerId{1},
                          .side = Side::blue,
                          .seed = seed,
                          .step = step,
                          .time = time};
    look_up(visual, watcher, {ids, fit, there, signatures}, lookout);
    const Sighted* known = lookout.find(PlayerId{9});
    seen += known && known->seen_time == time;
  }
  return seen;
}

TEST(Lookout, SeesWhatIsNearAndNotWhatIsFar) {
  Lookout near, far;
  EXPECT_GT(looks_that_see(700, near), 85);
  EXPECT_EQ(near.sighted[0].identity, Identity::hostile);
  EXPECT_EQ(looks_that_see(40e3, far), 0);
  int drivers = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Lookout middle;
    drivers += looks_that_see(6e3, middle, seed) > 0;
  }
  EXPECT_GT(drivers, 5);
  EXPECT_LT(drivers, 40) << "an aircraft that comes head-on is hard to find";
}

TEST(Lookout, FindsSoonerWhatAMateTellsOf) {
  const auto drivers_who_see = [](bool told) {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Lookout lookout;
      count += looks_that_see(6e3, lookout, seed, told) > 0;
    }
    return count;
  };
  EXPECT_GT(drivers_who_see(true), 2 * drivers_who_see(false));
}

TEST(Lookout, TellsMatesOfWhatItsOwnEyesHaveSeenAndPassesNothingOn) {
  Lookout lookout;
  Sighted own = at(1, 4000, 100);
  own.identity = Identity::hostile;
  sight(lookout, {}, own);
  sight(lookout, {}, {.position = {5000, 0, 0}, .time = 100, .truth = PlayerId{2}});
  datalink::DatalinkSent sent;
  datalink::transmit(sent, {.time = 101}, as_tracks(lookout));
  ASSERT_EQ(sent.messages[0].track_count, 1u);

  Lookout mate;
  warn(mate, {}, sent.messages[0]);
  ASSERT_EQ(mate.count, 1u);
  EXPECT_EQ(mate.sighted[0].truth, PlayerId{1});
  EXPECT_EQ(mate.sighted[0].identity, Identity::hostile);
  EXPECT_EQ(mate.sighted[0].time, 101);
  EXPECT_EQ(mate.sighted[0].seen_time, kNever);
  datalink::transmit(sent, {.time = 101.5}, as_tracks(mate));
  EXPECT_EQ(sent.messages[1].track_count, 0u) << "rumours would never end";
}

}  // namespace
}  // namespace eyrie::model::vehicle
