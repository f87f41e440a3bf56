// SPDX-License-Identifier: MIT
#include "pilot/danger.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(TimeToGo, IsWhatTheReceiverSaysOrElseTheRangeThatIsSeen) {
  Desk desk;
  model::InboundMissile& missile = desk.threat(0.5);
  EXPECT_FALSE(time_to_go(desk.state(), missile));
  missile.has_position = 1;
  missile.range = 6000;
  missile.position_time = desk.time - 1;
  EXPECT_NEAR(*time_to_go(desk.state(), missile), 5, 1e-12);
  missile.arrival = desk.time + 11;
  EXPECT_NEAR(*time_to_go(desk.state(), missile), 11, 1e-12);
  desk.time += 20;
  EXPECT_EQ(*time_to_go(desk.state(), missile), 0);
}

TEST(MissileInbound, IsTrueOfOneThatIsHereSoonOnly) {
  Desk desk;
  desk.threat(0.5);
  EXPECT_FALSE(holds("missile_inbound", desk)) << "it may be for a mate";
  desk.threats.missiles[0].arrival = desk.time + 9;
  EXPECT_FALSE(holds("{missile_inbound: {within: 8 s}}", desk));
  EXPECT_TRUE(holds("{missile_inbound: {within: 10 s}}", desk));
  desk.threats.missiles[0].at_mate = desk.time - 1;
  EXPECT_FALSE(holds("{missile_inbound: {within: 10 s}}", desk)) << "it rests on a mate";
  desk.threats.missiles[0].at_mate = desk.time - 5;
  EXPECT_TRUE(holds("{missile_inbound: {within: 10 s}}", desk)) << "he has not said so since";
}

TEST(Spiked, NeedsARadarThatTracks) {
  Desk desk;
  desk.rwr.count = 2;
  desk.rwr.warnings[0] = {.kind_time = desk.time - 3, .kind = model::EmissionKind::missile_seeker};
  desk.rwr.warnings[1] = {.kind_time = desk.time - 3, .kind = model::EmissionKind::search};
  EXPECT_FALSE(holds("spiked", desk));
  desk.rwr.warnings[1].kind = model::EmissionKind::track;
  EXPECT_TRUE(holds("{spiked: {for: 3 s}}", desk));
  EXPECT_FALSE(holds("{spiked: {for: 4 s}}", desk));
}

TEST(Spiked, CountsTheTimeOfBeingTrackedAlone) {
  Desk desk;
  const auto hear = [&](double ago, model::EmissionKind kind) {
    model::sensor::show(desk.rwr, {.time = desk.time - ago,
                                   .first_time = desk.time - ago,
                                   .emitter = PlayerId{9},
                                   .kind = kind});
  };
  hear(20, model::EmissionKind::search);
  hear(2, model::EmissionKind::track);
  hear(0, model::EmissionKind::track);
  EXPECT_TRUE(holds("{spiked: {for: 2 s}}", desk));
  EXPECT_FALSE(holds("{spiked: {for: 3 s}}", desk));
  EXPECT_TRUE(holds("{spiked: {for: 20 s, search: true}}", desk)) << "its search counts, too";
}

TEST(Spiked, CountsTheSearchOfWhoCouldHitIfAskedTo) {
  Desk desk;
  desk.rwr.count = 1;
  desk.rwr.warnings[0] = {.bearing = 5 * kDegree, .kind = model::EmissionKind::search};
  EXPECT_FALSE(holds("{spiked: {search: true}}", desk)) << "nobody is known there";
  desk.track({30e3, 0, 0});
  EXPECT_FALSE(holds("spiked", desk));
  EXPECT_TRUE(holds("{spiked: {search: true}}", desk));
  desk.rwr.warnings[0].bearing = 60 * kDegree;
  EXPECT_FALSE(holds("{spiked: {search: true}}", desk)) << "another radar";
  desk.rwr.warnings[0].bearing = 0;
  desk.tracks.tracks[0].position = desk.own.position + Vec3{200e3, 0, 0};
  EXPECT_FALSE(holds("{spiked: {search: true}}", desk)) << "out of reach";
}

