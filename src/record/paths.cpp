// SPDX-License-Identifier: MIT
#include "record/paths.hpp"

#include "core/angle.hpp"
#include "record/json_text.hpp"
#include "record/names.hpp"

namespace eyrie::record {

using model::EventKind;

void Paths::keep(std::uint32_t id) {
  Last& last = last_[id];
  Path& path = all_[id];
  if (last.kept >= last.seen && !path.points.empty())
    return;
  last.kept = last.seen;
  if (path.points.size() >= most_)
    halve(path, last);
  path.points.push_back({last.seen, scenario_.library->reference.to_geodetic(last.position)});
}

void Paths::halve(Path& path, Last& last) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < path.points.size(); i += 2)
    path.points[kept++] = path.points[i];
  path.points.resize(kept);
  const std::uint64_t every = path.kind == "missile" ? missiles_every_ : players_every_;
  last.pause = 2 * std::max(last.pause, static_cast<double>(every) * dt_);
  widest_pause_ = std::max(widest_pause_, last.pause);
}

void Paths::see(PlayerId id, const Vec3& position, bool keep_it) {
  Last& last = last_[id.value];
  last.position = position;
  last.seen = time_;
  const bool due = keep_it && time_ - last.kept > last.pause - 1e-6;
  if (due || all_[id.value].points.empty())
    keep(id.value);
}

void Paths::look(const sim::World& world, bool players, bool missiles) {
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    see(id, fleet.motion(world, row).position, players);
    const PlayerId locked = fleet.gauges(world, row).locked;
    auto& locks = all_[id.value].locks;
    if (locks.empty() ? bool(locked) : locks.back().target != locked)
      locks.push_back({time_, locked});
    const team::LastDecision last = fleet.agents->last_decision(world, row);
    if (!last.ticks)
      return;
    const std::string behavior = fleet.leader(world, row);
    auto& led = all_[id.value].led;
    if (led.empty() || led.back().behavior != behavior || led.back().vote != last.vote)
      led.push_back({time_, behavior, last.vote});
  });
  for (std::size_t i = 0; i < world.rows(scenario_.missiles.table); ++i)
    see(world.ids(scenario_.missiles.table)[i],
        world.rows(scenario_.missiles.kinematics)[i].position, missiles);
}

void Paths::begin(const sim::World& world, double dt) {
  players_every_ = steps_in(1, dt);
  missiles_every_ = steps_in(0.2, dt);
  time_ = static_cast<double>(world.step()) * dt;
  dt_ = dt;
  for (std::size_t i = 0; i < scenario_.roster.players.size(); ++i) {
    const auto& player = scenario_.roster.players[i];
    Path& path = all_[static_cast<std::uint32_t>(i + 1)];
    path.name = player.name;
    path.type = player.label;
    path.side = player.side;
    path.kind = scenario_.fleets[player.fleet]->words.name;
  }
  look(world, true, true);
}

void Paths::happened(const sim::Event& e) {
  if (kind_of(e) == EventKind::launch) {
    const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
    Path& path = all_[e.who.value];
    path.kind = "missile";
    path.type = store_label(scenario_, e.values[1]);
    Missiles missiles(scenario_);
    missiles.note(e);
    path.name = missiles.name(e.who);
    path.side = shooter ? shooter->side : model::Side::none;
    path.target = scenario_.roster.name(e.whom);
    path.locks = {{time_, e.whom}};
  }
  const auto fate = fate_of(e);
  const auto at = fate ? all_.find(fate->who.value) : all_.end();
  if (at == all_.end() || !at->second.end.empty())
    return;
  at->second.end = fate->end;
  if (norm(e.place) > 0) {  // else he was last seen a step ago
    last_[fate->who.value].position = e.place;
    last_[fate->who.value].seen = time_;
  }
  keep(fate->who.value);
}

void Paths::observe(const sim::World& world, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  time_ = info.time_after();
  for (const sim::Event& e : events)
    happened(e);
  look(world, world.step() % players_every_ == 0, world.step() % missiles_every_ == 0);
}

void Paths::finish(const sim::World& world) {
  for (auto& [id, last] : last_)
    last.pause = 0;  // the end is kept
  look(world, true, true);
}

