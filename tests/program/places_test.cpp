// SPDX-License-Identifier: MIT
/// \file  The places in GeoJSON and CZML, read by the textbook, against the truth and the scenario.
#include <gtest/gtest.h>

#include <map>
#include <set>

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

/// Of a run that begins at 2026-01-01T12:00:00Z and is over before midnight.
double seconds_of(const std::string& date) {
  EXPECT_EQ(date.size(), std::string("2026-01-01T12:00:00.00Z").size()) << date;
  EXPECT_TRUE(date.starts_with("2026-01-01T") && date.ends_with("Z")) << date;
  return std::stod(date.substr(11, 2)) * 3600 - 12 * 3600 + std::stod(date.substr(14, 2)) * 60 +
         std::stod(date.substr(17, 5));
}

void expect_true(Exported& e) {
  std::map<std::string, std::uint32_t> ids;
  for (const auto& [id, path] : e.paths.all())
    EXPECT_TRUE(ids.emplace(path.name, id).second) << "two of one name: " << path.name;
  std::map<std::string, std::string> last;
  for (const json& feature : e.geojson["features"]) {
    const json& about = feature["properties"];
    const bool stands = feature["geometry"]["type"] == "Point";
    if (!about.contains("begin") || about["kind"] == "loss")
      continue;
    const std::string name = about["name"];
    ASSERT_LT(about["begin"], about["end"]);
    const bool player = e.paths.all().at(ids.at(name)).kind != "missile";
    if (player && last.contains(name)) {
      ASSERT_EQ(about["begin"], last[name]) << "a gap in the path of " << name;
    }
    last[name] = about["end"];
    const json& places = feature["geometry"]["coordinates"];
    if (player) {
      e.expect_at(ids[name], seconds_of(about["begin"]),
                  place_of(stands ? places : places.front().front()));
      e.expect_at(ids[name], seconds_of(about["end"]),
                  place_of(stands ? places : places.back().back()));
    }
  }
  EXPECT_GT(e.compared, 500u);
  e.compared = 0;
  for (const json& packet : e.czml) {
    if (!packet["id"].get<std::string>().starts_with("player-"))
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

/// A line is there while its end is attacked, and both ends are where the packets say.
TEST(Places, OfCesiumHaveLabelsAndTheLinesOfLocksAndLaunches) {
  const Exported e(load_scenario("sweep"), 14 * 60);
  std::set<std::string> ids;
  std::size_t missiles = 0, locks = 0, shots = 0;
  for (const json& packet : e.czml)
    ids.insert(packet["id"]);
  for (const json& packet : e.czml) {
    const std::string id = packet["id"];
    if (id.starts_with("player-")) {
      ASSERT_TRUE(packet.contains("label")) << id;
      missiles += packet["label"]["text"] == packet["name"];
    }
    if (!id.starts_with("line-"))
      continue;
    const json& ends = packet["polyline"]["positions"]["references"];
    ASSERT_EQ(ends.size(), 2u);
    for (const json& end : ends) {
      const std::string name = end;
      EXPECT_TRUE(name.ends_with("#position"));
      EXPECT_TRUE(ids.contains(name.substr(0, name.find('#')))) << name;
    }
    (packet["name"].get<std::string>().find(" of ") == std::string::npos ? locks : shots) += 1;
    ASSERT_FALSE(packet["availability"].empty());
    for (const std::string when : packet["availability"]) {
      const std::size_t bar = when.find('/');
      EXPECT_LT(seconds_of(when.substr(0, bar)), seconds_of(when.substr(bar + 1)));
    }
  }
  EXPECT_GT(missiles, 2u);
  EXPECT_EQ(shots, missiles);
  EXPECT_GT(locks, 2u);
}

/// scenarios/sweep.yaml gives places north and east of 33 N 68 W.
TEST(Places, OfAPlanAreThoseOfTheScenario) {
  const Exported e(load_scenario("sweep"), 2);
  const Place reference{-68, 33, 0};
  constexpr double kMile = 1852;
  std::size_t found = 0;
  const auto expect = [&](const json& point, double north, double east, double altitude,
                          double meters = Exported::kMeters) {
    const auto [n, w, d] = ned_between(reference, place_of(point));
    EXPECT_NEAR(n, north * kMile, meters);
    EXPECT_NEAR(w, east * kMile, meters);
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
    // 40.3 nmi in fifteen pieces, none of them longer than 5 km, then three more legs
    ASSERT_GT(coordinates[0].size(), 40u);
    expect(coordinates[0][0], 5, -50, 7620);
    expect(coordinates[0][5], 5 - 5 / 3., -50 + 40 / 3., 7620 + 914.4 / 3, 2);
    expect(coordinates[0][15], 0, -10, 8534.4);
    expect(coordinates[0].back(), -10, -60, 8534.4);
  }
  EXPECT_EQ(found, 6u);
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
  std::size_t cut = 0;
  for (const json& feature : e.geojson["features"]) {
    if (feature["properties"]["kind"] != "aircraft")
      continue;
    const json& lines = feature["geometry"]["coordinates"];
    for (const json& line : lines)
      for (const json& point : line)
        EXPECT_LE(std::fabs(point[0].get<double>()), 180);
    e.expect_at(1, seconds_of(feature["properties"]["begin"]), place_of(lines.front().front()));
    e.expect_at(1, seconds_of(feature["properties"]["end"]), place_of(lines.back().back()));
    if (lines.size() == 1) {
      EXPECT_LT(std::fabs(lines[0][0][0].get<double>() - lines[0][1][0].get<double>()), 1);
      continue;
    }
    ++cut;
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].back()[0], 180);
    EXPECT_EQ(lines[1].front()[0], -180);
    EXPECT_EQ(lines[0].back()[1], lines[1].front()[1]);
  }
  EXPECT_EQ(cut, 1u);
  EXPECT_GT(e.compared, 200u);
}

}  // namespace
}  // namespace eyrie::test