TEST(AbortRange, IsMeasuredInTheEnemysNoEscapeRange) {
  Desk desk;
  EXPECT_FALSE(holds("abort_range", desk)) << "nobody is there";
  const model::Track& track = desk.track({40e3, 0, 0});
  const State s = desk.state();
  const Reach zone = s.reach_of(s.tracks_seen()[0]);
  ASSERT_GT(zone.r_ne, 0);
  // the mirror image of the own zone against him: same type, same speed, same height
  const auto own = s.zone(kMedium, s.tracks_seen()[0]);
  EXPECT_NEAR(zone.r_ne, own.r_ne, 0.01 * own.r_ne);
  EXPECT_NEAR(exposure(s)->ratio, 40e3 / zone.r_ne, 1e-9);
  EXPECT_TRUE(
      holds("{abort_range: {factor: " + std::to_string(1.01 * 40e3 / zone.r_ne) + "}}", desk));
  EXPECT_FALSE(
      holds("{abort_range: {factor: " + std::to_string(0.99 * 40e3 / zone.r_ne) + "}}", desk));
  // who flies away is no danger at any range
  desk.tracks.tracks[0].velocity = -1 * track.velocity;
  EXPECT_FALSE(exposure(desk.state()));
  desk.tracks.tracks[0].position = desk.own.position + Vec3{5e3, 0, 0};
  EXPECT_FALSE(holds("{abort_range: {factor: 20}}", desk));
}

RC_GTEST_PROP(Exposed, IsTrueWhereTheWorstExposureIsWithinTheFactor, ()) {
  Desk desk;
  const auto metres = rc::gen::map(rc::gen::inRange(-150, 150), [](int km) { return 1e3 * km; });
  for (int i = 0; i < 3; ++i)
    desk.track({*metres, *metres, *rc::gen::inRange(-8, 5) * 1e3}, *rc::gen::inRange(-3, 4));
  const State s = desk.state();
  const auto worst = exposure(s);
  for (const double factor : {0.0, 0.5, 0.95, 1.5, 5.0, worst ? worst->ratio : 20.0})
    RC_ASSERT(exposed(desk.state(), factor) == (worst && worst->ratio <= factor));
}

TEST(Outnumbered, CountsHostilesAgainstTheLiving) {
  Desk desk;
  desk.in_flight(2, 1);
  desk.track({30 * kNmi, 0, 0});
  desk.track({30 * kNmi, 5000, 0});
  EXPECT_FALSE(holds("outnumbered", desk));
  desk.lose(2);
  EXPECT_TRUE(holds("outnumbered", desk));
  EXPECT_FALSE(holds("{outnumbered: {by: 2}}", desk));
  EXPECT_FALSE(holds("{outnumbered: {within: 20 nmi}}", desk));
}

TEST(SupportNeeded, TurnsIntoShotActiveWhenTheSeekerIsOn) {
  Desk desk;
  EXPECT_FALSE(holds("support_needed", desk));
  EXPECT_FALSE(holds("shot_active", desk)) << "no missile flies at all";
  const model::Track& track = desk.track({60e3, 0, 0});
  desk.agent.shots[0] = {.until = desk.time + 60, .track = track.id, .store = kMedium};
  EXPECT_TRUE(holds("support_needed", desk));
  EXPECT_FALSE(holds("shot_active", desk));
  desk.agent.shots[0].until = desk.time + 3;
  EXPECT_FALSE(holds("support_needed", desk));
  EXPECT_TRUE(holds("shot_active", desk));
  desk.agent.shots[1] = {.until = desk.time + 60, .track = track.id, .store = kMedium};
  EXPECT_FALSE(holds("shot_active", desk)) << "the second one still needs it";
}

TEST(SupportNeeded, IsNotNeededAgainForASeekerThatWasOn) {
  Desk desk;
  model::Track& track = desk.track({60e3, 0, 0});
  desk.agent.shots[0] = {.until = desk.time + 3, .track = track.id, .store = kMedium};
  account_for_shots(desk.state(), desk.agent);
  track.velocity = {-9000, 0, 0};  // an error of the track: the seeker would not be on yet
  EXPECT_FALSE(holds("support_needed", desk));
  desk.agent.shots[0].active = 0;
  EXPECT_TRUE(holds("support_needed", desk));
}

TEST(SupportLeft, IsNoneForAnInfraredMissileAndInVainWithoutATrack) {
  Desk desk;
  desk.track({60e3, 0, 0});
  EXPECT_EQ(support_left(desk.state(), {0, desk.time + 60, desk.tracks.tracks[0].id, kShort}), 0);
  EXPECT_FALSE(support_left(desk.state(), {0, desk.time + 60, TrackId{77}, kMedium}));
}

}  // namespace
}  // namespace eyrie::pilot
