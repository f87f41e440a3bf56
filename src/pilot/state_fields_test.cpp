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
  EXPECT_NEAR(f.at("target_above"), 1000, 1e-6);
  EXPECT_LT(f.at("closing"), -250) << "it runs away to the east";
  EXPECT_EQ(f.at("threatened"), 1);
  EXPECT_EQ(f.at("missile_range"), 9e3);
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
