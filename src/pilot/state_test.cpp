// SPDX-License-Identifier: MIT
#include "pilot/state.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using testing::Desk;

TEST(State, CarriesTracksOnToTheTimeOfTheDecision) {
  Desk s;
  model::Track& track = s.track({10e3, 0, -1000});
  track.velocity = {-200, 50, 0};
  track.time = s.time - 4;
  const State state = s.state();
  ASSERT_EQ(state.tracks_seen().size(), 1u);
  const Seen& seen = state.tracks_seen()[0];
  EXPECT_NEAR(seen.ned.x, 10e3 - 800, 1e-9);
  EXPECT_NEAR(seen.ned.y, 200, 1e-9);
  EXPECT_NEAR(seen.range, norm(Vec3{9200, 200, -1000}), 1e-9);
  // 450 m/s along the range, and a little across
  EXPECT_NEAR(state.closing_on(seen), (9200 * 450 - 200 * 50) / seen.range, 1e-9);
}

TEST(State, CallsOnlyAConfirmedTrackHostile) {
  Desk s;
  s.track({20e3, 0, 0}).confirmed = 0;
  EXPECT_FALSE(s.state().tracks_seen()[0].hostile());
  EXPECT_FALSE(s.state().tracks_seen()[0].suspect());
  s.tracks.tracks[0].confirmed = 1;
  EXPECT_TRUE(s.state().tracks_seen()[0].hostile());
  s.tracks.tracks[0].identity = model::Identity::unknown;
  EXPECT_FALSE(s.state().tracks_seen()[0].hostile());
  EXPECT_TRUE(s.state().tracks_seen()[0].suspect());
}

TEST(State, CountsTheRankAmongTheLiving) {
  Desk s;
  s.in_flight(4, 3);
  EXPECT_EQ(s.state().rank, 3u);
  EXPECT_EQ(s.state().lost, 0u);
  s.lose(1);
  EXPECT_EQ(s.state().rank, 2u);
  EXPECT_EQ(s.state().lost, 1u);
  EXPECT_EQ(s.state().lead()->id, PlayerId{2});
  s.lose(2);
  EXPECT_TRUE(s.state().leads());
  EXPECT_EQ(s.state().alive, 0b1100u);
}

TEST(State, TakesTheRankAtBirthWhileTheDatalinkIsDown) {
  Desk s;
  s.fit.rank = 2;
  EXPECT_EQ(s.state().rank, 2u);
  EXPECT_EQ(s.state().lead(), nullptr);
  EXPECT_FALSE(s.state().leader());
}

TEST(State, DoesNotCountAMateWhoLandedAsLost) {
  Desk s;
  s.in_flight(2, 2);
  s.lose(1);
  const Vec3 home = *testing::library().flights[0].home;
  s.datalink.members[0].position = home + Vec3{3000, 0, -1500};
  EXPECT_EQ(s.state().lost, 0u);
  s.datalink.members[0].position = home + Vec3{30e3, 0, -1500};
  EXPECT_EQ(s.state().lost, 1u);
}

TEST(State, KnowsTheLeadFromTheDatalink) {
  Desk s;
  s.in_flight(2, 2);
  s.datalink.members[0].time = s.time - 2;
  const auto leader = s.state().leader();
  ASSERT_TRUE(leader);
  EXPECT_NEAR(leader->position.x, 500, 1e-3);  // two seconds at 250 m/s
  EXPECT_NEAR(leader->position.y, -1852, 1e-3);
  EXPECT_NEAR(leader->velocity.x, 250, 1e-3);
}

TEST(State, KnowsAnUnheardLeadOnlyIfItIsPrivileged) {
  Desk s;
  s.in_flight(2, 2);
  s.datalink.members[0].reported = 0;
  model::Track& track = s.track({4000, 0, 0}, 0, 250, model::Identity::friendly);
  track.truth = PlayerId{1};
  EXPECT_FALSE(s.state().leader()) << "whose track it is was not perceived";
  track.sources = model::kFromTruth;
  ASSERT_TRUE(s.state().leader());
  EXPECT_NEAR(s.state().leader()->position.x, 4000, 1e-9);
}

TEST(State, WorriesAboutTheNearestMissileOfKnownRange) {
  Desk s;
  EXPECT_EQ(s.state().threat(), nullptr);
  s.threat(0.1);
  EXPECT_EQ(s.state().threat()->truth, PlayerId{101});
  s.threat(1.0, 9000);
  s.threat(2.0, 4000);
  EXPECT_EQ(s.state().threat()->truth, PlayerId{103});
}

TEST(State, MeasuresTheWayHomeAlongTheGround) {
  Desk s;
  s.own.position = *testing::library().flights[0].home - Vec3{3000, 4000, 8000};
  EXPECT_NEAR(*s.state().home_distance(), 5000, 1e-9);
  s.fit.flight = 1;  // which has no home
  EXPECT_FALSE(s.state().home_distance());
}

TEST(State, AsksTheMissileForItsZone) {
  Desk s;
  s.track({20e3, 0, 0});
  const State state = s.state();
  const auto head_on = state.zone(testing::kMedium, state.seen[0]);
  EXPECT_TRUE(head_on.possible());
  EXPECT_GT(head_on.r_max, head_on.r_ne);
  EXPECT_GT(head_on.r_max, state.zone(testing::kShort, state.seen[0]).r_max);
  s.tracks.tracks[0].velocity = {250, 0, 0};  // he runs
  const State running = s.state();
  EXPECT_LT(running.zone(testing::kMedium, running.seen[0]).r_max, head_on.r_max);
}

TEST(State, AsksForZonesByTheSpeedsThroughTheAir) {
  Desk s;
  model::Track& he = s.track({20e3, 0, 0});
  const State calm = s.state();
  const auto zone = calm.zone(testing::kMedium, calm.seen[0]);
  const double own_reach = calm.own_reach(calm.seen[0]).r_ne;
  const double his_reach = calm.reach_of(calm.seen[0]).r_ne;
  s.models = &testing::windy_library();
  // both are carried along
  s.own.velocity += Vec3{60, 0, 0};
  he.velocity.x += 60;
  const State carried = s.state();
  EXPECT_NEAR(carried.zone(testing::kMedium, carried.seen[0]).r_max, zone.r_max, 1);
  EXPECT_NEAR(carried.own_reach(carried.seen[0]).r_ne, own_reach, 1);
  EXPECT_NEAR(carried.reach_of(carried.seen[0]).r_ne, his_reach, 1);
}

TEST(State, TurnsAClimbAngleIntoAnAltitudeThatTheAutopilotClimbsTo) {
  Desk s;
  const double hold = testing::library().airframes[0].autopilot.altitude_time;
  EXPECT_NEAR(s.state().altitude_for(0.2), 8000 + 250 * math::sin(0.2) * hold, 1e-9);
  EXPECT_NEAR(s.state().altitude_for(0), 8000, 1e-12);
}

TEST(State, MeasuresAnglesFromTheNose) {
  Desk s;
  s.own.heading = 0.3;
  s.own.pitch = 0.1;
  EXPECT_NEAR(s.state().off_nose(nose_of(s.own)), 0, 1e-12);
  EXPECT_NEAR(s.state().off_nose(-nose_of(s.own)), kPi, 1e-7);
}

}  // namespace
}  // namespace eyrie::pilot
