// SPDX-License-Identifier: MIT
#include "scenario/plan.hpp"

#include <algorithm>
#include <map>

#include "core/bind.hpp"
#include "core/text.hpp"
#include "model/datalink/datalink.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::size_t kLongestGroup = 40;
/// Flights and convoys; a row knows its own by 16 bits.
constexpr std::size_t kMostGroups = 5000;

/// Flights and convoys have one name in the file, in tables and in formats of other programs.
bool is_group_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestGroup && is_small(name.front()) &&
         std::ranges::all_of(name, [](char c) { return is_small(c) || is_digit(c) || c == '_'; });
}

/// The number behind the flight's name, or nothing.
std::optional<std::uint16_t> rank_of(std::string_view player, std::string_view flight) {
  if (!player.starts_with(flight))
    return std::nullopt;
  const std::string_view digits = player.substr(flight.size());
  return digits.starts_with('0') ? std::nullopt : number_from<std::uint16_t>(digits);
}

class Reader {
 public:
  Reader(const Value& document, Diagnostics& diagnostics, std::span<const std::string_view> others)
      : document_(document), diagnostics_(diagnostics), others_(others) {}

  Plans read() {
    side("blue", model::Side::blue);
    side("red", model::Side::red);
    if (plans_.flights.empty() && plans_.convoys.empty() && plans_.others.empty() &&
        diagnostics_.ok())
      diagnostics_.error(document_.where, "no flights: neither blue nor red has any");
    return std::move(plans_);
  }

 private:
  void side(std::string_view key, model::Side side) {
    const Value* map = document_.find(key);
    if (!map)
      return;
    if (!map->is_map())
      return error(map->where, "{}: expected a map with flights, got {}", key, map->shown());
    std::vector<std::string_view> keys{"home", "flights", "convoys"};
    keys.insert(keys.end(), others_.begin(), others_.end());
    bool has_groups = false, all_known = true;
    for (const Value::Entry& e : map->entries) {
      const bool known = std::ranges::find(keys, e.key) != keys.end();
      has_groups |= known && e.key != "home";
      all_known &= known;
      if (!known)
        error(e.where, "{} has no {}{}", key, quote(e.key), did_you_mean(e.key, keys));
    }

    std::optional<PlaceSpec> home;
    Location home_where;
    if (const Value* v = map->find("home")) {
      home.emplace();
      home_where = v->where;
      if (!bind(*home, *v, diagnostics_))
        home.reset();
    }
    const Value* flights = map->find("flights");
    const Value* convoys = map->find("convoys");
    if (!has_groups && all_known)  // an unknown key was meant as one
      return error(map->where, "{}: expected a map of flights, got nothing", key);
    for (const Value::Entry& e : groups(flights, key, "flights")) {
      FlightPlan plan;
      plan.home = home;
      plan.home_where = home_where;
      group(std::move(plan), plans_.flights, e, side);
    }
    for (const Value::Entry& e : groups(convoys, key, "convoys")) {
      plans_.read.push_back({e.key, e.where, on_the_ground(e.value, e.key)});
      group(ConvoyPlan{}, plans_.convoys, plans_.read.back(), side);
    }
    for (std::size_t kind = 0; kind < others_.size(); ++kind)
      for (const Value::Entry& e : groups(map->find(others_[kind]), key, others_[kind]))
        plans_.others.push_back({kind, &e, side});
  }

  std::span<const Value::Entry> groups(const Value* map, std::string_view side,
                                       std::string_view what) {
    if (!map)
      return {};
    if (map->is_map() && !map->entries.empty())
      return map->entries;
    error(map->where, "{}: expected a map of {}, got {}", side, what,
          map->is_map() ? "an empty map" : map->shown());
    return {};
  }

  /// Without what only aircraft have, after saying so.
  Value on_the_ground(Value value, std::string_view convoy) {
    static constexpr std::array<std::string_view, 10> kInTheAir{
        "altitude", "spread", "aircraft",  "fuel",       "bingo",
        "loadout",  "rounds", "formation", "privileged", "home"};
    for (Value& item : value.items)
      item = on_the_ground(std::move(item), convoy);
    std::erase_if(value.entries, [&](const Value::Entry& e) {
      const bool in_the_air = std::ranges::find(kInTheAir, e.key) != kInTheAir.end();
      if (in_the_air)
        error(e.where, "{} drives on the ground: '{}' is for aircraft", convoy, e.key);
      return in_the_air;
    });
    for (Value::Entry& e : value.entries)
      e.value = on_the_ground(std::move(e.value), convoy);
    return value;
  }

