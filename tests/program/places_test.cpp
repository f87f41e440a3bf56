// SPDX-License-Identifier: MIT
/// \file  The places in GeoJSON and CZML, read by the textbook, against the truth and the scenario.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "record/paths.hpp"
#include "support/flight.hpp"
#include "support/program.hpp"
#include "support/truth.hpp"
#include "support/wgs84.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// What both formats say of a flight, and what was.
struct Exported {
  std::shared_ptr<const scenario::Scenario> scenario;
  Truth truth;
  record::Paths paths;
  Place reference;
  json geojson, czml;

  Exported(std::shared_ptr<const scenario::Scenario> what, double until)
      : scenario(std::move(what)), truth(*scenario), paths(*scenario) {
    scenario::Mission mission(scenario, scenario->spec.seed, until);
    mission.run().attach(truth);
    mission.run().attach(paths);
    mission.fly();
    geojson = json::parse(record::geojson(paths));
    czml = json::parse(record::czml(paths));
    constexpr double kDegree = 0.017453292519943295;
    reference = {scenario->spec.reference.longitude / kDegree,
                 scenario->spec.reference.latitude / kDegree, 0};
  }

  /// How far the truth of that moment is from a place; a moment that nobody looked at is no miss.
  void expect_at(std::uint32_t id, double time, const Place& place) {
    for (const Truth::At& at : truth.all().at(id))
      if (std::fabs(at.time - time) < 0.005) {
        const auto [north, east, down] = ned_between(reference, place);
        ++compared;
        ASSERT_LT(norm(Vec3{north, east, down} - at.k.position), kMeters) << id << " at " << time;
      }
  }
  std::size_t compared = 0;

  /// Half a centimeter in each direction and half of a tenth upward are written away.
  static constexpr double kMeters = 0.06;
};

Place place_of(const json& coordinates) {
  return {coordinates.at(0), coordinates.at(1), coordinates.at(2)};
}

void expect_true(Exported& e) {
  auto path = e.paths.all().begin();
  for (const json& feature : e.geojson["features"]) {
    if (!feature["properties"].contains("times_s"))
      continue;
    while (path->second.points.size() < 2)
      ++path;
    ASSERT_EQ(feature["properties"]["name"], path->second.name);
    const json& times = feature["properties"]["times_s"];
    std::size_t i = 0;
    for (const json& line : feature["geometry"]["coordinates"])
      for (const json& point : line)
        e.expect_at(path->first, times.at(i++), place_of(point));
    EXPECT_EQ(i, times.size());
    ++path;
  }
  EXPECT_GT(e.compared, 500u);
  e.compared = 0;
  for (const json& packet : e.czml) {
    if (packet["id"] == "document")
      continue;
    const auto id = std::stoul(packet["id"].get<std::string>().substr(7));
    const json& all = packet["position"]["cartographicDegrees"];
    for (std::size_t i = 0; i < all.size(); i += 4)
      e.expect_at(static_cast<std::uint32_t>(id), all[i], {all[i + 1], all[i + 2], all[i + 3]});
  }
  EXPECT_GT(e.compared, 500u);
}

TEST(Places, AreTrueInAFightWithMissiles) {
  Exported e(load_scenario("sweep"), 14 * 60);
  expect_true(e);
}

TEST(Places, AreTrueForVehicles) {
  Exported e(load_scenario("convoy"), 10 * 60);
  expect_true(e);
}

/// scenarios/sweep.yaml gives places north and east of 33 N 68 W.
TEST(Places, OfAPlanAreThoseOfTheScenario) {
  const Exported e(load_scenario("sweep"), 2);
  const Place reference{-68, 33, 0};
  constexpr double kMile = 1852;
  std::size_t found = 0;
  const auto expect = [&](const json& point, double north, double east, double altitude) {
    const auto [n, w, d] = ned_between(reference, place_of(point));
    EXPECT_NEAR(n, north * kMile, Exported::kMeters);
    EXPECT_NEAR(w, east * kMile, Exported::kMeters);
    EXPECT_NEAR(point.at(2).get<double>(), altitude, Exported::kMeters);
    ++found;
  };
  for (const json& feature : e.geojson["features"]) {
    const json& about = feature["properties"];
    const json& coordinates = feature["geometry"]["coordinates"];
    if (about["kind"] == "home")
      expect(coordinates, 0, about["flight"] == "eagle" ? -130 : 110, 0);
    if (about["kind"] != "route" || about["flight"] != "eagle")
      continue;
    ASSERT_EQ(coordinates.size(), 1u);
    ASSERT_EQ(coordinates[0].size(), 5u);
    expect(coordinates[0][0], 5, -50, 7620);
    expect(coordinates[0][1], 0, -10, 8534.4);
    expect(coordinates[0][4], -10, -60, 8534.4);
  }
  EXPECT_EQ(found, 5u);
}

TEST(Places, AreOnTheGlobeOnBothSidesOfThe180thMeridian) {
  const TempFolder folder;
  const std::string file = folder.write("over.yaml", R"(eyrie: 1
name: over
reference: {latitude: -60 deg, longitude: 179.9 deg}
until: 4 min
trees: {ahead: navigate}
blue:
  flights:
    eagle:
      aircraft: laero_fighter
      tree: ahead
      players: [eagle1]
      start: {north: 0 nmi, east: -2 nmi, altitude: 25000 ft, heading: 90 deg, speed: 400 kt}
      route: [{north: 0 nmi, east: 60 nmi, altitude: 25000 ft, speed: 400 kt}]
)");
  Exported e(scenario::load({file}, scenario::Source::disk(".")), 240);
  for (const json& feature : e.geojson["features"]) {
    if (feature["properties"]["kind"] != "aircraft")
      continue;
    const json& lines = feature["geometry"]["coordinates"];
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_GT(lines[0].back()[0], 179);
    EXPECT_LT(lines[1].front()[0], -179);
    std::size_t i = 0;
    for (const json& line : lines)
      for (const json& point : line) {
        EXPECT_LE(std::fabs(point[0].get<double>()), 180);
        e.expect_at(1, feature["properties"]["times_s"].at(i++), place_of(point));
      }
  }
  EXPECT_GT(e.compared, 200u);
}

}  // namespace
}  // namespace eyrie::test
