// SPDX-License-Identifier: MIT
#include "scenario/operator_orders.hpp"

#include <gtest/gtest.h>

#include "model/weapon/systems.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {
namespace {

class OperatorOrder : public ::testing::Test {
 protected:
  const std::shared_ptr<const Scenario> scenario_ =
      load({.file = "scenarios/sweep.yaml"}, Source::disk("."));

  [[nodiscard]] OperatorOrders orders(std::string_view text) const {
    return orders_from_json(*scenario_, text, 7);
  }
  [[nodiscard]] std::string problem(std::string_view text) const {
    const OperatorOrders made = orders(text);
    EXPECT_TRUE(made.orders.empty());
    return made.problem;
  }
};

TEST_F(OperatorOrder, GivesAPlayerAnotherTree) {
  const auto made =
      orders(R"({"do":"order","order":"tree","player":"eagle2","tree":"veteran_patrol"})");
  EXPECT_EQ(made.problem, "");
  EXPECT_EQ(made.kind, "tree");
  ASSERT_EQ(made.orders.size(), 1u);
  const PlayerId who = *scenario_->roster.find("eagle2");
  const Fleet& fleet = scenario_->fleet_of(who);
  for (std::uint16_t i = 0; i < fleet.trees.size(); ++i) {
    const sim::Order expected = fleet.agents->order_tree(7, who, i);
    EXPECT_EQ(std::memcmp(&made.orders[0], &expected, sizeof expected) == 0,
              fleet.trees[i]->name() == "veteran_patrol");
  }
}

TEST_F(OperatorOrder, IsForEverybodyOfAFlight) {
  const auto made = orders(R"({"order":"lose","flight":"eagle"})");
  EXPECT_EQ(made.problem, "");
  std::vector<PlayerId> who;
  for (const sim::Order& order : made.orders) {
    EXPECT_EQ(order.step, 7u);
    EXPECT_EQ(order.kind, sim::OrderKind(model::weapon::OrderKind::lose));
    who.push_back(order.player);
  }
  ASSERT_FALSE(who.empty());
  for (const Roster::Flight& flight : scenario_->roster.flights)
    EXPECT_EQ(who == flight.members, flight.name == "eagle");
}

TEST_F(OperatorOrder, SaysWhatIsWrong) {
  EXPECT_EQ(problem(R"({"order":"lsoe","player":"eagle1"})"),
            "there is no order 'lsoe'; did you mean 'lose'?");
  EXPECT_EQ(problem(R"({"order":"lose","player":"eagel1"})"),
            "there is no player 'eagel1'; did you mean 'eagle1'?");
  EXPECT_EQ(problem(R"({"order":"lose","flight":"eagel"})"),
            "there is no flight 'eagel'; did you mean 'eagle'?");
  EXPECT_EQ(problem(R"({"order":"tree","player":"eagle1","tree":"veterann"})"),
            "eagle1 has no tree 'veterann'; did you mean 'veteran'?");
  EXPECT_EQ(problem(R"({"order":"lose"})"), "an order is for a 'player' or for a 'flight'");
  EXPECT_EQ(problem(R"({"order":"lose","player":"eagle1","tree":"veteran_patrol"})"),
            "an order 'tree' names a tree, and no other does");
  for (const char* bad :
       {"", "[", "{}", "17", "\"lose\"", R"({"order":["lose"],"player":"eagle1"})",
        R"({"order":"lose","player":"eagle1","more":1})",
        R"({"order":"lose","player":"eagle1","player":"eagle2"})"})
    EXPECT_NE(problem(bad), "") << bad;
  EXPECT_NE(problem(R"({"order":"lose","player":")" + std::string(5000, 'x') + "\"}"), "");
}

}  // namespace
}  // namespace eyrie::scenario