namespace {

using nlohmann::ordered_json;

double to_milliseconds(double seconds) {
  return std::round(seconds * 1000) / 1000;
}
/// ISO 8601; a run begins at noon.
std::string date(double seconds) {
  constexpr long long kMinute = 60'000, kHour = 60 * kMinute, kDay = 24 * kHour;
  const auto ms = static_cast<long long>(std::floor(seconds * 1000 + 0.5)) + kDay / 2;
  return fmt::format("2026-01-{:02}T{:02}:{:02}:{}Z", 1 + ms / kDay, ms % kDay / kHour,
                     ms % kHour / kMinute,
                     seconds_text(static_cast<double>(ms % kMinute) / 1000, 6));
}
std::string interval(double from, double to) {
  return date(from) + "/" + date(to);
}

ordered_json color(model::Side side) {  // told apart by the colour-blind: Okabe and Ito, 2008
  return {{"rgba", side == model::Side::blue  ? ordered_json{86, 180, 233, 255}
                   : side == model::Side::red ? ordered_json{213, 94, 0, 255}
                                              : ordered_json{200, 200, 200, 255}}};
}

/// Degrees to 1 cm, and m.
ordered_json coordinates(const Geodetic& place, double longitude) {
  const auto rounded = [](double value, double scale) {
    return std::round(value * scale) / scale + 0.0;  // never -0
  };
  return {rounded(degrees(longitude), 1e7), rounded(degrees(place.latitude), 1e7),
          rounded(place.altitude, 10)};
}

ordered_json position(const Path& path) {
  ordered_json samples = ordered_json::array();
  for (const Path::Point& p : path.points) {
    samples.push_back(to_milliseconds(p.time));
    for (const auto& number : coordinates(p.place, p.place.longitude))
      samples.push_back(number);
  }
  return {{"epoch", date(0)},
          {"interpolationAlgorithm", "LAGRANGE"},
          {"interpolationDegree", path.points.size() > 3 ? 3 : 1},
          {"cartographicDegrees", std::move(samples)}};
}

/// Name, of a player who leads and its vote, over time.
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
  j["label"] = label(path, to);
  return j;
}

/// The lines from who attacks to whom, one packet per pair.
void add_lines(const Paths& paths, std::uint32_t id, const Path& path, ordered_json& all) {
  std::map<std::uint32_t, ordered_json> when;  // by target
  for (std::size_t i = 0; i < path.locks.size(); ++i) {
    const auto [from, target] = path.locks[i];
    const auto other = paths.all().find(target.value);
    if (other == paths.all().end() || other->second.points.size() < 2)
      continue;
    double to = std::min(path.points.back().time, other->second.points.back().time);
    if (i + 1 < path.locks.size())
      to = std::min(to, path.locks[i + 1].time);
    if (to > from)
      when[target.value].push_back(interval(from, to));
  }
  for (auto& [target, intervals] : when) {
    ordered_json stroke = color(path.side);
    stroke["rgba"][3] = 120;
    all.push_back(
        {{"id", fmt::format("line-{}-{}", id, target)},
         {"name", fmt::format("{} at {}", path.name, paths.all().at(target).name)},
         {"availability", std::move(intervals)},
         {"polyline",
          {{"positions",
            {{"references",
              {fmt::format("player-{}#position", id), fmt::format("player-{}#position", target)}}}},
           {"arcType", "NONE"},
           {"width", 1},
           {"material", {{"solidColor", {{"color", std::move(stroke)}}}}}}}});
  }
}

using nlohmann::ordered_json;

ordered_json coordinates(const Geodetic& place) {
  return coordinates(place, wrap_pi(place.longitude));
}
ordered_json feature(ordered_json geometry, ordered_json properties) {
  return {{"type", "Feature"},
          {"geometry", std::move(geometry)},
          {"properties", std::move(properties)}};
}

/// Lines along the points, cut where they cross the 180th meridian. A point on it belongs to the
/// side from which the line comes to it.
ordered_json way(std::span<const Path::Point> points) {
  ordered_json all = ordered_json::array();
  double at = wrap_pi(points.front().place.longitude);
  ordered_json line = ordered_json::array({coordinates(points.front().place, at)});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Geodetic &a = points[i - 1].place, &b = points[i].place;
    constexpr double kNear = 1e-12;
    const double step = wrap_pi(b.longitude - a.longitude);
    if (std::fabs(at + step) > kPi + kNear) {
      const double edge = step > 0 ? kPi : -kPi, part = (edge - at) / step;
      const Geodetic cut{a.latitude + part * (b.latitude - a.latitude), edge,
                         a.altitude + part * (b.altitude - a.altitude)};
      if (part * std::fabs(step) > kNear)
        line.push_back(coordinates(cut, edge));
      if (line.size() > 1)
        all.push_back(std::move(line));
      line = ordered_json::array({coordinates(cut, -edge)});
      at -= 2 * edge;
    }
    at += step;
    line.push_back(coordinates(b, at));
  }
  all.push_back(std::move(line));
  return {{"type", "MultiLineString"}, {"coordinates", std::move(all)}};
}

