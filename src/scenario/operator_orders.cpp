// SPDX-License-Identifier: MIT
#include "scenario/operator_orders.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/bind.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"
#include "model/weapon/systems.hpp"
#include "pilot/outside.hpp"

namespace eyrie::scenario {
namespace {

/// Far above what an order needs.
constexpr YamlLimits kOrderLimits{.bytes = 4096, .nodes = 100, .depth = 4};

using pilot::OrderKind, model::Manual, model::Seat;

struct AskedOfPlayer {
  using A = AskedOfPlayer;
  static constexpr std::string_view type_name = "order";
  [[maybe_unused]] static constexpr std::string_view help =
      "something asked of a player from outside, now";
  static constexpr auto params() {
    return std::tuple{param("order", &A::order, "what is asked").required(),
                      param("player", &A::player, "who"),
                      param("flight", &A::flight, "everybody of it, instead"),
                      param("tree", &A::tree, "the tree to go by, or that has the node"),
                      param("heading", &A::heading, range(-1e3, 1e3), "rad, true"),
                      param("altitude", &A::altitude, range(-1e3, 100e3), "m"),
                      param("speed", &A::speed, range(0, 10e3), "m/s, true airspeed"),
                      param("climb", &A::climb, range(-1.6, 1.6), "rad above the horizontal"),
                      param("load_factor", &A::load_factor, range(0, 100), "g, in turns"),
                      param("target", &A::target, range(0, 4e9), "number of a track"),
                      param("shoot", &A::shoot, "true: a missile at the target, once"),
                      param("gun", &A::gun, "true: the trigger is pressed"),
                      param("radar", &A::radar, "false: silent"),
                      param("dispense", &A::dispense, "decoys, once"),
                      param("node", &A::node, "path of a node"),
                      param("vote", &A::vote, range(0, 1000), "its vote"),
                      param("free", &A::free, "false: weapons tight"),
                      param("east", &A::east, range(-5e6, 5e6), "m, on the map"),
                      param("north", &A::north, range(-5e6, 5e6), "m, on the map"),
                      param("more", &A::more, "true: after the points there are")};
  }
  std::string order;
  std::optional<std::string> player, flight, tree, node;
  std::optional<double> heading, altitude, speed, climb, load_factor, vote, east, north;
  std::optional<std::uint32_t> target;
  bool shoot = false, gun = false, more = false;
  std::optional<bool> radar, free;
  std::optional<model::Dispense> dispense;
};

/// What an order may say besides whom it is for, and what it must.
struct KindOfOrder {
  std::string_view name;
  std::initializer_list<std::string_view> needs, may = {};
};
const std::array<KindOfOrder, 8> kKinds{{
    {"tree", {"tree"}},
    {"lose", {}},
    {"manual",
     {},
     {"heading", "altitude", "speed", "climb", "load_factor", "target", "shoot", "gun", "radar",
      "dispense"}},
    {"hand_back", {}},
    {"vote", {"tree", "node"}, {"vote"}},
    {"weapons", {"free"}},
    {"point", {"east", "north", "altitude"}, {"more"}},
    {"route", {}},
}};

/// JSON is YAML, but for a character beyond U+FFFF, which it writes as a pair of surrogates.
std::string yaml_of(std::string_view json) {
  const auto unit = [&](std::size_t at) -> std::uint32_t {  // of an escape \uXXXX; 0: none there
    std::uint32_t value = 0;
    const std::string_view text = json.substr(std::min(at, json.size()), 6);
    const bool whole = text.size() == 6 && text.starts_with("\\u") &&
                       std::from_chars(&text[2], &text[2] + 4, value, 16).ptr == &text[2] + 4;
    return whole ? value : 0;
  };
  std::string yaml;
  for (std::size_t at = 0; at < json.size();) {
    const std::uint32_t high = unit(at) - 0xD800, low = unit(at + 6) - 0xDC00;
    const bool pair = high < 0x400 && low < 0x400;
    const std::size_t size = pair ? 12 : json[at] == '\\' ? 2 : 1;
    yaml += pair ? fmt::format("\\U{:08x}", 0x10000 + (high << 10) + low) : json.substr(at, size);
    at += size;
  }
  return yaml;
}

/// A place of the map around the reference, where the Earth curves away below (MapPlace).
Vec3f place_of(double east, double north, double altitude) {
  constexpr double kEarth = 6'371e3;
  const double down = (east * east + north * north) / (2 * kEarth) - altitude;
  return narrow({north, east, down});
}

class OrderReader {
 public:
  OrderReader(const Scenario& scenario, const AskedOfPlayer& asked, std::uint64_t step)
      : scenario_(scenario), asked_(asked), step_(step) {}

  OperatorOrders read(const Value& text) {
    result_.kind = asked_.order;
    check(text);
    if (result_.problem.empty())
      for (const PlayerId who : ours(asked_.player ? player() : flight()))
        give(who);
    if (!result_.problem.empty())
      result_.orders.clear();
    return std::move(result_);
  }