  template <class Plan>
  void group(Plan plan, std::vector<Plan>& plans, const Value::Entry& entry, model::Side side) {
    if (!is_group_name(entry.key) || is_digit(entry.key.back()))
      return error(entry.where,
                   "{} cannot name a {}: lower-case letters, digits and '_', with a "
                   "letter first and no digit last, at most {} in all",
                   quote(entry.key), Plan::word, kLongestGroup);
    const auto [known, fresh] = groups_.emplace(entry.key, entry.where);
    if (!fresh)
      return error(entry.where, "{} '{}' is defined twice (also at {})", Plan::word, entry.key,
                   known->second.text());
    if (groups_.size() > kMostGroups) {
      if (groups_.size() == kMostGroups + 1)
        error(entry.where, "a scenario has at most {} flights and convoys", kMostGroups);
      return;
    }
    if (!entry.value.is_map())
      return error(entry.value.where, "{} '{}': expected a map, got {}", Plan::word, entry.key,
                   entry.value.shown());
    plan.name = entry.key;
    plan.side = side;
    plan.where = entry.where;
    static constexpr std::array<std::string_view, 1> kAlso{"players"};
    plan.sound = bind(plan.spec, entry.value, diagnostics_, kAlso);
    plan.start_where = entry.value.where_of("start");
    plan.route_where = entry.value.where_of("route");
    if constexpr (requires { plan.spec.home; }) {
      if (plan.spec.home) {
        plan.home = plan.spec.home;
        plan.home_where = entry.value.where_of("home");
      }
    }

    const Value* players = entry.value.find("players");
    if (players && players->is_list() && !players->items.empty())
      for (const Value& item : players->items)
        player(plan, entry.value, item);
    else
      error(players ? players->where : entry.where,
            "{0} '{1}' needs its players: a list such as [{1}1, {1}2]", Plan::word, plan.name);
    if (plan.players.empty()) {  // so that what is said for all of them is read
      plan.players.push_back({.name = plan.name + "1",
                              .where = entry.where,
                              .spec = plan.spec,
                              .sound = plan.sound,
                              .group = &entry.value});
      return plans.push_back(std::move(plan));
    }
    std::ranges::sort(plan.players, {}, &Plan::Member::rank);
    // a player that was refused may have been meant as the lead
    if (plan.players.size() == players->items.size() && plan.players.front().rank != 1)
      error(players->where, "{0} '{1}' has no lead: none of its players is '{1}1'", Plan::word,
            plan.name);
    for (auto& member : plan.players)
      start_beside(plan.players.front(), member);
    plans.push_back(std::move(plan));
  }

  /// What a member without a place of its own does not say of its start is as the lead's.
  template <class Member>
  static void start_beside(const Member& lead, Member& member) {
    if (member.own_place || !lead.own)
      return;
    const auto own = std::exchange(member.spec.start, lead.spec.start);
    const Value* start = member.own ? member.own->find("start") : nullptr;
    const auto keep = [&](std::string_view key, auto of) {
      if (start && start->is_map() && start->find(key))
        member.spec.start.*of = own.*of;
    };
    using Start = std::remove_const_t<decltype(own)>;
    keep("heading", &Start::heading);
    keep("speed", &Start::speed);
    if constexpr (requires { &Start::altitude; })
      keep("altitude", &Start::altitude);
  }

  template <class Plan>
  void player(Plan& group, const Value& document, const Value& item) {
    const bool overrides = item.is_map() && item.entries.size() == 1;
    if (!item.is_scalar() && !overrides)
      return error(item.where, "players: expected a name or a name with a map, got {}",
                   item.shown());
    typename Plan::Member plan{.name = overrides ? item.entries[0].key : item.text,
                               .where = item.where,
                               .spec = group.spec,
                               .sound = group.sound,
                               .group = &document};
    const auto rank = rank_of(plan.name, group.name);
    if (!rank)
      return error(item.where, "{} is not the {}'s name and a rank, such as '{}1'",
                   quote(plan.name), Plan::word, group.name);
    plan.rank = *rank;
    if (plan.rank > model::kMaxFlight)
      return error(item.where, "'{}': the ranks of a {} are 1 to {}", plan.name, Plan::word,
                   model::kMaxFlight);
    const auto [known, fresh] = places_.emplace(plan.name, item.where);
    if (!fresh)
      return error(item.where, "there are two players '{}' (also at {})", plan.name,
                   known->second.text());
    if (overrides && !item.entries[0].value.is_null()) {
      const Value& map = item.entries[0].value;
      plan.own = &map;
      if (const Value* start = map.find("start"); start && start->is_map()) {
        plan.own_altitude = start->find("altitude");
        for (const std::string_view key : {"north", "east", "latitude", "longitude"})
          plan.own_place = plan.own_place || start->find(key);
      }
      if (plan.own_place)  // a place of its own replaces the flight's as a whole
        static_cast<PlaceSpec&>(plan.spec.start) = {};
      plan.sound = bind(plan.spec, map, diagnostics_) && plan.sound;
    }
    group.players.push_back(std::move(plan));
  }

  template <class... T>
  void error(const Location& where, fmt::format_string<T...> words, T&&... values) {
    diagnostics_.error(where, "{}", fmt::format(words, std::forward<T>(values)...));
  }

  const Value& document_;
  Diagnostics& diagnostics_;
  std::span<const std::string_view> others_;
  Plans plans_;
  std::map<std::string, Location> groups_, places_;
};

}  // namespace

Plans read_plans(const Value& document, Diagnostics& diagnostics,
                 std::span<const std::string_view> others) {
  return Reader(document, diagnostics, others).read();
}

}  // namespace eyrie::scenario
