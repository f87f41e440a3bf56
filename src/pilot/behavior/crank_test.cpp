// SPDX-License-Identifier: MIT
#include "pilot/behavior/crank.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "pilot/danger.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

Desk with_shot(double seconds) {
  Desk desk;
  const model::Track& track = desk.track({60e3, 5e3, 0});
  desk.agent.target = track.id;
  desk.agent.shots[0] = {.until = desk.time + seconds, .track = track.id, .store = kMedium};
  return desk;
}

TEST(Crank, KeepsTheTargetOffTheNoseOnTheSideWhereTheNoseIs) {
  const Desk desk = with_shot(50);
  const double bearing = std::atan2(5e3, 60e3);
  const Decided d = decide("{crank: {angle: 50 deg, descend: 500 m}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().heading, wrap_tau(bearing - 50 * kDegree), 1e-9);
  EXPECT_NEAR(*d.action().altitude, 7500, 1e-9);
  EXPECT_EQ(d.action().target, desk.agent.target);
}

TEST(Crank, DescendsFromWhereItBegan) {
  Desk desk = with_shot(50);
  Pilot pilot("{crank: {descend: 500 m}}");
  const auto altitude = [&] { return *pilot.decide(desk).action().altitude; };
  EXPECT_NEAR(altitude(), 7500, 1e-9);
  desk.own.altitude = 7600;
  EXPECT_NEAR(altitude(), 7500, 1e-9);
  const auto shot = std::exchange(desk.agent.shots[0], {});
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.agent.shots[0] = shot;
  EXPECT_NEAR(altitude(), 7100, 1e-9) << "another missile";
}

TEST(Crank, IsSilentWithoutAMissileOnItsWay) {
  Desk desk = with_shot(50);
  desk.agent.shots[0] = {};
  EXPECT_EQ(decide("crank", desk).status, kFailure);
  EXPECT_EQ(decide("crank", Desk()).status, kFailure);
}

TEST(Crank, EndsWhenTheMissileHasSwitchedOnItsSeeker) {
  // with so much time to go it is one activation range away at the closing speed of the moment
  Desk desk = with_shot(50);
  const double off = *support_left(desk.state(), desk.agent.shots[0]);
  ASSERT_GT(off, 0);
  ASSERT_LT(off, 50);
  desk = with_shot(50 - off + 0.1);
  EXPECT_EQ(decide("crank", desk).status, kRunning);
  desk = with_shot(50 - off - 0.1);
  EXPECT_EQ(decide("crank", desk).status, kFailure);
  EXPECT_EQ(decide("{crank: {support: false}}", desk).status, kRunning);
}

TEST(Crank, TurnsNoHarderThanItsEnergyAllows) {
  Desk desk = with_shot(50);  // 4 g sustained
  desk.own.speed = speed_of(desk.state(), 0.75);
  const auto load = [&](const char* tree) { return *decide(tree, desk).action().load_factor; };
  EXPECT_NEAR(load("{crank: {least_mach: 0.75, load_factor: 5}}"), 4, 1e-9);
  EXPECT_EQ(load("{crank: {least_mach: 0.5, load_factor: 5}}"), 5);
  desk.own.speed *= 0.5;
  EXPECT_NEAR(load("{crank: {least_mach: 0.75, load_factor: 5}}"), 2, 1e-9);
}

}  // namespace
}  // namespace eyrie::pilot
