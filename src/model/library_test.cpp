// SPDX-License-Identifier: MIT
#include "model/library.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "model/columns.hpp"
#include "sim/world.hpp"

namespace eyrie::model {
namespace {

TEST(Shelf, FindsWhatWasAddedByName) {
  Shelf<Tracker> shelf;
  EXPECT_EQ(shelf.add("slow", Tracker{.rate = 1}), 0);
  EXPECT_EQ(shelf.add("fast", Tracker{.rate = 50}), 1);
  ASSERT_EQ(shelf.find("fast"), 1);
  EXPECT_EQ(shelf[1].rate, 50);
  EXPECT_EQ(shelf.name(0), "slow");
  EXPECT_FALSE(shelf.find("medium"));
}

TEST(Shelf, RefusesANameTwice) {
  Shelf<Tracker> shelf;
  shelf.add("slow", {});
  EXPECT_THROW(shelf.add("slow", {}), std::logic_error);
}

TEST(Columns, TakeLessThanTenKilobytesPerAircraft) {
  sim::SchemaBuilder builder;
  const AircraftColumns aircraft = AircraftColumns::define(builder, 4);
  const MissileColumns missile = MissileColumns::define(builder, 8);
  const auto schema = builder.build();
  std::uint32_t bytes = 0;
  for (const sim::ColumnInfo& column : schema->columns())
    if (column.table == aircraft.table)
      bytes += column.stride;
  EXPECT_LT(bytes, 10u * 1024);
  EXPECT_EQ(schema->find_table("aircraft"), aircraft.table);
  EXPECT_EQ(schema->find_table("missile"), missile.table);
}

TEST(Columns, HandOutRowsOfTheirTopic) {
  sim::SchemaBuilder builder;
  const AircraftColumns columns = AircraftColumns::define(builder, 4);
  sim::World world(builder.build(), 1);
  ASSERT_TRUE(world.spawn(columns.table));
  world.rows(columns.command)[0].heading = 1;
  world.rows(columns.propulsion)[0].fuel = 2;
  EXPECT_EQ(world.rows(columns.command)[0].heading, 1);
  EXPECT_EQ(world.rows(columns.propulsion)[0].fuel, 2);
  EXPECT_TRUE(world.canonical());
}

TEST(ProblemsOf, NamesEachModelWhoseRateDoesNotDivideTheStepOrThatDoesNothing) {
  Library library;
  Radar odd;
  odd.track_rate = 7;
  library.radars.add("good", {});
  library.radars.add("odd", odd);
  library.visuals.add("eyes", {});
  library.datalinks.add("slow", {.rate = 1, .delay = 3});
  library.jammers.add("noise", {.power = 1});
  library.jammers.add("deceiver", {.pull_off = PullOff{}});
  library.jammers.add("dead", {});
  MissileType blinking;
  blinking.seeker.look_rate = 60;
  library.missiles.add("blinking", blinking);
  const auto problems = problems_of(library, 0.02);
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].kind, "radars");
  EXPECT_EQ(problems[0].model, "odd");
  EXPECT_EQ(problems[0].parameter, "track_rate");
  EXPECT_NE(problems[0].problem.find("7 Hz"), std::string::npos) << problems[0].problem;
  EXPECT_EQ(problems[1].model, "blinking");
  EXPECT_EQ(problems[1].parameter, "seeker.look_rate");
  EXPECT_EQ(problems[2].model, "slow");
  EXPECT_EQ(problems[2].parameter, "delay");
  EXPECT_EQ(problems[3].model, "dead");
}

TEST(ProblemsOf, NamesWhatWouldDoNothing) {
  Library library;
  library.jammers.add("careful", {.power = 1, .when_tracked = true});
  library.rwrs.add("ears", {});
  AircraftType deaf{.label = "deaf"}, hearing{.label = "hearing"};
  deaf.index.jammer = hearing.index.jammer = 0;
  hearing.index.rwr = 0;
  library.aircraft.add("deaf", deaf);
  library.aircraft.add("hearing", hearing);
  MissileType seeing;
  seeing.seeker.kind = weapon::SeekerKind::infrared;
  library.missiles.add("flat", seeing);
  seeing.guidance.loft.emplace();
  library.missiles.add("lofting", seeing);
  const auto problems = problems_of(library, 0.02);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].model, "deaf");
  EXPECT_EQ(problems[0].parameter, "jammer");
  EXPECT_EQ(problems[1].model, "lofting");
  EXPECT_EQ(problems[1].parameter, "guidance.loft");
}

TEST(ProblemsOf, NamesEachTypeWhoseNumberOtherSimulationsCannotRead) {
  Library library;
  library.aircraft.add("good", {.label = "F-15C", .entity_type = "1.2.225.1.5.3"});
  library.aircraft.add("named", {.label = "F-15C", .entity_type = "F-15C"});
  library.missiles.add("large", {.label = "large", .emitter = "70000"});
  const auto problems = problems_of(library, 0.02);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].model, "named");
  EXPECT_EQ(problems[0].parameter, "entity_type");
  EXPECT_EQ(problems[1].parameter, "emitter");
  EXPECT_EQ(problems[1].problem, "'70000' is not a number up to 65535");
}

}  // namespace
}  // namespace eyrie::model
