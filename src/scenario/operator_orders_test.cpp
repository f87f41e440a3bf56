// SPDX-License-Identifier: MIT
#include "scenario/operator_orders.hpp"

#include <gtest/gtest.h>

#include "model/weapon/systems.hpp"
#include "pilot/outside.hpp"
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

TEST_F(OperatorOrder, IsForNobodyOfAnotherProgram) {
  const auto shared =
      load({.file = "scenarios/sweep.yaml", .sets = {"ours=[blue, bogey2]"}}, Source::disk("."));
  const auto of = [&](std::string_view text) { return orders_from_json(*shared, text, 7); };
  EXPECT_EQ(of(R"({"order":"lose","player":"bogey1"})").problem, "bogey1 is another program's");
  const auto flight = of(R"({"order":"lose","flight":"bogey"})");
  ASSERT_EQ(flight.orders.size(), 1u);
  EXPECT_EQ(flight.orders[0].player, shared->roster.find("bogey2"));
}

TEST_F(OperatorOrder, PutsAPersonAtTheControls) {
  const auto made = orders(
      R"({"order":"manual","player":"eagle1","heading":1.5,"climb":-0.2,"target":4,"shoot":true,)"
      R"("radar":false,"dispense":"flares"})");
  ASSERT_EQ(made.problem, "");
  ASSERT_EQ(made.orders.size(), 1u);
  using model::Manual;
  const auto m = made.orders[0].as<Manual>();
  EXPECT_EQ(m.seat, model::Seat::person);
  EXPECT_EQ(m.said, Manual::kHeading | Manual::kClimb | Manual::kTarget | Manual::kRadar |
                        Manual::kDispense);
  EXPECT_EQ(m.heading, 1.5F);
  EXPECT_EQ(m.climb, -0.2F);
  EXPECT_EQ(m.target, TrackId{4});
  EXPECT_EQ(m.store, pilot::kAnyStore);
  EXPECT_EQ(m.radar_off, 1);
  EXPECT_EQ(m.dispense, model::Dispense::flares);
  const auto back = orders(R"({"order":"hand_back","player":"eagle1"})");
  ASSERT_EQ(back.orders.size(), 1u);
  EXPECT_EQ(back.orders[0].as<Manual>().seat, model::Seat::tree);
}

TEST_F(OperatorOrder, ChangesVotesWeaponsAndRoute) {
  const PlayerId who = *scenario_->roster.find("eagle1");
  const Fleet& fleet = scenario_->fleet_of(who);
  const ubf::AnyTree& tree = *fleet.trees[0];
  const auto vote = orders(
      fmt::format(R"({{"order":"vote","player":"eagle1","tree":"{}","node":"{}","vote":70}})",
                  tree.name(), tree.path(2)));
  ASSERT_EQ(vote.problem, "");
  EXPECT_EQ(vote.orders[0].as<model::VoteChange>().number, 3);
  EXPECT_EQ(vote.orders[0].as<model::VoteChange>().vote, 70);
  EXPECT_EQ(vote.orders[0].as<model::VoteChange>().tree, 1);
  EXPECT_EQ(orders(R"({"order":"weapons","flight":"eagle","free":false})").orders.size(), 4u);
  const auto point = orders(
      R"({"order":"point","player":"eagle1","east":9000,"north":2000,"altitude":8000,"more":true})");
  ASSERT_EQ(point.problem, "");
  const auto to = point.orders[0].as<model::PointToFly>();
  EXPECT_EQ(to.position[0], 2000);
  EXPECT_EQ(to.position[1], 9000);
  EXPECT_EQ(to.altitude, 8000);
  EXPECT_EQ(to.more, 1u);
  EXPECT_EQ(orders(R"({"order":"route","player":"eagle1"})").orders[0].as<model::PointToFly>().more,
            2u);
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
            "an order 'lose' has no 'tree'");
  EXPECT_EQ(problem(R"({"order":"tree","player":"eagle1"})"), "an order 'tree' needs 'tree'");
  EXPECT_EQ(problem(R"({"order":"vote","player":"eagle1","tree":"veteran","node":"root/x"})"),
            "there is no node 'root/x' in tree veteran");
  EXPECT_EQ(
      problem(R"({"order":"vote","player":"eagle1","tree":"veteran","node":"root/bvr/pres"})"),
      "there is no node 'root/bvr/pres' in tree veteran; did you mean 'root/bvr/press'?");
  const ubf::AnyTree& tree = *scenario_->fleet_of(*scenario_->roster.find("eagle1")).trees[0];
  for (ubf::NodeIndex node = 0; node < tree.size(); ++node)
    EXPECT_EQ(orders(fmt::format(
                         R"({{"order":"vote","player":"eagle1","tree":"{}","node":"{}","vote":1}})",
                         tree.name(), tree.path(node)))
                  .problem,
              tree.node(node).takes_vote() ? "" : tree.path(node) + " does not vote");
  // what is needed and null is not given
  EXPECT_EQ(problem(R"({"order":"weapons","player":"eagle1","free":null})"),
            "an order 'weapons' needs 'free'");
  EXPECT_EQ(problem(R"({"order":"point","player":"eagle1","east":1,"north":null,"altitude":1})"),
            "an order 'point' needs 'north'");
  EXPECT_EQ(problem(R"({"order":"tree","player":"eagle1","tree":null})"),
            "an order 'tree' needs 'tree'");
  for (const char* bad :
       {"", "[", "{}", "17", "\"lose\"", R"({"order":["lose"],"player":"eagle1"})",
        R"({"order":"lose","player":"eagle1","more":1})",
        R"({"order":"lose","player":"eagle1","player":"eagle2"})"})
    EXPECT_NE(problem(bad), "") << bad;
  EXPECT_EQ(problem(R"({"order":"lose","player":")" + std::string(5000, 'x') + "\"}"),
            "an order has at most 4096 bytes, this one has 5028");
}

