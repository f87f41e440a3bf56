// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "core/bind.hpp"
#include "model/events.hpp"
#include "model/flight/fly.hpp"
#include "pilot/catalog.hpp"
#include "pilot/pilot_system.hpp"
#include "scenario/assemble.hpp"
#include "scenario/data.hpp"
#include "scenario/document.hpp"
#include "scenario/place.hpp"
#include "scenario/plan.hpp"
#include "scenario/scenario.hpp"
#include "sim/rate.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array<std::string_view, 7> kByHand{"include", "environment", "trees", "data",
                                                  "routes",  "blue",        "red"};

class Loader {
 public:
  Loader(const LoadRequest& request, Source& source) : source_(source) {
    out_->file = request.file;
    out_->sets = request.sets;
    library_ = std::make_shared<model::Library>();
  }

  std::shared_ptr<const Scenario> load() {
    document_ = load_document(out_->file, source_, diagnostics_);
    stop_if_wrong();
    apply_overrides(document_, out_->sets, diagnostics_);
    stop_if_wrong();
    bind(out_->spec, document_, diagnostics_, kByHand);
    if (const Value* v = document_.find("environment"))
      environment(*v);
    library_->reference =
        Reference({out_->spec.reference.latitude, out_->spec.reference.longitude, 0.0});
    plans_ = read_plans(document_, diagnostics_);
    trees();
    models();
    flights();
    orders();
    stop_if_wrong();
    finish();
    return std::move(out_);
  }

 private:
  void stop_if_wrong() const {
    if (!diagnostics_.ok())
      throw ConfigError(diagnostics_);
  }
  void error(const Location& where, std::string message) {
    diagnostics_.error(where, std::move(message));
  }
  Location place(const Value& map, std::string_view key) const {
    const Value* v = map.find(key);
    return v ? v->where : map.where;
  }

  void environment(const Value& v) {
    model::EnvironmentSpec spec;
    bind(spec, v, diagnostics_);
    if (const auto problem = model::Wind::problem(spec.wind))
      error(place(v, "wind"), *problem);
    else
      library_->environment = model::Environment(spec);
  }

  void trees() {
    const Value* map = document_.find("trees");
    auto trees = std::make_shared<pilot::Trees>();
    out_->trees = trees;
    if (!map || map->is_null())
      return;
    if (!map->is_map())
      return error(map->where, "trees: expected a map of trees, got " + map->shown());
    std::vector<ubf::NamedSpec> named;
    for (const Value::Entry& e : map->entries) {
      const auto same = std::find_if(named.begin(), named.end(),
                                     [&](const ubf::NamedSpec& n) { return n.name == e.key; });
      if (same != named.end())
        error(e.where, fmt::format("tree '{}' is defined twice (also at {})", e.key,
                                   same->value->where.text()));
      else
        named.push_back({e.key, &e.value});
    }
    const auto registry = pilot::make_registry();
    for (const ubf::NamedSpec& n : named)
      if (ubf::needs_arguments(*n.value))
        templates_.push_back(n.name);
      else if (auto tree = registry.build_tree(n.name, *n.value, diagnostics_, named))
        trees->add(std::move(*tree));
      else
        broken_.push_back(n.name);
  }

  void models() {
    DataLoader data(*library_, document_.find("data"), source_, diagnostics_);
    for (FlightPlan& flight : plans_)
      for (PlayerPlan& player : flight.players) {
        if (player.spec.aircraft.empty()) {
          error(player.where,
                fmt::format("{}: which aircraft? Neither it nor its flight says", player.name));
          continue;
        }
        data.aircraft(player.spec.aircraft, player.place("aircraft"));
        if (!player.spec.loadout)
          continue;
        const auto& stores = *player.spec.loadout;
        const Value* said = player.said("loadout");
        for (std::size_t i = 0; i < stores.size(); ++i)
          if (stores[i] != "none")
            data.missile(stores[i], said && i < said->items.size() ? said->items[i].where
                                                                   : player.place("loadout"));
      }
  }

  void flights() {
    for (const FlightPlan& plan : plans_) {
      model::Flight flight{.name = plan.name, .side = plan.side};
      Roster::Flight names{plan.name, plan.side, {}};
      for (const PlayerPlan& player : plan.players) {
        const PlayerId id{static_cast<std::uint32_t>(out_->roster.players.size() + 1)};
        flight.members.push_back(id);
        names.members.push_back(id);
        out_->roster.players.push_back({player.name, player.spec.aircraft, plan.side,
                                        static_cast<std::uint16_t>(library_->flights.size()),
                                        player.rank});
      }
      route(plan, flight);
      const FormationSpec& wall = plan.spec.formation;
      out_->plans.push_back({{wall.abreast, wall.behind, wall.below}});
      if (plan.home && plan.sound)
        flight.home = resolve(*plan.home, 0, library_->reference, plan.home_where, diagnostics_);
      for (const PlayerPlan& player : plan.players)
        start(plan, player);
      library_->flights.push_back(std::move(flight));
      out_->roster.flights.push_back(std::move(names));
    }
  }