/// A feature for each way between two fixes; a point for who stands, or has but one.
void add_path(const scenario::Roster& roster, const Path& path, ordered_json& features) {
  std::size_t led = 0, locks = 0;
  const std::size_t ways = std::max<std::size_t>(path.points.size(), 2) - 1;
  for (std::size_t i = 0; i < ways && !path.points.empty(); ++i) {
    const Path::Point &from = path.points[i],
                      &to = path.points[std::min(i + 1, path.points.size() - 1)];
    ordered_json properties{{"name", path.name},
                            {"kind", path.kind},
                            {"type", path.type},
                            {"side", scenario::side_name(path.side)},
                            {"begin", date(from.time)},
                            {"end", date(to.time)},
                            {"time_s", to_milliseconds(from.time)}};
    while (led + 1 < path.led.size() && path.led[led + 1].time <= from.time)
      ++led;
    if (led < path.led.size() && path.led[led].time <= from.time) {
      properties["behavior"] = path.led[led].behavior;
      properties["vote"] = path.led[led].vote;
    }
    while (locks + 1 < path.locks.size() && path.locks[locks + 1].time <= from.time)
      ++locks;
    if (locks < path.locks.size() && path.locks[locks].time <= from.time &&
        path.locks[locks].target)
      properties["target"] = roster.name(path.locks[locks].target);
    if (!path.end.empty())
      properties["fate"] = path.end;
    ordered_json geometry =
        coordinates(from.place) != coordinates(to.place)
            ? way(std::span(path.points).subspan(i, 2))
            : ordered_json{{"type", "Point"}, {"coordinates", coordinates(from.place)}};
    features.push_back(feature(std::move(geometry), std::move(properties)));
  }
}

/// The route of a flight with its home.
void add_plan(const model::Library& library, const model::Flight& flight, ordered_json& features) {
  const ordered_json about{{"flight", flight.name}, {"side", scenario::side_name(flight.side)}};
  if (!flight.routes.empty() && flight.routes[0].waypoints.size() > 1) {
    std::vector<Path::Point> points;
    const auto point = [&](const Vec3& position, double altitude) {
      Geodetic place = library.reference.to_geodetic(position);
      place.altitude = altitude;
      points.push_back({0, place});
    };
    // a leg is straight on the flat map of the scenario, not in longitude and latitude
    constexpr double kPiece = 5000;  // m
    const model::Waypoint* before = nullptr;
    for (const model::Waypoint& waypoint : flight.routes[0].waypoints) {
      const Vec3 leg = before ? waypoint.position - before->position : Vec3{};
      const double pieces = std::ceil(norm(leg) / kPiece);
      for (double i = 1; i < pieces; ++i)
        point(before->position + i / pieces * leg,
              before->altitude + i / pieces * (waypoint.altitude - before->altitude));
      point(waypoint.position, waypoint.altitude);
      before = &waypoint;
    }
    ordered_json properties = about;
    properties["kind"] = "route";
    features.push_back(feature(way(points), std::move(properties)));
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
    if (!path.points.empty())
      all.push_back(packet(id, path));
  for (const auto& [id, path] : paths.all())
    if (!path.points.empty())
      add_lines(paths, id, path, all);
  return json_text(all) + "\n";
}

std::string geojson(const Paths& paths) {
  ordered_json features = ordered_json::array();
  for (const model::Flight& flight : paths.scenario().library->flights)
    add_plan(*paths.scenario().library, flight, features);
  for (const auto& [id, path] : paths.all()) {
    add_path(paths.scenario().roster, path, features);
    if (path.end == "lost")
      features.push_back(
          feature({{"type", "Point"}, {"coordinates", coordinates(path.points.back().place)}},
                  {{"name", path.name},
                   {"kind", "loss"},
                   {"side", scenario::side_name(path.side)},
                   {"begin", date(path.points.back().time)},
                   {"end", date(paths.end_time())},
                   {"time_s", to_milliseconds(path.points.back().time)}}));
  }
  return json_text(ordered_json{{"type", "FeatureCollection"}, {"features", std::move(features)}}) +
         "\n";
}

}  // namespace eyrie::record
