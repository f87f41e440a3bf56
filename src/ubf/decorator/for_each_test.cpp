// SPDX-License-Identifier: MIT
#include "ubf/decorator/for_each.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

/// A leaf that says what cue 0 says, and remembers nothing: its vote and altitude are those of the
/// thing that is looked at.
class Glance final : public Node {
 public:
  static constexpr std::string_view type_name = "glance";
  static constexpr std::string_view help = "says what cue 0 says";
  Status tick(const RobotTick& t, RobotProposal& out) const override {
    EYRIE_DEMAND(out.is_empty(), "what a behavior is given to write to is not empty");
    out.action = t.state.cues[0].action;
    out.vote = t.state.cues[0].vote;
    return t.state.range > 100 || t.state.range < nearest ? Status::failure
                                                          : t.state.cues[0].status;
  }
  double nearest = 0;  ///< m
};

/// Votes for each thing what it draws.
class Gambler final : public Node {
 public:
  static constexpr std::string_view type_name = "gambler";
  static constexpr std::string_view help = "draws";
  Status tick(const RobotTick& t, RobotProposal& out) const override {
    out.action.altitude = draw(t).uniform();
    drawn.push_back(*out.action.altitude);
    return kRunning;
  }
  mutable std::vector<double> drawn;
};

Robot looking_at(std::vector<double> things, Choose choose) {
  auto node = make<ForEach<State, Action>>(make<Glance>());
  node->choose = choose;
  node->go_over(StateLists<State>::all().front());
  Robot robot(std::move(node));
  std::copy(things.begin(), things.end(), robot.state.things.begin());
  robot.state.thing_count = things.size();
  robot.say(0, kRunning);
  return robot;
}

TEST(ForEach, SaysThatThereIsNothing) {
  Robot robot = looking_at({}, Choose::strongest);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_STREQ(robot.trace.why(0), "there is nothing to look at");
}

TEST(ForEach, TakesTheHighestVoteOfAllThings) {
  Robot robot = looking_at({20, 50, 200, 50}, Choose::strongest);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 50);
  EXPECT_EQ(robot.out.action.altitude, 50);
  EXPECT_EQ(robot.leader(), "root/glance");
  EXPECT_EQ(robot.row("root/glance").proposal.vote, 50) << "the trace shows the chosen one";
  EXPECT_EQ(robot.state.range, 0) << "the agent's own state stays";
}

TEST(ForEach, OrTheFirstThatDoesNotFail) {
  Robot robot = looking_at({200, 20, 50}, Choose::first);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 20);
}

TEST(ForEach, AsksAnewForEveryThing) {
  auto node = make<ForEach<State, Action>>(make<Guard<State, Action>>(check(5), make<Glance>()));
  node->go_over(StateLists<State>::all().front());
  Robot robot(std::move(node));
  robot.state.things = {20, 50};
  robot.state.thing_count = 2;
  robot.say(0, kRunning);
  robot.say(5, kSuccess);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 50);
  EXPECT_EQ(robot.slab, std::vector<std::byte>(robot.slab.size())) << "nothing is left behind";
}

TEST(ForEach, DrawsAnewForEveryThing) {
  auto inner = make<ForEach<State, Action>>(make<Gambler>());
  inner->go_over(StateLists<State>::all().front());
  auto outer = make<ForEach<State, Action>>(std::move(inner));
  outer->go_over(StateLists<State>::all().front());
  Robot robot(std::move(outer));
  robot.state.thing_count = 3;
  const auto& gambler = static_cast<const Gambler&>(robot.tree.node(2));
  std::vector<std::byte> slab(robot.tree.memory_bytes());
  const auto drawn_at = [&](std::uint64_t step) {
    gambler.drawn.clear();
    robot.tree.tick({.state = robot.state, .step = step, .memory = slab.data()}, robot.out);
    return gambler.drawn;
  };
  const std::vector<double> drawn = drawn_at(1);
  ASSERT_EQ(drawn.size(), 9u);
  EXPECT_EQ(std::set<double>(drawn.begin(), drawn.end()).size(), 9u);
  EXPECT_EQ(drawn_at(1), drawn) << "the same step draws the same";
  EXPECT_NE(drawn_at(2), drawn);
  robot.tick();
  EXPECT_EQ(robot.row("root/for_each/gambler").proposal.action.altitude, robot.out.action.altitude)
      << "the trace shows what was drawn for the chosen one";
}

TEST(ForEach, IsTracedAsIfTheChosenThingWereTheOnlyOne) {
  const auto over = [](Child child) {
    auto node = make<ForEach<State, Action>>(std::move(child));
    node->go_over(StateLists<State>::all().front());
    Robot robot(std::move(node));
    robot.state.things = {40, 50};  // the first glance fails for the first thing
    robot.state.thing_count = 2;
    robot.say(0, kRunning);
    EXPECT_EQ(robot.tick(), kRunning);
    EXPECT_EQ(robot.out.vote, 50);
    return robot;
  };
  const auto glances = [] {
    auto far = make<Glance>();
    far->nearest = 45;
    Children all;
    all.push_back(std::move(far));
    all.push_back(make<Glance>());
    return all;
  };
  const Robot selector = over(make<Selector<State, Action>>(glances()));
  EXPECT_TRUE(selector.row("root/selector/glance[0]").ticked);
  EXPECT_FALSE(selector.row("root/selector/glance[1]").ticked) << "asked for another thing alone";

  const Robot fusion = over(make<Fusion<State, Action>>(glances()));
  EXPECT_EQ(fusion.row("root").supplier[1], fusion.node("root/fusion")) << "of both";
  auto top = make<Fusion<State, Action>>(glances());
  top->top = 1;
  const Robot first = over(std::move(top));
  EXPECT_TRUE(std::isnan(first.trace.given_vote(first.node("root/fusion/glance[0]"))));
}

TEST(ForEach, FailsWithoutThingsAndIfEveryOneFails) {
  Robot none = looking_at({}, Choose::strongest);
  EXPECT_EQ(none.tick(), kFailure);
  Robot far = looking_at({101, 102}, Choose::first);
  EXPECT_EQ(far.tick(), kFailure);
}

TEST(ForEach, KnowsSuccessOfConditionsThatProposeNothing) {
  Robot robot(build("{for_each: {over: things, child: {holds: range < 30 m}}}"));
  robot.state.things = {40, 20};
  robot.state.thing_count = 1;
  EXPECT_EQ(robot.tick(), kFailure);
  robot.state.thing_count = 2;
  EXPECT_EQ(robot.tick(), kSuccess);
}

TEST(ForEach, MistakesAreSaid) {
  EXPECT_EQ(mistakes("{for_each: {over: thing, child: {holds: alarm}}}"),
            "test.yaml:1:19: the state has no list 'thing'; did you mean 'things'?");
  EXPECT_EQ(mistakes("{for_each: {over: things, child: {inverter: {probe: {cue: 1}}}}}"),
            "test.yaml:1:2: for_each asks for one thing after the other, but probe remembers");
}

}  // namespace
}  // namespace eyrie::ubf::testing
