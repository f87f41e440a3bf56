// SPDX-License-Identifier: MIT
#include "record/czml.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.hpp"
#include "record/json_text.hpp"

namespace eyrie::record {
namespace {

using nlohmann::ordered_json;

/// ISO 8601; a run begins at noon.
std::string date(double seconds) {
  const auto hundredths = static_cast<long long>(std::floor(seconds * 100 + 0.5)) + 12LL * 360'000;
  const long long day = hundredths / 8'640'000, rest = hundredths % 8'640'000;
  return fmt::format("2026-01-{:02}T{:02}:{:02}:{:02}.{:02}Z", 1 + day, rest / 360'000,
                     rest / 6'000 % 60, rest / 100 % 60, rest % 100);
}
std::string interval(double from, double to) {
  return date(from) + "/" + date(to);
}

ordered_json color(model::Side side) {  // told apart by the colour-blind: Okabe and Ito, 2008
  return {{"rgba", side == model::Side::blue  ? ordered_json{86, 180, 233, 255}
                   : side == model::Side::red ? ordered_json{213, 94, 0, 255}
                                              : ordered_json{200, 200, 200, 255}}};
}

ordered_json position(const Path& path) {
  ordered_json samples = ordered_json::array();
  for (const Path::Point& p : path.points) {
    samples.push_back(std::round(p.time * 100) / 100);
    samples.push_back(std::round(degrees(p.place.longitude) * 1e7) / 1e7);  // 1 cm
    samples.push_back(std::round(degrees(p.place.latitude) * 1e7) / 1e7);
    samples.push_back(std::round(p.place.altitude * 10) / 10);
  }
  return {{"epoch", date(0)},
          {"interpolationAlgorithm", "LAGRANGE"},
          {"interpolationDegree", path.points.size() > 3 ? 3 : 1},
          {"cartographicDegrees", std::move(samples)}};
}

/// Name, who leads and its vote, over time.
ordered_json label(const Path& path, double end) {
  ordered_json texts = ordered_json::array();
  for (std::size_t i = 0; i < path.led.size(); ++i) {
    const double to = i + 1 < path.led.size() ? path.led[i + 1].time : end;
    if (to > path.led[i].time)
      texts.push_back({{"interval", interval(path.led[i].time, to)},
                       {"string", fmt::format("{}  {} {:g}", path.name, path.led[i].behavior,
                                              path.led[i].vote)}});
  }
  return {{"text", texts.empty() ? ordered_json(path.name) : texts},
          {"font", "12px sans-serif"},
          {"fillColor", color(path.side)},
          {"horizontalOrigin", "LEFT"},
          {"pixelOffset", {{"cartesian2", {10, 0}}}}};
}

ordered_json packet(std::uint32_t id, const Path& path) {
  const double from = path.points.front().time, to = path.points.back().time;
  const bool missile = path.kind == "missile";
  ordered_json j{{"id", fmt::format("player-{}", id)}, {"name", path.name}};
  j["availability"] = interval(from, to);
  j["description"] = fmt::format("{}, {}{}{}", path.type, scenario::side_name(path.side),
                                 path.target.empty() ? "" : ", at " + path.target,
                                 path.end.empty() ? "" : "; " + path.end);
  j["position"] = position(path);
  j["orientation"] = {{"velocityReference", "#position"}};
  j["point"] = {{"pixelSize", missile ? 4 : 9}, {"color", color(path.side)}};
  j["path"] = {{"width", missile ? 1 : 2},
               {"leadTime", 0},
               {"trailTime", missile ? 30 : 120},
               {"material", {{"solidColor", {{"color", color(path.side)}}}}}};
  if (!missile)
    j["label"] = label(path, to);
  return j;
}

}  // namespace

std::string czml(const Paths& paths) {
  const auto& spec = paths.scenario().spec;
  ordered_json all = ordered_json::array();
  all.push_back({{"id", "document"},
                 {"name", spec.name},
                 {"version", "1.0"},
                 {"clock",
                  {{"interval", interval(0, paths.end_time())},
                   {"currentTime", date(0)},
                   {"multiplier", 10},
                   {"range", "LOOP_STOP"}}}});
  for (const auto& [id, path] : paths.all())
    if (path.points.size() > 1)
      all.push_back(packet(id, path));
  return json_text(all) + "\n";
}

}  // namespace eyrie::record
