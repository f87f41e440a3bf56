// SPDX-License-Identifier: MIT
// What the sensors must keep as a system: only own rows, any worker count, no allocation.
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <vector>

#include "model/sensor/sensor_system.hpp"
#include "support/model/air_war.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::model::sensor {
namespace {

using test::AirWar;
using test::flying;

using test::kHigh;

/// Two lines abreast that close in on each other, four flights' worth of neighbours on each side.
void two_lines(AirWar& war, int each) {
  for (int i = 0; i < each; ++i) {
    war.add(Side::blue, flying({0, 1829.0 * i, kHigh}, 0, 250), i % 7 == 6);
    war.add(Side::red, flying({50e3, 1829.0 * i, kHigh - 500}, kPi, 250));
  }
}

TEST(SensorRules, ARowWritesOnlyItself) {
  AirWar war;
  two_lines(war, 6);
  war.build();
  war.fly(6);
  war.launch(PlayerId{2}, Side::red, flying({30e3, 0, kHigh}, kPi, 800), PlayerId{1});
  constexpr std::size_t kRow = 5;
  int wrote = 0;
  for (int step = 0; step < 300; ++step) {
    const sim::World before = *war.world;
    sim::Outbox out;
    const sim::StepInfo info{war.world->step(), war.world->seed(), 0.02};
    war.sensors->perceive(*war.world, info, {kRow, kRow + 1}, out);
    war.sensors->act(*war.world, info, {kRow, kRow + 1}, out);
    for (std::uint32_t c = 0; c < war.world->schema().columns().size(); ++c) {
      const sim::ColumnInfo& column = war.world->schema().column(c);
      const auto a = before.column_bytes(c), b = war.world->column_bytes(c);
      for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i]) {
          ++wrote;
          ASSERT_EQ(i / column.stride, kRow) << column.name;
          ASSERT_EQ(column.table, war.aircraft.table);
        }
    }
    *war.world = before;
    war.fly(0.02);
  }
  EXPECT_GT(wrote, 1000) << "it did perceive something";
}

TEST(SensorRules, TheOrderOfRowsDoesNotMatter) {
  AirWar war;
  two_lines(war, 5);
  war.build();
  war.fly(8);
  for (int step = 0; step < 120; ++step) {
    const sim::StepInfo info{war.world->step(), war.world->seed(), 0.02};
    sim::World forwards = *war.world, backwards = *war.world;
    sim::Outbox out;
    const std::size_t rows = 10;
    war.sensors->perceive(forwards, info, {0, rows}, out);
    war.sensors->act(forwards, info, {0, rows}, out);
    for (std::size_t i = rows; i-- > 0;)
      war.sensors->perceive(backwards, info, {i, i + 1}, out);
    for (std::size_t i = rows; i-- > 0;)
      war.sensors->act(backwards, info, {i, i + 1}, out);
    ASSERT_EQ(forwards.hash(), backwards.hash()) << "step " << step;
    war.fly(0.02);
  }
}

TEST(SensorRules, AnyNumberOfWorkersGivesTheSameWorld) {
  const auto hash = [](unsigned workers) {
    AirWar war;
    two_lines(war, 300);
    war.build(3, workers);
    war.fly(4);
    return war.world->hash();
  };
  const std::uint64_t one = hash(1);
  EXPECT_EQ(hash(2), one);
  EXPECT_EQ(hash(3), one);
}

TEST(SensorRules, ASaveInMidRunChangesNothing) {
  AirWar war;
  two_lines(war, 4);
  war.build();
  war.fly(7);
  const sim::World saved = *war.world;
  war.fly(5);
  const std::uint64_t straight = war.world->hash();
  *war.world = saved;
  war.fly(5);
  EXPECT_EQ(war.world->hash(), straight);
  EXPECT_TRUE(war.world->canonical());
}

TEST(SensorRules, NothingIsAllocatedInAStep) {
  AirWar war;
  two_lines(war, 20);
  war.build();
  war.fly(10);
  war.launch(PlayerId{2}, Side::red, flying({30e3, 0, kHigh}, kPi, 800), PlayerId{1});
  NoAllocation guard;
  for (int step = 0; step < 200; ++step)
    static_cast<void>(war.simulation->step(*war.world, *war.work));
}

TEST(SensorRules, RatesThatDoNotFitTheStepAndFlightsThatAreTooBigAreRefused) {
  AirWar odd;
  odd.models.radars = {};
  odd.models.radars.add("odd", {.scan_rate = 0.3});
  EXPECT_THROW(odd.build(), std::logic_error);
  AirWar big;
  for (std::uint32_t i = 1; i <= 9; ++i)
    big.models.flights[0].members.push_back(PlayerId{i});
  EXPECT_THROW(big.build(), std::logic_error);
}

TEST(SensorRules, AnAircraftWithoutSensorsPerceivesNothingAndHarmsNobody) {
  AirWar war;
  AircraftType blind;
  blind.label = "blind";
  war.models.aircraft = {};
  war.models.aircraft.add("blind", blind);
  two_lines(war, 2);
  war.build();
  war.fly(5);
  for (const TrackFile& file : war.world->rows(war.aircraft.tracks))
    EXPECT_EQ(file.count, 0u);
  EXPECT_TRUE(war.events.empty());
}

}  // namespace
}  // namespace eyrie::model::sensor
