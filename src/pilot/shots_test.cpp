// SPDX-License-Identifier: MIT
#include "pilot/shots.hpp"

#include <gtest/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(TimeOfFlight, IsLongerForATargetThatRuns) {
  Desk desk;
  desk.track({20e3, 0, 0}, kPi, 250);
  desk.track({20e3, 0, 0}, 0, 250);
  const State s = desk.state();
  const model::MissileType& missile = library().missiles[kMedium];
  const double head_on = time_of_flight(s, s.seen[0], missile);
  const double tail = time_of_flight(s, s.seen[1], missile);
  EXPECT_GT(tail, 1.5 * head_on);
  // 20 km at 250 m/s, half the speed gain and 250 m/s of the target
  EXPECT_NEAR(head_on, 20e3 / (500 + missile.motor.ideal_speed_gain() / 2), 1e-9);
  EXPECT_GT(head_on, 15);
  EXPECT_LT(head_on, 30);
  EXPECT_LE(tail, missile.greatest_time);
  // all three are carried along
  desk.models = &windy_library();
  desk.own.velocity.x += 60;
  for (model::Track& track : std::span(desk.tracks.tracks).first(2))
    track.velocity.x += 60;
  const State carried = desk.state();
  EXPECT_NEAR(time_of_flight(carried, carried.seen[0], missile), head_on, 1e-9);
  EXPECT_NEAR(time_of_flight(carried, carried.seen[1], missile), tail, 1e-9);
}

TEST(FPole, IsTheRangeLessWhatBothFly) {
  Desk desk;
  desk.track({30e3, 0, 0}, kPi, 200);
  const State s = desk.state();
  const model::MissileType& missile = library().missiles[kMedium];
  const double time = time_of_flight(s, s.seen[0], missile);
  EXPECT_NEAR(f_pole(s, s.seen[0], missile), 30e3 - 450 * time, 1e-6);
}

}  // namespace
}  // namespace eyrie::pilot
