// SPDX-License-Identifier: MIT
#include "record/geojson.hpp"

#include <cmath>

#include "core/angle.hpp"
#include "record/json_text.hpp"

namespace eyrie::record {
namespace {

using nlohmann::ordered_json;

ordered_json coordinates(const Geodetic& place) {
  const auto rounded = [](double value, double scale) { return std::round(value * scale) / scale; };
  return {rounded(degrees(wrap_pi(place.longitude)), 1e7), rounded(degrees(place.latitude), 1e7),
          rounded(place.altitude, 10)};
}

ordered_json feature(ordered_json geometry, ordered_json properties) {
  return {{"type", "Feature"},
          {"geometry", std::move(geometry)},
          {"properties", std::move(properties)}};
}

/// Lines, cut where they cross the 180th meridian: at the last point before and the first behind.
ordered_json lines(const std::vector<Path::Point>& points) {
  ordered_json all = ordered_json::array();
  ordered_json line = ordered_json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool crosses = i > 0 && std::fabs(wrap_pi(points[i].place.longitude) -
                                            wrap_pi(points[i - 1].place.longitude)) > kPi;
    if (crosses && line.size() > 1)
      all.push_back(line);
    if (crosses)
      line = ordered_json::array();
    line.push_back(coordinates(points[i].place));
  }
  if (line.size() > 1)
    all.push_back(std::move(line));
  return all;
}

ordered_json path_feature(const Path& path) {
  ordered_json times = ordered_json::array(), led = ordered_json::array();
  for (const Path::Point& p : path.points)
    times.push_back(std::round(p.time * 100) / 100);
  for (const Path::Led& l : path.led)
    led.push_back({{"from_s", l.time}, {"behavior", l.behavior}, {"vote", l.vote}});
  ordered_json properties{{"name", path.name},
                          {"kind", path.kind},
                          {"type", path.type},
                          {"side", scenario::side_name(path.side)}};
  if (!path.target.empty())
    properties["target"] = path.target;
  if (!path.end.empty())
    properties["end"] = path.end;
  properties["times_s"] = std::move(times);
  if (!led.empty())
    properties["led_by"] = std::move(led);
  return feature({{"type", "MultiLineString"}, {"coordinates", lines(path.points)}},
                 std::move(properties));
}

/// The route of a flight with its home.
void add_plan(const model::Library& library, const model::Flight& flight, ordered_json& features) {
  const ordered_json about{{"flight", flight.name}, {"side", scenario::side_name(flight.side)}};
  if (!flight.routes.empty() && flight.routes[0].waypoints.size() > 1) {
    std::vector<Path::Point> points;
    for (const model::Waypoint& waypoint : flight.routes[0].waypoints) {
      Geodetic place = library.reference.to_geodetic(waypoint.position);
      place.altitude = waypoint.altitude;
      points.push_back({0, place});
    }
    ordered_json properties = about;
    properties["kind"] = "route";
    features.push_back(feature({{"type", "MultiLineString"}, {"coordinates", lines(points)}},
                               std::move(properties)));
  }
  if (flight.home) {
    ordered_json properties = about;
    properties["kind"] = "home";
    features.push_back(
        feature({{"type", "Point"},
                 {"coordinates", coordinates(library.reference.to_geodetic(*flight.home))}},
                std::move(properties)));
  }
}

}  // namespace

std::string geojson(const Paths& paths) {
  ordered_json features = ordered_json::array();
  for (const model::Flight& flight : paths.scenario().library->flights)
    add_plan(*paths.scenario().library, flight, features);
  for (const auto& [id, path] : paths.all()) {
    if (path.points.size() < 2)
      continue;
    features.push_back(path_feature(path));
    if (path.end == "lost")
      features.push_back(
          feature({{"type", "Point"}, {"coordinates", coordinates(path.points.back().place)}},
                  {{"name", path.name}, {"kind", "loss"}, {"time_s", path.points.back().time}}));
  }
  return json_text(ordered_json{{"type", "FeatureCollection"}, {"features", std::move(features)}}) +
         "\n";
}

}  // namespace eyrie::record
