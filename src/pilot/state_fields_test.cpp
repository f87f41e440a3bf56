// SPDX-License-Identifier: MIT
/// \file  What files may read of a pilot's state by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

using Fields = std::map<std::string_view, double>;

Fields fields_of(const Desk& desk) {
  const State state = desk.state();
  Fields fields;
  for (const auto& field : ubf::StateFields<State>::all())
    fields[field.info.name] = field.read(state);
  return fields;
}

TEST(StateFields, HaveDistinctNamesThatExpressionsCanSayAndHelp) {
  std::set<std::string_view> names;
  for (const auto& field : ubf::StateFields<State>::all()) {
    const std::string_view name = field.info.name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_FALSE(field.info.help.empty()) << name;
    EXPECT_TRUE(name != "and" && name != "or" && name != "not");
    EXPECT_TRUE(std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || c == '_';
    })) << name;
  }
  EXPECT_GT(names.size(), 20u);
}

TEST(StateFields, TellOfTheOwnAircraftAndFlight) {
  Desk desk;
  desk.in_flight(4, 2);
  desk.lose(4);
  desk.own.pitch = 0.1;
  desk.own.mach = 0.8;
  const Fields f = fields_of(desk);
  EXPECT_EQ(f.at("time"), 100);
  EXPECT_EQ(f.at("altitude"), 8000);
  EXPECT_EQ(f.at("speed"), 250);
  EXPECT_EQ(f.at("mach"), 0.8);
  EXPECT_EQ(f.at("pitch"), 0.1);
  EXPECT_EQ(f.at("fuel"), 1500);
  EXPECT_EQ(f.at("bingo"), 0);
  EXPECT_EQ(f.at("missiles"), 4);
  EXPECT_EQ(f.at("rounds"), desk.gun.rounds);
  EXPECT_EQ(f.at("rank"), 2);
  EXPECT_EQ(f.at("alive"), 3);
  EXPECT_EQ(f.at("leads"), 0);
  EXPECT_NEAR(f.at("home_range"), 50 * kNmi, 100);
  desk.propulsion.fuel = 499;
  EXPECT_EQ(fields_of(desk).at("bingo"), 1);
}

TEST(StateFields, TellOfTargetAndThreatAndHaveNoValueWithoutThem) {
  Desk desk;
  for (const char* name : {"range", "closing", "off_nose", "target_above", "missile_range"})
    EXPECT_TRUE(std::isnan(fields_of(desk).at(name))) << name;
  EXPECT_EQ(fields_of(desk).at("has_target"), 0);
  desk.track({0, 20e3, -1000}, kPi / 2, 300);
  desk.track({90e3, 0, 0}, kPi, 250, model::Identity::unknown);
  desk.threat(0, 9e3);
  Fields f = fields_of(desk);
  EXPECT_EQ(f.at("tracks"), 2);
  EXPECT_EQ(f.at("hostiles"), 1);
  EXPECT_EQ(f.at("suspects"), 2);
  EXPECT_EQ(f.at("has_target"), 1);
  EXPECT_NEAR(f.at("range"), std::hypot(20e3, 1e3), 1);
  EXPECT_NEAR(f.at("off_nose"), kPi / 2, 1e-3);
  EXPECT_NEAR(f.at("target_above"), f.at("target_altitude") - f.at("altitude"), 1e-6);
  EXPECT_NEAR(f.at("target_above"), 1000 + 20e3 * 20e3 / 2 / 6371e3, 0.1) << "the Earth is round";
  EXPECT_LT(f.at("closing"), -250) << "it runs away to the east";
  EXPECT_EQ(f.at("threatened"), 1);
  EXPECT_EQ(f.at("missile_range"), 9e3);
}