  void route(const FlightPlan& plan, model::Flight& flight) {
    if (!plan.sound)
      return;
    model::Route route{.name = "mission", .waypoints = {}};
    double altitude = plan.spec.start.altitude.value_or(si(20000, "ft"));
    std::optional<double> speed = plan.spec.start.speed;
    for (const WaypointSpec& w : plan.spec.route) {
      altitude = w.altitude.value_or(altitude);
      if (w.speed)
        speed = w.speed;
      route.waypoints.push_back(
          {resolve(w, altitude, library_->reference, plan.route_where, diagnostics_), altitude,
           speed});
    }
    if (!route.waypoints.empty())
      flight.routes.push_back(std::move(route));
  }

  void place_at_start(const FlightPlan& plan, const PlayerPlan& player, Start& begin) {
    const StartSpec& s = player.spec.start;
    if (!s.altitude || !s.heading || !s.speed) {
      error(plan.start_where,
            fmt::format("{}: start needs altitude, heading and speed", player.name));
      return;
    }
    const Vec3 lead = resolve(s, *s.altitude, library_->reference, plan.start_where, diagnostics_);
    begin = {.position = lead, .heading = *s.heading, .speed = *s.speed};
    if (!player.own_place && player.rank > 1) {
      const Vec3 offset = pilot::formation_offset(out_->plans.back().formation, player.rank);
      begin.position = beside(library_->reference, lead, *s.heading, offset);
    }
  }

  void start(const FlightPlan& plan, const PlayerPlan& player) {
    Start begin;
    if (player.sound)
      place_at_start(plan, player, begin);
    begin.privileged = player.spec.privileged;
    begin.where = player.where;
    if (!player.spec.tree.empty()) {
      begin.tree = out_->trees->find(player.spec.tree);
      if (!begin.tree &&
          std::find(broken_.begin(), broken_.end(), player.spec.tree) == broken_.end())
        error(player.place("tree"), no_tree(player.spec.tree));
    }
    if (const auto type = library_->aircraft.find(player.spec.aircraft))
      equip(player, *type, begin);
    starts_.push_back(begin);
  }

  void equip(const PlayerPlan& player, std::uint16_t index, Start& begin) {
    const model::AircraftType& type = library_->aircraft[index];
    const double tanks = library_->airframes[type.index.airframe].internal_fuel;
    begin.type = index;
    begin.fuel = player.spec.fuel.value_or(tanks);
    if (begin.fuel > tanks)
      error(player.place("fuel"), fmt::format("fuel {:.0f} kg is more than a {} holds ({:.0f} kg)",
                                              begin.fuel, player.spec.aircraft, tanks));
    begin.bingo = player.spec.bingo.value_or(0.25 * tanks);
    begin.rounds = player.spec.rounds;
    std::size_t station = 0;
    const auto hang = [&](const std::string& store, std::uint8_t count) {
      if (station >= model::kMaxStations)
        return;
      if (const auto missile = library_->missiles.find(store))
        begin.stations[station] = {static_cast<std::uint8_t>(*missile + 1), count};
      ++station;
    };
    if (!player.spec.loadout) {
      for (const model::StationFit& fit : type.stations)
        hang(fit.store, fit.count);
      return;
    }
    const std::size_t stations = type.stations.empty() ? model::kMaxStations : type.stations.size();
    if (player.spec.loadout->size() > stations)
      error(player.place("loadout"),
            fmt::format("{} stores on a {} with {} stations", player.spec.loadout->size(),
                        player.spec.aircraft, stations));
    for (const std::string& store : *player.spec.loadout)
      hang(store, store == "none" ? 0 : 1);
  }

  std::string no_tree(const std::string& name) const {
    if (std::find(templates_.begin(), templates_.end(), name) != templates_.end())
      return fmt::format("tree {} needs arguments: fly a tree that refers to it with some",
                         quote(name));
    return fmt::format("there is no tree {}{}", quote(name), did_you_mean(name, tree_names()));
  }
  std::vector<std::string> tree_names() const {
    std::vector<std::string> names = broken_;
    for (const auto& tree : *out_->trees)
      names.emplace_back(tree.name());
    return names;
  }

  void orders() {
    std::vector<std::string> players;
    for (const auto& p : out_->roster.players)
      players.push_back(p.name);
    const Location where = place(document_, "orders");
    for (const OrderSpec& order : out_->spec.orders) {
      const auto who = out_->roster.find(order.player);
      const auto tree = out_->trees->find(order.swap_tree);
      if (!who)
        error(where, fmt::format("there is no player {}{}", quote(order.player),
                                 did_you_mean(order.player, players)));
      if (!tree)
        error(where, no_tree(order.swap_tree));
      if (who && tree)
        out_->orders.push_back(pilot::swap_tree_order(
            static_cast<std::uint64_t>(order.at * out_->spec.rates.kinematics + 0.5), *who, *tree));
    }
  }

  void finish() {
    out_->library = library_;
    const std::string problem = assemble(*out_, starts_);
    if (!problem.empty()) {
      error(place(document_, "rates"), problem);
      stop_if_wrong();
    }
    out_->files = source_.files();
  }

  Source& source_;
  Diagnostics diagnostics_;
  Value document_;
  std::vector<FlightPlan> plans_;
  std::shared_ptr<model::Library> library_;
  std::vector<Start> starts_;
  std::vector<std::string> broken_;     ///< trees with mistakes, said already
  std::vector<std::string> templates_;  ///< trees that need arguments
  std::shared_ptr<Scenario> out_ = std::make_shared<Scenario>();
};

}  // namespace

std::shared_ptr<const Scenario> load(const LoadRequest& request, Source source) {
  return Loader(request, source).load();
}

}  // namespace eyrie::scenario
