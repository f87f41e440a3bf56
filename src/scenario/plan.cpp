// SPDX-License-Identifier: MIT
#include "scenario/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>

#include "core/bind.hpp"
#include "model/datalink/datalink_state.hpp"

namespace eyrie::scenario {
namespace {

bool is_identifier(std::string_view name) {
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
         });
}

/// The number behind the flight's name, or nothing.
std::optional<std::uint16_t> rank_of(std::string_view player, std::string_view flight) {
  if (!player.starts_with(flight))
    return std::nullopt;
  const std::string_view digits = player.substr(flight.size());
  std::uint16_t rank = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), rank);
  if (failed != std::errc{} || end != digits.data() + digits.size() || rank == 0 ||
      digits.front() == '0')
    return std::nullopt;
  return rank;
}

class Reader {
 public:
  Reader(const Value& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  std::vector<FlightPlan> read() {
    side("blue", model::Side::blue);
    side("red", model::Side::red);
    if (flights_.empty() && diagnostics_.ok())
      diagnostics_.error(document_.where, "no flights: neither blue nor red has any");
    return std::move(flights_);
  }

 private:
  void side(std::string_view key, model::Side side) {
    const Value* map = document_.find(key);
    if (!map)
      return;
    if (!map->is_map())
      return error(map->where,
                   fmt::format("{}: expected a map with flights, got {}", key, map->shown()));
    static constexpr std::array<std::string_view, 2> kKeys{"home", "flights"};
    for (const Value::Entry& e : map->entries)
      if (std::find(kKeys.begin(), kKeys.end(), e.key) == kKeys.end())
        error(e.where,
              fmt::format("{} has no {}{}", key, quote(e.key), did_you_mean(e.key, kKeys)));
      else if (&map->find_entry(e.key)->value != &e.value)
        error(e.where, fmt::format("{}: '{}' is given twice (first at line {})", key, e.key,
                                   map->find_entry(e.key)->where.line));

    std::optional<PlaceSpec> home;
    Location home_where;
    if (const Value* v = map->find("home")) {
      home.emplace();
      home_where = v->where;
      if (!bind(*home, *v, diagnostics_))
        home.reset();
    }
    const Value* flights = map->find("flights");
    if (!flights || !flights->is_map() || flights->entries.empty())
      return error(flights ? flights->where : map->where,
                   fmt::format("{}: expected a map of flights, got {}", key,
                               flights ? flights->shown() : "nothing"));
    for (const Value::Entry& e : flights->entries)
      flight(e, side, home, home_where);
  }

  void flight(const Value::Entry& entry, model::Side side, const std::optional<PlaceSpec>& home,
              const Location& home_where) {
    if (!is_identifier(entry.key) || (entry.key.back() >= '0' && entry.key.back() <= '9'))
      return error(
          entry.where,
          fmt::format("{} cannot name a flight: lower-case letters, digits and '_', with a "
                      "letter first and no digit last",
                      quote(entry.key)));
    for (const FlightPlan& other : flights_)
      if (other.name == entry.key)
        return error(entry.where, fmt::format("flight '{}' is defined twice (also at {})",
                                              entry.key, other.where.text()));
    FlightPlan plan{.name = entry.key, .side = side, .where = entry.where};
    static constexpr std::array<std::string_view, 1> kAlso{"players"};
    plan.sound = bind(plan.spec, entry.value, diagnostics_, kAlso);
    const auto place = [&](std::string_view key) {
      const Value* v = entry.value.find(key);
      return v ? v->where : entry.value.where;
    };
    plan.start_where = place("start");
    plan.route_where = place("route");
    plan.home = plan.spec.home ? plan.spec.home : home;
    plan.home_where = plan.spec.home ? place("home") : home_where;

    const Value* players = entry.value.find("players");
    if (!players || !players->is_list() || players->items.empty())
      return error(
          players ? players->where : entry.where,
          fmt::format("flight '{0}' needs its players: a list such as [{0}1, {0}2]", plan.name));
    for (const Value& item : players->items)
      player(plan, entry.value, item);
    std::sort(plan.players.begin(), plan.players.end(),
              [](const PlayerPlan& a, const PlayerPlan& b) { return a.rank < b.rank; });
    // a player that was refused may have been meant as the lead
    if (plan.players.size() == players->items.size() && plan.players.front().rank != 1)
      error(players->where,
            fmt::format("flight '{0}' has no lead: none of its players is '{0}1'", plan.name));
    flights_.push_back(std::move(plan));
  }

  void player(FlightPlan& flight, const Value& document, const Value& item) {
    const bool overrides = item.is_map() && item.entries.size() == 1;
    if (!item.is_scalar() && !overrides)
      return error(item.where,
                   "players: expected a name or a name with a map, got " + item.shown());
    PlayerPlan plan{.name = overrides ? item.entries[0].key : item.text,
                    .where = item.where,
                    .spec = flight.spec,
                    .sound = flight.sound,
                    .flight = &document};
    const auto rank = rank_of(plan.name, flight.name);
    if (!rank)
      return error(item.where, fmt::format("{} is not the flight's name and a rank, such as '{}1'",
                                           quote(plan.name), flight.name));
    plan.rank = *rank;
    if (plan.rank > model::kMaxFlight)
      return error(item.where, fmt::format("'{}': the ranks of a flight are 1 to {}", plan.name,
                                           model::kMaxFlight));
    const auto [known, fresh] = places_.emplace(plan.name, item.where);
    if (!fresh)
      return error(item.where, fmt::format("there are two players '{}' (also at {})", plan.name,
                                           known->second.text()));
    if (overrides && !item.entries[0].value.is_null()) {
      const Value& map = item.entries[0].value;
      plan.own = &map;
      if (const Value* start = map.find("start"); start && start->is_map())
        for (const std::string_view key : {"north", "east", "latitude", "longitude"})
          plan.own_place = plan.own_place || start->find(key);
      if (plan.own_place)  // a place of its own replaces the flight's as a whole
        static_cast<PlaceSpec&>(plan.spec.start) = {};
      plan.sound = bind(plan.spec, map, diagnostics_) && plan.sound;
    }
    flight.players.push_back(std::move(plan));
  }

  void error(const Location& where, std::string message) {
    diagnostics_.error(where, std::move(message));
  }

  const Value& document_;
  Diagnostics& diagnostics_;
  std::vector<FlightPlan> flights_;
  std::map<std::string, Location> places_;
};

}  // namespace

const Value* PlayerPlan::said(std::string_view key) const {
  const Value* mine = own ? own->find(key) : nullptr;
  return mine || !flight ? mine : flight->find(key);
}

const Location& PlayerPlan::place(std::string_view key) const {
  const Value* value = said(key);
  return value ? value->where : where;
}

std::vector<FlightPlan> read_plans(const Value& document, Diagnostics& diagnostics) {
  return Reader(document, diagnostics).read();
}

}  // namespace eyrie::scenario