TEST(StateFields, SayOnWhichSideTheTargetIs) {
  Desk desk;  // at 8000 m, north at 250 m/s
  desk.track({-3000, -4000, -1000}, -kPi / 2, 200);
  Fields f = fields_of(desk);
  EXPECT_NEAR(f.at("target_right"), std::atan2(-4000, -3000), 1e-9);
  EXPECT_NEAR(f.at("target_up"), std::atan2(1000, 5000), 1e-9);
  EXPECT_NEAR(f.at("target_azimuth"), f.at("target_right"), 1e-9) << "wings level";
  EXPECT_NEAR(f.at("target_elevation"), f.at("target_up"), 1e-9);
  EXPECT_NEAR(f.at("target_course"), -kPi / 2, 1e-9);
  EXPECT_NEAR(f.at("target_aspect"), std::atan2(3000, -4000), 1e-9) << "behind him on his right";
  EXPECT_NEAR(f.at("target_speed"), 200, 1e-9);
  EXPECT_NEAR(f.at("target_climb"), 0, 1e-12);
  EXPECT_NEAR(f.at("target_altitude"), 9000, 3) << "the Earth is round";
  EXPECT_EQ(f.at("target_age"), 0);

  // with the right wing down he is over the canopy if he is right
  desk.tracks.tracks[0].position = desk.own.position + Vec3{3000, 4000, 0};
  desk.own.roll = kPi / 2;
  f = fields_of(desk);
  EXPECT_EQ(f.at("roll"), kPi / 2);
  EXPECT_NEAR(f.at("target_elevation"), std::atan2(4000, 3000), 1e-9);
  EXPECT_NEAR(f.at("target_azimuth"), 0, 1e-9);
  EXPECT_NEAR(f.at("off_nose"), std::atan2(4000, 3000), 1e-9);
}

TEST(StateFields, TellHowFastTheLineOfSightTurns) {
  Desk desk;
  desk.track({4000, 0, 0}, kPi / 2, 200);  // crosses to the right
  Fields f = fields_of(desk);
  EXPECT_NEAR(f.at("drift_right"), 200.0 / 4000, 1e-9);
  EXPECT_NEAR(f.at("drift_up"), 0, 1e-12);
  desk.tracks.tracks[0].velocity = desk.own.velocity + Vec3{0, 0, -100};
  f = fields_of(desk);
  EXPECT_NEAR(f.at("drift_right"), 0, 1e-12);
  EXPECT_NEAR(f.at("drift_up"), 100.0 / 4000, 1e-9);
  desk.own.load_factor = 2;
  desk.own.roll = -kPi / 3;
  desk.own.velocity.z = -20;
  f = fields_of(desk);
  EXPECT_NEAR(f.at("turn_rate"), -2 * 9.80665 * std::sin(kPi / 3) / 250, 1e-9);
  EXPECT_EQ(f.at("climb_rate"), 20);
}

TEST(StateFields, TellWhoseWeaponsReach) {
  Desk desk;
  desk.track({12e3, 0, 0});
  const State state = desk.state();
  const auto zone = state.zone(kMedium, *state.target());
  ASSERT_GT(zone.r_max, state.zone(kShort, *state.target()).r_max);
  Fields f = fields_of(desk);
  EXPECT_NEAR(f.at("over_r_max"), 12e3 / zone.r_max, 1e-9);
  EXPECT_NEAR(f.at("over_r_ne"), 12e3 / zone.r_ne, 1e-9);
  EXPECT_NEAR(f.at("over_his_r_max"), 12e3 / zone.r_max, 0.01) << "a mirror image";
  EXPECT_EQ(f.at("in_zone"), 1);
  EXPECT_EQ(f.at("shots"), 0);
  desk.own = model::test::flying(desk.own.position, kPi, 250);
  f = fields_of(desk);
  EXPECT_EQ(f.at("in_zone"), 0) << "dead astern";
  EXPECT_EQ(f.at("over_r_max"), math::kInfinity);
  desk.own = model::test::flying(desk.own.position, 0, 250);
  desk.agent.shots[0] = {.until = 200, .track = TrackId{1}, .store = kMedium};
  EXPECT_EQ(fields_of(desk).at("shots"), 1);
  EXPECT_EQ(fields_of(desk).at("supporting"), 1);
  desk.stores = {};
  f = fields_of(desk);
  EXPECT_EQ(f.at("in_zone"), 0);
  EXPECT_EQ(f.at("over_r_max"), math::kInfinity);

  const double reach = library().guns[0].greatest_range;
  EXPECT_NEAR(f.at("over_gun_range"), 12e3 / reach, 1e-9);
  EXPECT_EQ(f.at("in_gun"), 0);
  desk.tracks.tracks[0].position = desk.own.position + Vec3{0.5 * reach, 0, 0};
  desk.tracks.tracks[0].velocity = desk.own.velocity;
  f = fields_of(desk);
  EXPECT_EQ(f.at("in_gun"), 1);
  EXPECT_NEAR(f.at("gun_azimuth"), 0, 1e-9);
  EXPECT_GT(f.at("gun_elevation"), 0) << "rounds drop";
  EXPECT_LT(f.at("gun_elevation"), 0.5 * kDegree);
  desk.gun.rounds = 0;
  EXPECT_EQ(fields_of(desk).at("in_gun"), 0);
}