 private:
  void check(const Value& text) {
    const auto kind = std::ranges::find(kKinds, asked_.order, &KindOfOrder::name);
    if (kind == std::end(kKinds))
      return refuse("there is no order {}{}", quote(asked_.order),
                    did_you_mean(asked_.order, listed(kKinds, &KindOfOrder::name)));
    const auto& [name, needs, may] = *kind;
    const auto has = [](auto list, std::string_view word) {
      return std::ranges::find(list, word) != list.end();
    };
    for (const std::string_view word : needs)
      if (const Value* given = text.find(word); !given || given->is_null())
        return refuse("an order '{}' needs '{}'", name, word);
    for (const Value::Entry& entry : text.entries)
      if (!has(needs, entry.key) && !has(may, entry.key) &&
          !has(std::initializer_list<std::string_view>{"do", "order", "player", "flight"},
               entry.key))
        return refuse("an order '{}' has no '{}'", name, entry.key);
    if (asked_.player.has_value() == asked_.flight.has_value())
      refuse("an order is for a 'player' or for a 'flight'");
  }

  std::vector<PlayerId> player() {
    if (const auto who = scenario_.roster.find(*asked_.player))
      return {*who};
    refuse("{}", scenario_.roster.unknown(*asked_.player));
    return {};
  }
  std::vector<PlayerId> flight() {
    const auto& flights = scenario_.roster.flights;
    for (const Roster::Flight& one : flights)
      if (one.name == *asked_.flight)
        return one.members;
    refuse("there is no flight {}{}", quote(*asked_.flight),
           did_you_mean(*asked_.flight, listed(flights, &Roster::Flight::name)));
    return {};
  }

  /// Of these. The others obey the program that flies them.
  std::vector<PlayerId> ours(std::vector<PlayerId> who) {
    const auto& roster = scenario_.roster;
    const std::size_t asked = who.size();
    std::erase_if(who, [&](PlayerId one) { return roster.find(one)->remote; });
    if (who.empty() && asked > 0)
      refuse("{} is another program's", asked_.player ? *asked_.player : *asked_.flight);
    return who;
  }

  void give(PlayerId who) {
    if (asked_.order == "lose")
      return result_.orders.push_back(model::weapon::lose_order(step_, who));
    const Fleet& fleet = scenario_.fleet_of(who);
    const auto tree = asked_.tree ? tree_of(who, fleet) : std::nullopt;
    if (asked_.tree && !tree)
      return;
    if (asked_.order == "tree")
      return result_.orders.push_back(fleet.agents->order_tree(step_, who, *tree));
    if (&fleet != scenario_.fleets.front().get())
      return refuse("{} is no aircraft: it can be given another tree or be lost, and nothing else",
                    scenario_.roster.name(who));
    if (asked_.order == "manual")
      order(who, OrderKind::manual, manual());
    else if (asked_.order == "hand_back")
      order(who, OrderKind::manual, Manual{});
    else if (asked_.order == "weapons")
      order(who, OrderKind::weapons, static_cast<std::uint8_t>(!*asked_.free));
    else if (asked_.order == "point")
      order(who, OrderKind::point,
            model::PointToFly{.position = place_of(*asked_.east, *asked_.north, *asked_.altitude),
                              .altitude = static_cast<float>(*asked_.altitude),
                              .more = asked_.more ? 1U : 0U});
    else if (asked_.order == "route")
      order(who, OrderKind::point, model::PointToFly{.more = 2});
    else if (const auto node = fleet.trees[*tree]->find(*asked_.node); !node)
      refuse("there is no node {} in tree {}{}", quote(*asked_.node), *asked_.tree,
             did_you_mean(*asked_.node, fleet.trees[*tree]->paths()));
    else if (!fleet.trees[*tree]->node(*node).takes_vote())
      refuse("{} does not vote", *asked_.node);
    else
      order(who, OrderKind::vote,
            model::VoteChange{.vote = static_cast<float>(asked_.vote.value_or(-1)),
                              .number = static_cast<std::uint16_t>(*node + 1),
                              .tree = static_cast<std::uint16_t>(*tree + 1)});
  }

  std::optional<std::uint16_t> tree_of(PlayerId who, const Fleet& fleet) {
    const auto tree = std::ranges::find(fleet.trees, *asked_.tree, &ubf::AnyTree::name);
    if (tree != fleet.trees.end())
      return static_cast<std::uint16_t>(tree - fleet.trees.begin());
    refuse("{} has no tree {}{}", scenario_.roster.name(who), quote(*asked_.tree),
           did_you_mean(*asked_.tree, listed(fleet.trees, &ubf::AnyTree::name)));
    return std::nullopt;
  }

