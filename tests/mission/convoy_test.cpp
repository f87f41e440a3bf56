// SPDX-License-Identifier: MIT
/// \file  Aircraft and a convoy meet: scenarios/convoy.yaml, flown.
#include <gtest/gtest.h>

#include "support/flight.hpp"

namespace eyrie::test {
namespace {

const model::Kinematics& vehicle(const Flight& f, std::string_view name) {
  const auto& columns = *f.scenario->vehicles;
  const auto row = f.world().row(columns.table, f.scenario->roster.find(name).value());
  return f.world().rows(columns.kinematics)[row.value()];
}
double gap(const Flight& f, std::string_view ahead, std::string_view behind) {
  return norm(vehicle(f, ahead).position - vehicle(f, behind).position);
}

TEST(Convoy, DrivesScattersClosesUpAndArrives) {
  Flight f(load_scenario("convoy"));
  const std::vector<std::string> names{"supply1", "supply2", "supply3", "supply4", "supply5"};

  // in column, round the first bend
  f.fly_until(300);
  for (std::size_t i = 1; i < names.size(); ++i)
    EXPECT_NEAR(gap(f, names[i - 1], names[i]), 60, 5) << names[i];
  EXPECT_TRUE(f.log.of(EventKind::scatter).empty());

  // the first of them who sees the raid tells the others: soon all leave the road
  while (!f.log.first(EventKind::scatter) && f.mission.step()) {
  }
  const double raid = f.time();
  EXPECT_GT(raid, 300);
  f.fly_until(raid + 60);
  for (const std::string& name : names) {
    const auto scattered = f.log.first(EventKind::scatter, name);
    ASSERT_TRUE(scattered) << name;
    EXPECT_LT(scattered->time, raid + 30) << name;
    EXPECT_EQ(f.scenario->roster.find(scattered->event.whom)->side, model::Side::red);
    EXPECT_EQ(vehicle(f, name).speed, 0) << name << " stands off the road";
  }
  EXPECT_GT(gap(f, "supply1", "supply2"), 300) << "to both sides";

  // they come back and have closed up, or nearly, when the mine goes off
  f.fly_until(719);
  for (std::size_t i = 1; i < names.size(); ++i)
    EXPECT_LT(gap(f, names[i - 1], names[i]), 200) << names[i];
  f.fly_until(721);
  ASSERT_TRUE(f.log.first(EventKind::loss, "supply1"));
  EXPECT_GT(norm(Vec3{f.log.first(EventKind::loss)->event.place}), 5e3);

  // the next in rank knows it after the radio's timeout, leads, and the column closes up
  f.fly_until(735);
  const auto change = f.log.first(EventKind::lead_change, "supply2");
  ASSERT_TRUE(change);
  EXPECT_EQ(f.scenario->roster.name(change->event.whom), "supply1");
  f.fly_until(900);
  for (std::size_t i = 2; i < names.size(); ++i)
    EXPECT_NEAR(gap(f, names[i - 1], names[i]), 60, 5) << names[i];

  // and arrives; the fight above went on meanwhile
  f.mission.fly();
  EXPECT_EQ(f.mission.outcome(), scenario::Outcome::blue_home);
  const Vec3 end = f.scenario->library->flights.back().routes.at(0).waypoints.back().position;
  EXPECT_LT(norm(vehicle(f, "supply2").position - end), 60);
  for (const std::string& name : names) {
    if (name != "supply1") {
      EXPECT_EQ(vehicle(f, name).speed, 0) << name;
    }
  }
  EXPECT_EQ(f.tally.side(model::Side::blue).home, 2u);
  EXPECT_EQ(f.tally.side(model::Side::blue).players, 2u) << "who may come home: no vehicle";
}

TEST(Convoy, IsSafeFromFriendsAndScattersForEnemiesOverManySeeds) {
  int scattered = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Flight f(load_scenario("convoy"), seed);
    f.mission.fly();
    EXPECT_NE(f.mission.outcome(), scenario::Outcome::time) << seed;
    EXPECT_EQ(f.log.of(EventKind::loss).size(), 1u) << seed;
    scattered += !f.log.of(EventKind::scatter).empty();
  }
  EXPECT_GE(scattered, 7) << "unless all of them are shot far away";
}

TEST(Convoy, DrivesAloneAndTheRunEndsWhenItHasArrived) {
  auto source = scenario::Source::disk(".");
  source.add("alone.yaml",
             "eyrie: 1\nname: alone\nreference: {latitude: 33 deg, longitude: -68 deg}\n"
             "include: scenarios/packages/drivers.yaml\n"
             "blue: {convoys: {column: {vehicle: m939, tree: convoy, players: [column1, column2],\n"
             "  start: {north: 0 km, east: 0 km, heading: 0 deg},\n"
             "  route: [{north: 1 km, east: 0 km}, {north: 1 km, east: -1 km}]}}}\n");
  Flight f(scenario::load({"alone.yaml", {}}, source));
  f.mission.fly();
  EXPECT_EQ(f.mission.outcome(), scenario::Outcome::blue_home);
  EXPECT_TRUE(f.log.of(EventKind::scatter).empty());
}

TEST(Convoy, WithoutAWayStops) {
  Flight f(load_scenario("convoy", {"blue.convoys.supply.route=[]"}));
  f.fly_until(60);
  for (const char* name : {"supply1", "supply5"})
    EXPECT_EQ(vehicle(f, name).speed, 0) << name;
}

TEST(Convoy, StartsNoFasterThanItDrives) {
  try {
    static_cast<void>(load_scenario("convoy", {"blue.convoys.supply.start.speed=90 m/s"}));
    FAIL();
  } catch (const ConfigError& e) {
    EXPECT_NE(std::string(e.what()).find("supply1: a m939 drives no faster than 101 km/h"),
              std::string::npos)
        << e.what();
  }
}

TEST(Convoy, IsSwappedToAnotherTreeByAnOrder) {
  Flight f(load_scenario("convoy", {"orders.0={at: 100 s, player: supply1, swap_tree: halt}",
                                    "trees.halt={navigate: {route: 1}}"}));
  f.fly_until(101);
  ASSERT_EQ(f.log.of(EventKind::order, "supply1").size(), 1u);
  EXPECT_EQ(f.world().rows(f.scenario->drivers.agent)[0].tree,
            f.scenario->driver_trees->find("halt"));
}

}  // namespace
}  // namespace eyrie::test