TEST(StateFields, TellOfMissilesAndRadarsOnTheirSides) {
  Desk desk;
  desk.own.heading = kPi / 2;
  desk.threat(0, 7e3);
  desk.rwr.warnings[desk.rwr.count++] = {.bearing = kPi, .kind = model::EmissionKind::track};
  const Fields f = fields_of(desk);
  EXPECT_EQ(f.at("missiles_inbound"), 1);
  EXPECT_NEAR(f.at("missile_right"), -kPi / 2, 1e-9);
  EXPECT_NEAR(f.at("missile_time"), 7e3 / model::sensor::kMissileClosing, 1e-9);
  EXPECT_EQ(f.at("missile_heard"), 0) << "it was seen";
  desk.threats.missiles[0].emitter = PlayerId{7};
  desk.threats.missiles[0].arrival = desk.time + 5;
  EXPECT_EQ(fields_of(desk).at("missile_heard"), 1);
  EXPECT_EQ(f.at("spiked"), 1);
  EXPECT_NEAR(f.at("spike_right"), kPi / 2, 1e-9);
}

TEST(StateFields, TellTheWayToTheOwnPlace) {
  Desk desk;
  EXPECT_TRUE(std::isnan(fields_of(desk).at("place_ahead")));
  desk.in_flight(2, 2);  // the lead is a mile to the west, on the own course
  Fields f = fields_of(desk);
  EXPECT_NEAR(f.at("place_ahead"), -desk.formation.behind, 1e-6);
  EXPECT_NEAR(f.at("place_right"), -1852 - desk.formation.abreast, 1e-6);
  EXPECT_NEAR(f.at("place_above"), -desk.formation.below, 1e-6);
  EXPECT_NEAR(f.at("lead_speed"), 250, 1e-6);
  EXPECT_NEAR(f.at("lead_course"), 0, 1e-6);
  desk.own.heading = kPi / 2;
  f = fields_of(desk);
  EXPECT_NEAR(f.at("place_ahead"), -1852 - desk.formation.abreast, 1e-6);
  EXPECT_NEAR(f.at("place_right"), desk.formation.behind, 1e-6);
  EXPECT_NEAR(f.at("lead_course"), -kPi / 2, 1e-6);
  EXPECT_NEAR(f.at("home_right"), kPi / 2, 1e-3) << "50 nmi to the south";
}

TEST(StateFields, LetATreeDecideInWords) {
  Pilot pilot("{guard: {when: range < 10 nmi and not threatened, child: {break_turn: {}}}}");
  Pilot chooser("{switch: {on: rank, cases: {1: navigate, 2: {follow_lead: {vote: 3}}}}}");
  Desk desk;
  desk.in_flight(2, 2);
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  EXPECT_EQ(chooser.decide(desk).proposal.vote, 3);
}

}  // namespace
}  // namespace eyrie::pilot
