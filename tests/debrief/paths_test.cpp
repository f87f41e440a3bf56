// SPDX-License-Identifier: MIT
/// \file  Paths of players stay bounded however long the run is.
#include "record/paths.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "record/names.hpp"
#include "support/recorded.hpp"

namespace eyrie::record {
namespace {

/// The paths of the whole run.
void watch(const debrief::Recorded& recorded, Paths& paths, sim::Observer* other = nullptr) {
  debrief::Reflight flight(recorded);
  flight.attach(paths);
  if (other)
    flight.attach(*other);
  while (flight.step()) {
  }
  paths.finish(flight.after());
}

TEST(Paths, KeepLessOftenWhatIsLong) {
  const debrief::Recorded recorded = test::recorded_flight("merge", 60);
  const auto points = [&](std::size_t most) {
    Paths paths(*recorded.scenario, most);
    watch(recorded, paths);
    return paths.all().at(1).points;
  };
  const auto whole = points(Paths::kMost), few = points(16);
  ASSERT_EQ(whole.size(), 61U);
  EXPECT_LE(few.size(), 17U);
  EXPECT_GE(few.size(), 8U);
  EXPECT_EQ(few.front().time, 0);
  EXPECT_NEAR(few.back().time, 60, 1e-9);
  for (std::size_t i = 1; i + 1 < few.size(); ++i) {
    EXPECT_NEAR(few[i].time - few[i - 1].time, 4, 1e-9);
    EXPECT_EQ(few[i].place.latitude,
              whole[static_cast<std::size_t>(few[i].time + 0.5)].place.latitude);
  }
}

/// Where everybody was in every step, and where missiles and who crashed ended.
struct Places : sim::Observer {
  explicit Places(const scenario::Scenario& flown) : scenario(flown) {}
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    const double time = info.time_after();
    for (const sim::Event& e : events)
      if (const auto fate = fate_of(e); fate && norm(e.place) > 0)
        all[{fate->who.value, time}] = e.place;
    scenario.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
      all[{id.value, time}] = fleet.motion(world, row).position;
    });
    for (std::size_t i = 0; i < world.rows(scenario.missiles.table); ++i)
      all[{world.ids(scenario.missiles.table)[i].value, time}] =
          world.rows(scenario.missiles.kinematics)[i].position;
  }
  const scenario::Scenario& scenario;
  std::map<std::pair<std::uint32_t, double>, Vec3> all;
};

TEST(Paths, EndWhereEverybodyWasAtThatTime) {
  const debrief::Recorded recorded = test::recorded_flight("merge", 600);
  Paths paths(*recorded.scenario);
  Places places(*recorded.scenario);
  watch(recorded, paths, &places);
  std::size_t gone = 0, missiles = 0;
  for (const auto& [id, path] : paths.all()) {
    const Path::Point& last = path.points.back();
    ASSERT_TRUE(places.all.contains({id, last.time})) << path.name << " at " << last.time;
    const Geodetic is =
        recorded.scenario->library->reference.to_geodetic(places.all.at({id, last.time}));
    EXPECT_EQ(last.place.latitude, is.latitude) << path.name;
    EXPECT_EQ(last.place.altitude, is.altitude) << path.name;
    gone += !path.end.empty();
    missiles += path.kind == "missile";
  }
  EXPECT_GE(gone, 2U);
  EXPECT_GE(missiles, 1U);
}

TEST(Paths, TellWhomAircraftAttack) {
  const debrief::Recorded recorded = test::recorded_flight("merge", 60);
  Paths paths(*recorded.scenario);
  watch(recorded, paths);
  std::size_t aimed = 0;
  const auto all = nlohmann::json::parse(geojson(paths));
  for (const auto& feature : all["features"])
    if (feature["properties"].value("name", "") == "viper1" &&
        feature["properties"].contains("target")) {
      ++aimed;
      EXPECT_NE(feature["properties"]["target"], "viper1");
    }
  EXPECT_GT(aimed, 10U);
  EXPECT_LT(aimed, 60U) << "not before he is seen";
}

TEST(Paths, OfNoStepAreWherePlayersBegin) {
  const auto scenario = test::load_scenario("merge");
  Paths paths(*scenario);
  const sim::World world = scenario->world(8);
  paths.begin(world, scenario->simulation->dt());
  paths.finish(world);
  EXPECT_NE(czml(paths).find("\"viper1\""), std::string::npos);
  EXPECT_NE(geojson(paths).find("\"viper1\""), std::string::npos);
}

TEST(Paths, HaveNoNegativeZeros) {
  const debrief::Recorded recorded = test::recorded_flight("convoy", 30);
  Paths paths(*recorded.scenario);
  watch(recorded, paths);
  EXPECT_EQ(geojson(paths).find("-0.0]"), std::string::npos);
}

}  // namespace
}  // namespace eyrie::record
