// SPDX-License-Identifier: MIT

#include <cstdio>

#include "core/bind.hpp"
#include "driver/driver_system.hpp"
#include "model/library.hpp"
#include "model/weapon/systems.hpp"
#include "pilot/pilot_system.hpp"
#include "scenario/assemble.hpp"
#include "scenario/data.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/mission.hpp"
#include "scenario/plan.hpp"
#include "scenario/player_kind.hpp"
#include "scenario/plugins.hpp"
#include "scenario/roster.hpp"
#include "scenario/scenario.hpp"
#include "scenario/source.hpp"
#include "scenario/trees.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array<std::string_view, 11> kByHand{"extends", "insert",  "replace",     "remove",
                                                   "include", "plugins", "environment", "trees",
                                                   "data",    "blue",    "red"};

class Loader {
 public:
  Loader(const LoadRequest& request, Source& source) : source_(source), request_(request) {
    load_plugins(request, plugins_, source_, diagnostics_);
    out_->file = request.file;
    out_->sets = request.sets;
    library_ = std::make_shared<model::Library>();
  }

  std::shared_ptr<const Scenario> load() {
    stop_if_wrong();
    document_ = load_document(out_->file, source_, diagnostics_, &removed_);
    stop_if_wrong();
    if (const std::string other = what_else(document_, out_->file); !other.empty())
      diagnostics_.error({out_->file, 1, 1}, other);
    stop_if_wrong();
    apply_overrides(document_, out_->sets, diagnostics_);
    if (const Value* v = document_.find("plugins"))
      load_plugins(*v, request_.may_open, plugins_, source_, diagnostics_);
    stop_if_wrong();
    std::optional<EndGuard> guard;  // their nodes are made now
    if (!plugins_.files().empty())
      guard.emplace(2, [&](const std::string& done) {
        fmt::print(stderr, "{}: {} while the scenario was being loaded\n", shell_word(out_->file),
                   done);
      });
    bind(out_->spec, document_, diagnostics_, kByHand);
    if (const Value* v = document_.find("environment"))
      environment(*v);
    library_->reference =
        Reference({out_->spec.reference.latitude, out_->spec.reference.longitude, 0.0});
    std::vector<std::string_view> keys;
    for (const MakeKind& make : plugins_.registries().kinds)
      keys.push_back(kinds_.emplace_back(make())->key());
    plans_ = read_plans(document_, diagnostics_, keys);
    for (const OtherPlan& plan : plans_.others)
      kinds_[plan.kind]->read(*plan.group, plan.side, diagnostics_);
    trees_ = TreeBook::read(document_, plans_, out_->spec.orders, plugins_.registries(),
                            request_.changes, diagnostics_, &source_, kinds_);
    out_->trees = trees_.pilots();
    out_->driver_trees = trees_.drivers();
    models();
    for (const FlightPlan& plan : plans_.flights)
      flight(plan);
    for (const ConvoyPlan& plan : plans_.convoys)
      convoy(plan);
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind)
      kinds_[kind]->enter(*out_, *library_, static_cast<std::uint8_t>(kind + 2), diagnostics_);
    out_->formations.resize(library_->flights.size());
    out_->convoys.resize(library_->flights.size());
    if (const auto problem = until_problem(out_->spec, out_->spec.until))
      diagnostics_.error(document_.where_of("until"), "until: " + *problem);
    if (const Value* v = document_.find("ours"))
      share_out(out_->spec.ours, *v, out_->roster, diagnostics_);
    orders();
    stop_if_wrong();
    finish();
    return std::move(out_);
  }

 private:
  void stop_if_wrong() const {
    if (!diagnostics_.ok())
      throw ConfigError(removed_.empty() ? diagnostics_ : blame_removals(diagnostics_, removed_));
  }
  void environment(const Value& v) {
    model::EnvironmentSpec spec;
    bind(spec, v, diagnostics_);
    if (const auto problem = model::Wind::problem(spec.wind))
      diagnostics_.error(v.where_of("wind"), *problem);
    else
      library_->environment = model::Environment(spec);
  }

  void models() {
    if (!plugins_.files().empty())
      DataLoader::check_plugins(source_, diagnostics_);
    DataLoader data(*library_, document_.find("data"), source_, diagnostics_);
    for (const ConvoyPlan& convoy : plans_.convoys)
      for (const VehiclePlan& player : convoy.players) {
        if (player.leaves_open("vehicle"))
          diagnostics_.error(player.where, "{}: which vehicle? Neither it nor its convoy says",
                             player.name);
        else if (!player.spec.vehicle.empty())
          data.load<model::VehicleType>(player.spec.vehicle, player.place("vehicle"));
      }
    for (const FlightPlan& flight : plans_.flights)
      for (const PlayerPlan& player : flight.players) {
        if (player.leaves_open("aircraft"))
          diagnostics_.error(player.where, "{}: which aircraft? Neither it nor its flight says",
                             player.name);
        if (player.spec.aircraft.empty())
          continue;
        data.load<model::AircraftType>(player.spec.aircraft, player.place("aircraft"));
        const Value* said = player.said("loadout");
        for (std::size_t i = 0; player.spec.loadout && i < player.spec.loadout->size(); ++i)
          if (const std::string& store = (*player.spec.loadout)[i]; store != "none")
            data.load<model::MissileType>(store, said && i < said->items.size()
                                                     ? said->items[i].where
                                                     : player.place("loadout"));
      }
  }

  /// Enters a flight or convoy with its members.
  template <class Plan, class Type, class Spec>
  model::Flight& enter(const Plan& plan, std::uint8_t fleet, const model::Shelf<Type>& shelf,
                       std::string Spec::*type) {
    std::vector<Roster::Player> members;
    for (const auto& player : plan.players) {
      const std::string& name = player.spec.*type;
      Roster::Player& member = members.emplace_back();
      member = {.name = player.name, .type = name, .label = name, .rank = player.rank};
      if (const auto index = shelf.find(name)) {
        member.label = shelf[*index].label;
        member.entity_type = shelf[*index].entity_type;
      }
    }
    return scenario::enter(*out_, *library_, fleet, {.name = plan.name, .side = plan.side},
                           members);
  }

  void flight(const FlightPlan& plan) {
    model::Flight& flight = enter(plan, 0, library_->aircraft, &PlayerSpec::aircraft);
    route(plan, flight);
    out_->formations.push_back(plan.spec.formation);
    out_->convoys.emplace_back();
    if (plan.home && plan.sound)
      flight.home = resolve(*plan.home, 0, library_->reference, plan.home_where, diagnostics_);
    for (const PlayerPlan& player : plan.players)
      start(plan, player);
  }

  void convoy(const ConvoyPlan& plan) {
    model::Flight& convoy = enter(plan, 1, library_->vehicles, &VehicleSpec::vehicle);
    out_->formations.emplace_back();
    out_->convoys.push_back({.gap = plan.spec.gap});
    if (plan.sound && !plan.spec.route.empty()) {
      model::Route route{.name = "mission", .waypoints = {}, .end = model::RouteEnd::stop};
      for (const RoadPointSpec& point : plan.spec.route)
        route.waypoints.push_back(
            {resolve(point, 0, library_->reference, plan.route_where, diagnostics_), 0,
             point.speed});
      convoy.routes.push_back(std::move(route));
    }
    for (const VehiclePlan& player : plan.players)
      vehicle_starts_.push_back(start(plan, player));
  }

  /// Behind the lead if it has no place of its own.
  VehicleStart start(const ConvoyPlan& plan, const VehiclePlan& player) {
    VehicleStart begin;
    if (!player.spec.tree.empty())
      begin.tree =
          trees_.find(*out_->driver_trees, player.spec.tree, player.place("tree"), diagnostics_);
    const auto type = library_->vehicles.find(player.spec.vehicle);
    if (!player.sound || !type)
      return begin;
    begin.type = *type;
    const VehicleStartSpec& s = player.spec.start;
    if (!s.heading && (player.own_place || player.rank == 1))  // the others have what the lead has
      diagnostics_.error(plan.start_where, "{}: start needs a heading", player.name);
    if (!s.heading)
      return begin;
    begin.heading = *s.heading;
    begin.speed = s.speed.value_or(0);
    if (const double top = library_->vehicles[*type].top_speed; begin.speed > top)
      diagnostics_.error(player.place("start"), "{}: a {} drives no faster than {}", player.name,
                         player.spec.vehicle, exact_quantity(top, Dimension::speed));
    begin.position = resolve(s, 0, library_->reference, plan.start_where, diagnostics_);
    if (!player.own_place)
      begin.position = beside(library_->reference, begin.position, plan.lead_heading(*s.heading),
                              {-plan.spec.gap * (player.rank - 1), 0, 0});
    return begin;
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
      if (player.own_place || player.rank == 1)  // the others have what the lead has
        diagnostics_.error(plan.start_where,
                           player.name + ": start needs altitude, heading and speed");
      return;
    }
    const Vec3 lead = resolve(s, *s.altitude, library_->reference, plan.start_where, diagnostics_);
    begin = {.position = lead, .heading = *s.heading, .speed = *s.speed};
    Vec3 offset;
    if (!player.own_place && player.rank > 1) {
      offset = pilot::formation_offset(out_->formations.back(), player.rank);
      offset.z = player.own_altitude ? 0 : offset.z;
      begin.position = beside(library_->reference, lead, plan.lead_heading(*s.heading), offset);
    }
    begin.spread = spread_of(player,
                             {.player = PlayerId{static_cast<std::uint32_t>(starts_.size() + 1)},
                              .drawn_by = out_->roster.flights.back().members.front(),
                              .place = lead,
                              .offset = offset,
                              .lead_off = plan.lead_heading(*s.heading) - *s.heading},
                             library_->reference, diagnostics_);
  }

  void start(const FlightPlan& plan, const PlayerPlan& player) {
    Start begin;
    if (player.sound)
      place_at_start(plan, player, begin);
    begin.privileged = player.spec.privileged;
    if (!player.spec.tree.empty())
      begin.tree = trees_.find(*out_->trees, player.spec.tree, player.place("tree"), diagnostics_);
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
      diagnostics_.error(player.place("fuel"), "fuel {:.0f} kg is more than a {} holds ({:.0f} kg)",
                         begin.fuel, player.spec.aircraft, tanks);
    begin.bingo = player.spec.bingo.value_or(0.25 * tanks);
    if (player.spec.bingo && begin.bingo >= begin.fuel)
      diagnostics_.error(player.place("bingo"),
                         "bingo {:.0f} kg is not less than the fuel at the start ({:.0f} kg)",
                         begin.bingo, begin.fuel);
    const int drum =
        type.index.gun ? type.rounds.value_or(library_->guns[*type.index.gun].rounds) : 0;
    begin.rounds = player.spec.rounds ? player.spec.rounds : type.rounds;
    if (begin.rounds && *begin.rounds > drum)
      diagnostics_.error(
          player.place("rounds"),
          type.index.gun
              ? fmt::format("{} rounds are more than the gun of a {} holds ({})", *begin.rounds,
                            player.spec.aircraft, drum)
              : fmt::format("a {} has no gun for {} rounds", player.spec.aircraft, *begin.rounds));
    std::size_t station = 0;
    const auto hang = [&](const std::string& store, std::uint8_t count) {
      if (station >= model::kMaxStations)
        return;
      constexpr std::size_t kMostMissiles = 254;  // 0 is an empty station, 255 any missile
      const auto missile = library_->missiles.find(store);
      if (missile && *missile >= kMostMissiles)
        diagnostics_.error(player.place("loadout"), "there are more than {} kinds of missiles",
                           kMostMissiles);
      else if (missile)
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
      diagnostics_.error(player.place("loadout"), "{} stores on a {} with {} stations",
                         player.spec.loadout->size(), player.spec.aircraft, stations);
    for (const std::string& store : *player.spec.loadout)
      hang(store, store == "none" ? 0 : 1);
  }

  void orders() {
    const Value* list = document_.find("orders");
    const RatesSpec& rates = out_->spec.rates;
    for (const OrderSpec& order : out_->spec.orders) {
      const auto index = static_cast<std::size_t>(&order - out_->spec.orders.data());
      const Value& item = list->items[index];
      if (rates.step_at(order.at) >= rates.step_at(out_->spec.until))
        diagnostics_.error(item.where_of("at"),
                           "an order at {} is never given: the flight ends at {} (until)",
                           exact_quantity(order.at, Dimension::time),
                           exact_quantity(out_->spec.until, Dimension::time));
      const auto who = out_->roster.find(order.player);
      if (!who)
        diagnostics_.error(item.where_of("player"), out_->roster.unknown(order.player));
      const Location where = item.where_of("swap_tree");
      if (order.lose == order.swap_tree.has_value())
        diagnostics_.error(item.where, "what is ordered of {}? Either 'swap_tree' or 'lose: true'",
                           quote(order.player));
      else if (who)
        give(order, *who, where);
      else if (order.swap_tree && !out_->driver_trees->find(*order.swap_tree))
        static_cast<void>(trees_.find(*out_->trees, *order.swap_tree, where, diagnostics_));
    }
  }
  void give(const OrderSpec& order, PlayerId who, const Location& where) {
    if (out_->roster.find(who)->remote)
      return;  // by the program that flies it
    const std::uint64_t step = out_->spec.rates.step_at(order.at);
    if (order.lose)
      return out_->orders.push_back(model::weapon::lose_order(step, who));
    const auto& name = *order.swap_tree;
    const std::size_t fleet = out_->roster.find(who)->fleet;
    std::optional<sim::Order> given;
    if (fleet >= 2)
      given = kinds_[fleet - 2]->order_tree(step, who, name);
    else if (const auto tree = fleet ? out_->driver_trees->find(name) : out_->trees->find(name))
      given = fleet ? driver::DriverSystem::swap_tree_order(step, who, *tree)
                    : pilot::PilotSystem::swap_tree_order(step, who, *tree);
    if (given)
      out_->orders.push_back(*given);
    else
      trees_.missing(name, where, diagnostics_);
  }

  void finish() {
    out_->library = library_;
    for (const auto& [kind, model, parameter, problem] :
         model::problems_of(*library_, 1 / out_->spec.rates.kinematics))
      diagnostics_.error(place_in_data(document_, kind, model, parameter), "data.{}.{}.{}: {}",
                         kind, model, parameter, problem);
    stop_if_wrong();
    const std::string problem = assemble(*out_, starts_, vehicle_starts_, kinds_);
    if (!problem.empty())
      diagnostics_.error(document_.where_of("rates"), problem);
    else if (const auto over = start_problem(*out_))
      diagnostics_.error(document_.where_of("ends"), *over);
    stop_if_wrong();
    out_->files = source_.files();
    plugins_.tell(*out_);
  }

  Source& source_;
  const LoadRequest& request_;
  Plugins plugins_;
  Diagnostics diagnostics_;
  Value document_;
  std::vector<Removed> removed_;
  Plans plans_;
  TreeBook trees_;
  std::shared_ptr<model::Library> library_;
  std::vector<Start> starts_;
  std::vector<VehicleStart> vehicle_starts_;
  std::vector<std::unique_ptr<PlayerKind>> kinds_;
  std::shared_ptr<Scenario> out_ = std::make_shared<Scenario>();
};

}  // namespace

std::shared_ptr<const Scenario> load(const LoadRequest& request, Source source) {
  return Loader(request, source).load();
}

}  // namespace eyrie::scenario