  Manual manual() const {
    Manual m{.seat = Seat::person};
    const auto say = [&](const std::optional<double>& value, float Manual::*field, unsigned bit) {
      if (!value)
        return;
      m.*field = static_cast<float>(*value);
      m.said |= static_cast<std::uint16_t>(bit);
    };
    say(asked_.heading, &Manual::heading, Manual::kHeading);
    say(asked_.altitude, &Manual::altitude, Manual::kAltitude);
    say(asked_.speed, &Manual::speed, Manual::kSpeed);
    say(asked_.climb, &Manual::climb, Manual::kClimb);
    say(asked_.load_factor, &Manual::load_factor, Manual::kLoadFactor);
    if (asked_.target) {
      m.target = TrackId{*asked_.target};
      m.said |= Manual::kTarget;
    }
    if (asked_.radar) {
      m.radar_off = !*asked_.radar;
      m.said |= Manual::kRadar;
    }
    if (asked_.dispense) {
      m.dispense = *asked_.dispense;
      m.said |= Manual::kDispense;
    }
    m.trigger = asked_.gun;
    m.store = asked_.shoot ? pilot::kAnyStore : 0;
    return m;
  }

  template <class Payload>
  void order(PlayerId who, OrderKind kind, const Payload& payload) {
    result_.orders.push_back(sim::order_for(step_, who, kind, payload));
  }

  template <class... T>
  void refuse(fmt::format_string<T...> words, T&&... values) {
    result_.problem = fmt::format(words, std::forward<T>(values)...);
  }

  const Scenario& scenario_;
  const AskedOfPlayer& asked_;
  std::uint64_t step_;
  OperatorOrders result_;
};

std::string why_unable(const sim::Order& one, const Scenario& scenario, const sim::World& world,
                       std::span<const sim::Order> waiting) {
  const bool is_lost = std::ranges::any_of(waiting, [&](const sim::Order& before) {
    return before.player == one.player && before.step <= one.step &&
           before.kind == sim::OrderKind(model::weapon::OrderKind::lose);
  });
  if (is_lost || !scenario.find(world, one.player))
    return "is no longer there";
  const auto row = world.row(scenario.aircraft.table, one.player);
  const auto& accepted = pilot::Outside::orders;
  if (!row || one.step > world.step() || std::ranges::find(accepted, one.kind) == accepted.end())
    return "";
  pilot::Outside::Asked asked = world.rows(scenario.aircraft.tasking)[*row];
  std::uint16_t tree = world.rows(scenario.pilots.agent)[*row].tree;
  const auto obey = [&](const sim::Order& order) {
    const std::size_t nodes = tree < scenario.trees->size() ? (*scenario.trees)[tree].size() : 0;
    return pilot::Outside::obey(order, asked, {tree, nodes}) != team::Obeyed::no;
  };
  for (const sim::Order& before : waiting)
    if (before.player == one.player) {
      if (before.kind == sim::OrderKind(OrderKind::swap_tree))
        tree = before.as<team::SwapTree>().tree;
      else
        obey(before);
    }
  if (tree == team::kNoTree)
    return "flies by no tree: it obeys once it has one";
  if (one.kind == sim::OrderKind(OrderKind::vote) && one.as<model::VoteChange>().tree != tree + 1)
    return "flies by another tree";
  if (obey(one))
    return "";
  return one.kind == sim::OrderKind(OrderKind::point)
             ? fmt::format("has {} points to fly to already", model::Tasking::kPoints)
         : one.kind == sim::OrderKind(OrderKind::vote)
             ? fmt::format("has {} other votes already", model::Tasking::kVotes)
             : "cannot obey that";
}

}  // namespace

OperatorOrders orders_from_json(const Scenario& scenario, std::string_view text,
                                std::uint64_t step) {
  static constexpr std::array<std::string_view, 1> kOfTheChannel{"do"};
  if (text.size() > kOrderLimits.bytes)
    return {.kind = {},
            .orders = {},
            .problem = fmt::format("an order has at most {} bytes, this one has {}",
                                   kOrderLimits.bytes, text.size())};
  Diagnostics wrong;
  AskedOfPlayer asked;
  const Value value = parse_yaml(yaml_of(text), "order", wrong, kOrderLimits);
  if (!wrong.count())
    bind(asked, value, wrong, kOfTheChannel);
  if (wrong.count())
    return {.kind = {}, .orders = {}, .problem = wrong.sorted().front().message};
  return OrderReader(scenario, asked, step).read(value);
}

void leave_out_unable(OperatorOrders& asked, const Scenario& scenario, const sim::World& world,
                      std::span<const sim::Order> waiting) {
  std::string first;
  std::erase_if(asked.orders, [&](const sim::Order& one) {
    const std::string why = why_unable(one, scenario, world, waiting);
    if (first.empty() && !why.empty())
      first = fmt::format("{} {}", scenario.roster.name(one.player), why);
    return !why.empty();
  });
  if (asked.orders.empty() && asked.problem.empty())
    asked.problem = first;
}

}  // namespace eyrie::scenario
