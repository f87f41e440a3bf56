// SPDX-License-Identifier: MIT
#include "pilot/condition/own.hpp"

#include <gtest/gtest.h>

#include "pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(Bingo, HoldsWhenTheFuelIsDown) {
  Desk desk;
  desk.propulsion.fuel = desk.agent.bingo + 1;
  EXPECT_FALSE(holds("bingo", desk));
  desk.propulsion.fuel = desk.agent.bingo;
  EXPECT_TRUE(holds("bingo", desk));
}

TEST(Winchester, HoldsWhenTheLastMissileIsGone) {
  Desk desk;
  EXPECT_FALSE(holds("winchester", desk));
  for (model::Station& station : desk.stores.stations)
    station.count = 0;
  EXPECT_TRUE(holds("winchester", desk));
  EXPECT_FALSE(holds("{winchester: {gun: true}}", desk)) << "the gun is loaded";
  desk.gun.rounds = 0;
  EXPECT_TRUE(holds("{winchester: {gun: true}}", desk));
}

TEST(Losses, CountsWhoFellSilent) {
  Desk desk;
  desk.in_flight(4, 2);
  EXPECT_FALSE(holds("{losses: {at_least: 1}}", desk));
  desk.lose(1);
  EXPECT_TRUE(holds("{losses: {at_least: 1}}", desk));
  EXPECT_FALSE(holds("{losses: {at_least: 2}}", desk));
  desk.lose(4);
  EXPECT_TRUE(holds("{losses: {at_least: 2}}", desk));
}

TEST(IsLead, GoesByTheRankAmongTheLiving) {
  Desk desk;
  desk.in_flight(2, 2);
  EXPECT_FALSE(holds("is_lead", desk));
  desk.lose(1);
  EXPECT_TRUE(holds("is_lead", desk));
}

TEST(NearHome, MeasuresAlongTheGround) {
  Desk desk;  // home is 50 nmi to the south
  EXPECT_FALSE(holds("{near_home: {within: 49 nmi}}", desk));
  EXPECT_TRUE(holds("{near_home: {within: 51 nmi}}", desk));
  desk.fit.flight = 1;
  EXPECT_FALSE(holds("{near_home: {within: 500 nmi}}", desk)) << "no home, never near it";
}

TEST(RouteDone, HoldsPastTheLastWaypoint) {
  Desk desk;  // two waypoints
  desk.flying.nav.leg = 1;
  EXPECT_FALSE(holds("route_done", desk));
  desk.flying.nav.leg = 2;
  EXPECT_TRUE(holds("route_done", desk));
  EXPECT_FALSE(holds("{route_done: {route: 1}}", desk)) << "there is no such route";
  desk.fit.flight = 1;
  EXPECT_FALSE(holds("route_done", desk)) << "no route at all";
}

}  // namespace
}  // namespace eyrie::pilot
