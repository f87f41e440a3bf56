// SPDX-License-Identifier: MIT
#include "pilot/conditions.hpp"

#include <gtest/gtest.h>

#include "support/pilot/testing.hpp"

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

using namespace pilot::testing;
using model::Identity;

TEST(HostileTrack, HoldsWithinItsRange) {
  Desk desk;
  EXPECT_FALSE(holds("hostile_track", desk));
  desk.track({40 * kNmi, 0, 0});
  EXPECT_TRUE(holds("{hostile_track: {within: 40.1 nmi}}", desk));
  EXPECT_FALSE(holds("{hostile_track: {within: 39.9 nmi}}", desk));
}

TEST(HostileTrack, TakesUnknownsForHostileOnlyIfToldTo) {
  Desk desk;
  desk.track({40 * kNmi, 0, 0}, kPi, 250, Identity::unknown);
  EXPECT_FALSE(holds("hostile_track", desk));
  EXPECT_TRUE(holds("{hostile_track: {identified: false}}", desk));
  desk.tracks.tracks[0].identity = Identity::friendly;
  EXPECT_FALSE(holds("{hostile_track: {identified: false}}", desk));
  desk.tracks.tracks[0].identity = Identity::hostile;
  desk.tracks.tracks[0].confirmed = 0;
  EXPECT_FALSE(holds("{hostile_track: {identified: false}}", desk));
}

TEST(HasTarget, HoldsForTheChosenOne) {
  Desk desk;
  EXPECT_FALSE(holds("has_target", desk));
  desk.track({40 * kNmi, 0, 0});
  EXPECT_TRUE(holds("has_target", desk));
  EXPECT_FALSE(holds("{has_target: {within: 30 nmi}}", desk));
}

TEST(InSight, HoldsForWhatTheEyeSees) {
  Desk desk;
  model::Track& track = desk.track({8 * kNmi, 0, 0});
  EXPECT_FALSE(holds("{in_sight: {within: 5 nmi}}", desk));
  track.seen_time = desk.time - 4;
  EXPECT_TRUE(holds("{in_sight: {within: 5 nmi, memory: 5 s}}", desk));
  EXPECT_FALSE(holds("{in_sight: {within: 5 nmi, memory: 3 s}}", desk));
}

TEST(InSight, HoldsForWhatIsNearInAnyCase) {
  Desk desk;
  desk.track({4 * kNmi, 0, 0});
  EXPECT_TRUE(holds("{in_sight: {within: 5 nmi}}", desk));
  EXPECT_FALSE(holds("{in_sight: {within: 3 nmi}}", desk));
  desk.tracks.tracks[0].identity = Identity::friendly;
  EXPECT_FALSE(holds("{in_sight: {within: 5 nmi}}", desk));
}

TEST(AreaClear, WaitsBeforeItHolds) {
  Desk desk;
  Pilot pilot("{area_clear: {within: 50 nmi, for: 20 s}}");
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 19.9;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 0.1;
  EXPECT_EQ(pilot.decide(desk).status, kSuccess);
}

TEST(AreaClear, StartsAnewWhenSomebodyComes) {
  Desk desk;
  Pilot pilot("{area_clear: {within: 50 nmi, for: 20 s}}");
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 15;
  desk.track({40 * kNmi, 0, 0}, 0, 0, Identity::unknown);
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.tracks.count = 0;
  desk.time += 15;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 20;
  EXPECT_EQ(pilot.decide(desk).status, kSuccess);
}

TEST(AreaClear, HoldsForNobodyWhoTurnedAwayFromThem) {
  Desk desk;
  Pilot pilot("{area_clear: {within: 50 nmi, for: 20 s, memory: 2 min}}");
  desk.track({-6 * kNmi, 0, 0});  // behind
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.tracks = {};
  desk.time += 60;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.own = model::test::flying(desk.own.position, kPi, 250);  // turns and looks
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 20;
  EXPECT_EQ(pilot.decide(desk).status, kSuccess);
  // who does not look knows it when the time is up
  Pilot other("{area_clear: {within: 50 nmi, for: 20 s, memory: 2 min}}");
  desk.track({6 * kNmi, 0, 0});
  EXPECT_EQ(other.decide(desk).status, kFailure);
  desk.tracks = {};
  for (const double later : {119.9, 0.2, 19.7}) {
    desk.time += later;
    EXPECT_EQ(other.decide(desk).status, kFailure) << later;
  }
  desk.time += 0.4;
  EXPECT_EQ(other.decide(desk).status, kSuccess);
}

TEST(AreaClear, DoesNotMindFriendsAndWhatIsFar) {
  Desk desk;
  desk.track({10 * kNmi, 0, 0}, 0, 250, Identity::friendly);
  desk.track({60 * kNmi, 0, 0});
  EXPECT_TRUE(holds("{area_clear: {within: 50 nmi, for: 0 s}}", desk));
  EXPECT_FALSE(holds("{area_clear: {within: 70 nmi, for: 0 s}}", desk));
}

TEST(AreaClear, StartsAnewWhenAMissileIsPerceived) {
  Desk desk;
  Pilot pilot("{area_clear: {within: 50 nmi, for: 20 s}}");
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 20;
  desk.threat(1);
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "a missile comes from a place nobody sees";
  desk.threats.count = 0;
  desk.rwr.count = 1;
  desk.rwr.warnings[0].kind = model::EmissionKind::track;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 19.9;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time += 0.1;
  EXPECT_EQ(pilot.decide(desk).status, kSuccess);
}

TEST(Threatened, HoldsWhileAMissileIsPerceived) {
  Desk desk;
  EXPECT_FALSE(holds("threatened", desk));
  desk.threat(1);
  EXPECT_TRUE(holds("threatened", desk));
}

TEST(ShotInFlight, HoldsWhileTheOwnMissileFliesToTheTarget) {
  Desk desk;
  desk.track({20e3, 0, 0});
  EXPECT_FALSE(holds("shot_in_flight", desk));
  desk.agent.shots[2] = {.until = desk.time + 5, .track = TrackId{1}, .store = 0};
  EXPECT_TRUE(holds("shot_in_flight", desk));
  desk.agent.shots[2].track = TrackId{9};
  EXPECT_FALSE(holds("shot_in_flight", desk));
  desk.agent.shots[2] = {.until = desk.time - 5, .track = TrackId{1}, .store = 0};
  EXPECT_FALSE(holds("shot_in_flight", desk));
}

TEST(ShotInFlight, MayMeanAnyTargetThatIsStillTracked) {
  Desk desk;
  desk.track({20e3, 0, 0});
  desk.track({40e3, 0, 0});
  desk.agent.target = TrackId{1};
  desk.agent.shots[1] = {.until = desk.time + 5, .track = TrackId{2}, .store = 0};
  EXPECT_FALSE(holds("shot_in_flight", desk));
  EXPECT_TRUE(holds("{shot_in_flight: {any: true}}", desk));
  desk.agent.shots[1].track = TrackId{9};
  EXPECT_FALSE(holds("{shot_in_flight: {any: true}}", desk)) << "nothing left to guide it by";
  desk.agent.shots[1] = {.until = desk.time - 5, .track = TrackId{2}, .store = 0};
  EXPECT_FALSE(holds("{shot_in_flight: {any: true}}", desk));
}

}  // namespace
}  // namespace eyrie::pilot