TEST_F(OperatorOrder, HasATargetThatIsAWholeNumber) {
  const auto with = [](std::string_view target) {
    return fmt::format(R"({{"order":"manual","player":"eagle1","target":{}}})", target);
  };
  for (const char* bad : {"1.5", "1e0", "4e9", "1.0", ".nan", "true", "\"1\"", "[1]"})
    EXPECT_TRUE(problem(with(bad)).starts_with("target: expected a whole number, got ")) << bad;
  for (const char* bad : {"-1", "4000000001", "4294967297", "36893488147419103233"})
    EXPECT_EQ(problem(with(bad)), fmt::format("target: {} is outside [0, 4000000000]", bad));
  EXPECT_EQ(orders(with("4000000000")).orders[0].as<model::Manual>().target, TrackId{4000000000});
}

TEST_F(OperatorOrder, ReadsCharactersAsJsonEscapesThem) {
  const auto named = [](std::string_view name) {
    return fmt::format(R"({{"order":"lose","player":"{}"}})", name);
  };
  EXPECT_EQ(orders(named(R"(eagle\u0031)")).problem, "");
  const auto is_nobody = [&](std::string_view name, const std::string& read) {
    EXPECT_TRUE(problem(named(name)).starts_with("there is no player '" + read + "'")) << name;
  };
  is_nobody(R"(\ud83D\uDE00!)", "\xF0\x9F\x98\x80!");
  is_nobody(R"(\uDBFF\udfff)", "\xF4\x8F\xBF\xBF");
  is_nobody(R"(\\ud83d\\ude00)", R"(\ud83d\ude00)");
  for (const char* bad : {R"(\ud83d)", R"(\ude00)", R"(\ude00\ud83d)", R"(\ud83d\u0041)",
                          R"(\ud83d \ude00)", R"(\ud83d\\ude00)", R"(\ud83d\ude0)", R"(\)"})
    EXPECT_TRUE(problem(named(bad)).starts_with("not YAML: ")) << bad;
}

TEST_F(OperatorOrder, IsForWhoIsStillThere) {
  sim::World world = scenario_->world(1);
  const PlayerId lost = *scenario_->roster.find("eagle2");
  OperatorOrders one = orders(R"({"order":"lose","player":"eagle2"})");
  OperatorOrders flight = orders(R"({"order":"hand_back","flight":"eagle"})");
  leave_out_unable(one, *scenario_, world);
  EXPECT_EQ(one.problem, "");
  world.remove(scenario_->aircraft.table, *world.row(scenario_->aircraft.table, lost));
  world.compact();
  leave_out_unable(one, *scenario_, world);
  EXPECT_EQ(one.problem, "eagle2 is no longer there");
  EXPECT_TRUE(one.orders.empty());
  leave_out_unable(flight, *scenario_, world);
  EXPECT_EQ(flight.problem, "");
  EXPECT_EQ(flight.orders.size(), 3u);
}

TEST_F(OperatorOrder, IsRefusedByWhoCannotObeyIt) {
  sim::World world = scenario_->world(1);
  std::vector<sim::Order> waiting;
  const auto give = [&](const std::string& text) {
    OperatorOrders one = orders_from_json(*scenario_, text, 0);
    leave_out_unable(one, *scenario_, world, waiting);
    waiting.insert(waiting.end(), one.orders.begin(), one.orders.end());
    return one.problem;
  };
  for (const char* climb : {"1.6", "-1.6"})
    EXPECT_EQ(give(fmt::format(R"({{"order":"manual","player":"eagle3","climb":{}}})", climb)), "");
  waiting.push_back(model::weapon::lose_order(100, *scenario_->roster.find("eagle3")));
  EXPECT_EQ(give(R"({"order":"hand_back","player":"eagle3"})"), "") << "it will be lost later";
  EXPECT_EQ(give(R"({"order":"lose","player":"eagle3"})"), "");
  EXPECT_EQ(give(R"({"order":"hand_back","player":"eagle3"})"), "eagle3 is no longer there");
  const std::string point =
      R"({"order":"point","player":"eagle1","east":0,"north":0,"altitude":5000,"more":true})";
  for (std::size_t i = 0; i < model::Tasking::kPoints; ++i)
    EXPECT_EQ(give(point), "");
  EXPECT_EQ(give(point), "eagle1 has 4 points to fly to already");
  EXPECT_EQ(
      give(R"({"order":"vote","player":"eagle1","tree":"veteran_patrol","node":"root","vote":5})"),
      "eagle1 flies by another tree");

  auto& agent = world.rows(scenario_->pilots.agent)[*world.row(scenario_->aircraft.table,
                                                               *scenario_->roster.find("eagle2"))];
  agent.tree = team::kNoTree;
  const std::string manual = R"({"order":"manual","player":"eagle2","heading":1})";
  EXPECT_EQ(give(manual), "eagle2 flies by no tree: it obeys once it has one");
  EXPECT_EQ(give(R"({"order":"tree","player":"eagle2","tree":"veteran_patrol"})"), "");
  EXPECT_EQ(give(manual), "");
}

}  // namespace
}  // namespace eyrie::scenario
