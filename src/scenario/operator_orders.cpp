// SPDX-License-Identifier: MIT
#include "scenario/operator_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/bind.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"
#include "model/weapon/systems.hpp"

namespace eyrie::scenario {
namespace {

/// Far above what an order needs.
constexpr YamlLimits kOrderLimits{.bytes = 4096, .nodes = 100, .depth = 4};

struct AskedOfPlayer {
  static constexpr std::string_view type_name = "order";
  static constexpr auto params() {
    return std::tuple{
        param("order", &AskedOfPlayer::order, "tree or lose").required(),
        param("player", &AskedOfPlayer::player, "who"),
        param("flight", &AskedOfPlayer::flight, "everybody of it, instead"),
        param("tree", &AskedOfPlayer::tree, "the tree to fly or drive by from then on")};
  }
  std::string order;
  std::optional<std::string> player, flight, tree;
};

class OrderReader {
 public:
  OrderReader(const Scenario& scenario, const AskedOfPlayer& asked, std::uint64_t step)
      : scenario_(scenario), asked_(asked), step_(step) {}

  OperatorOrders read() {
    result_.kind = asked_.order;
    static constexpr std::array<std::string_view, 2> kKinds{"tree", "lose"};
    if (std::find(kKinds.begin(), kKinds.end(), asked_.order) == kKinds.end())
      refuse("there is no order {}{}", quote(asked_.order), did_you_mean(asked_.order, kKinds));
    else if ((asked_.order == "tree") != asked_.tree.has_value())
      refuse("an order 'tree' names a tree, and no other does");
    else if (asked_.player.has_value() == asked_.flight.has_value())
      refuse("an order is for a 'player' or for a 'flight'");
    else
      for (const PlayerId who : asked_.player ? player() : flight())
        give(who);
    if (!result_.problem.empty())
      result_.orders.clear();
    return std::move(result_);
  }

 private:
  std::vector<PlayerId> player() {
    if (const auto who = scenario_.roster.find(*asked_.player))
      return {*who};
    std::vector<std::string> names;
    for (const Roster::Player& one : scenario_.roster.players)
      names.push_back(one.name);
    refuse("there is no player {}{}", quote(*asked_.player), did_you_mean(*asked_.player, names));
    return {};
  }
  std::vector<PlayerId> flight() {
    std::vector<std::string> names;
    for (const Roster::Flight& one : scenario_.roster.flights) {
      if (one.name == *asked_.flight)
        return one.members;
      names.push_back(one.name);
    }
    refuse("there is no flight {}{}", quote(*asked_.flight), did_you_mean(*asked_.flight, names));
    return {};
  }

  void give(PlayerId who) {
    if (asked_.order == "lose")
      return result_.orders.push_back(model::weapon::lose_order(step_, who));
    const Fleet& fleet = scenario_.fleet_of(who);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < fleet.trees.size(); ++i) {
      if (fleet.trees[i]->name() == *asked_.tree)
        return result_.orders.push_back(
            fleet.agents->order_tree(step_, who, static_cast<std::uint16_t>(i)));
      names.emplace_back(fleet.trees[i]->name());
    }
    refuse("{} has no tree {}{}", scenario_.roster.name(who), quote(*asked_.tree),
           did_you_mean(*asked_.tree, names));
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

}  // namespace

OperatorOrders orders_from_json(const Scenario& scenario, std::string_view text,
                                std::uint64_t step) {
  static constexpr std::array<std::string_view, 1> kOfTheChannel{"do"};
  Diagnostics wrong;
  AskedOfPlayer asked;
  const Value value = parse_yaml(text, "order", wrong, kOrderLimits);  // JSON is YAML
  if (!wrong.count())
    bind(asked, value, wrong, kOfTheChannel);
  if (wrong.count())
    return {.kind = {}, .orders = {}, .problem = wrong.sorted().front().message};
  return OrderReader(scenario, asked, step).read();
}

}  // namespace eyrie::scenario
