// SPDX-License-Identifier: MIT
#include "ubf/trace.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

/// Another platform's action.
struct Steer {
  std::optional<float> wheel;
};

}  // namespace eyrie::ubf::testing

template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Steer> {
  static constexpr auto fields =
      std::tuple{field<blend::Mean>("wheel", &testing::Steer::wheel, "rad")};
};

namespace eyrie::ubf::testing {
namespace {

TEST(Trace, HoldsEveryNodesStatusVoteAndAction) {
  Robot robot(make<Wta>(probe(0), probe(1), check(2)));
  robot.cue(0) = {kRunning, 2, {.heading = 1}};
  robot.cue(1) = {kSuccess, 5, {.altitude = 7}};
  robot.tick();
  ASSERT_EQ(robot.trace.rows().size(), 4u);
  const auto& loser = robot.row("root/probe[0]");
  EXPECT_TRUE(loser.ticked);
  EXPECT_EQ(loser.status, kRunning);
  EXPECT_EQ(loser.proposal.vote, 2);
  EXPECT_TRUE(equal(loser.proposal.action, {.heading = 1}));
  EXPECT_EQ(loser.supplier[0], robot.node("root/probe[0]"));
  const auto& condition = robot.row("root/check");
  EXPECT_TRUE(condition.ticked);
  EXPECT_EQ(condition.status, kFailure);
  EXPECT_TRUE(condition.proposal.is_empty());
  EXPECT_EQ(robot.row("root").proposal.vote, 5);
}

/// Fails, and says why, whenever it is asked in an even step.
class Moody final : public Behavior<State, Action> {
 public:
  static constexpr std::string_view type_name = "moody";
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    if (t.step % 2 == 0)
      return fails(t, "an even step");
    out.action.heading = 1;
    out.vote = 1;
    return Status::running;
  }
};

TEST(Trace, KeepsWhyANodeFailedUntilTheNextTick) {
  const Tree<State, Action> tree("test", make<Wta>(make<Moody>()));
  Trace<Action> trace(tree.size());
  const State state;
  Proposal<Action> out;
  std::vector<std::uint64_t> slab(tree.memory_bytes() / 8 + 1);
  for (const std::uint64_t step : {2u, 3u, 4u}) {
    tree.tick({.state = state,
               .step = step,
               .memory = reinterpret_cast<std::byte*>(slab.data()),
               .trace = &trace},
              out);
    if (step % 2 == 0)
      EXPECT_STREQ(trace.why(1), "an even step");
    else
      EXPECT_EQ(trace.why(1), nullptr);
    EXPECT_EQ(trace.why(0), nullptr) << "an arbiter has nothing to say for itself";
  }
}

TEST(Trace, TellsWhoWasNotAskedAndForgetsTheLastTick) {
  Robot robot(make<Selector<State, Action>>(probes(2)));
  robot.cue(1) = {kRunning, 2, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/probe[1]"));
  robot.cue(0) = {kRunning, 1, {.altitude = 3}};
  robot.tick();
  const auto& row = robot.row("root/probe[1]");
  EXPECT_FALSE(row.ticked);
  EXPECT_TRUE(row.proposal.is_empty());
  EXPECT_EQ(row.supplier[0], kNone);
}

/// Takes over what its child proposes, and throws in the first tick.
class Hasty final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "hasty";
  using Decorator<State, Action>::Decorator;
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const Status status = ask_child(t, out);
    if (t.step == 1)
      throw std::runtime_error("in a hurry");
    return status;
  }
};

TEST(Trace, ForgetsATickThatWasNotFinished) {
  Robot robot(make<Selector<State, Action>>(probe(0), make<Hasty>(probe(1))));
  robot.cue(1) = {kRunning, 2, {.heading = 1}};
  EXPECT_THROW(robot.tick(), std::runtime_error);
  robot.say(0, kSuccess, 1);
  robot.tick();
  for (const char* node : {"root/hasty", "root/hasty/probe"}) {
    EXPECT_FALSE(robot.row(node).ticked);
    EXPECT_TRUE(robot.row(node).proposal.is_empty());
    EXPECT_EQ(robot.row(node).supplier[0], kNone) << node;
  }
}

TEST(Trace, ShowsAFailingChildAsProposingNothing) {
  Robot robot(probe(0));
  robot.cue(0) = {kFailure, 9, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(robot.row("root").proposal.is_empty());
  EXPECT_EQ(robot.supplier(0), "");
}

TEST(Trace, FollowsEachFieldThroughMixedNodesToItsSupplier) {
  using Both = Parallel<State, Action>;
  Robot robot(make<PerField<State, Action>>(
      make<Sequence<State, Action>>(check(9), make<Wta>(probe(0), probe(1))),
      make<Fusion<State, Action>>(probe(2), make<Both>(probe(3), probe(4)))));
  robot.say(9, kSuccess);
  robot.cue(0) = {kRunning, 8, {.heading = 1}};
  robot.cue(1) = {kRunning, 9, {.heading = 2}};
  robot.cue(2) = {kRunning, 4, {.altitude = 100, .release = 1}};
  robot.cue(3) = {kRunning, 3, {.altitude = 200, .speed = 50}};
  robot.cue(4) = {kRunning, 2, {.heading = 3}};
  robot.tick();
  EXPECT_EQ(robot.supplier(0), "root/sequence/winner_takes_all/probe[1]");
  EXPECT_EQ(robot.supplier(1), "root/fusion") << "a blend of two";
  EXPECT_EQ(robot.supplier(2), "root/fusion/parallel/probe[0]");
  EXPECT_EQ(robot.supplier(3), "root/fusion/probe");
  EXPECT_EQ(robot.supplier(4), "");
}

TEST(Trace, CanBeReadByPeople) {
  auto navigate = probe(0);
  navigate->set_label("navigate");
  Robot robot(
      make<Selector<State, Action>>(check(5), make<Wta>(std::move(navigate), probe(1)), probe(2)));
  robot.cue(0) = {kRunning, 5, {.heading = radians(90), .release = 2}};
  robot.cue(1) = {kRunning, 1.5, {.speed = 100.0F}};
  robot.tick();
  EXPECT_EQ(to_text(robot.tree, robot.trace),
            "selector                         running 5: "
            "heading 090° (root/winner_takes_all/navigate), "
            "release 2 (root/winner_takes_all/navigate)\n"
            "  check                          failure\n"
            "  winner_takes_all               running 5: "
            "heading 090° (root/winner_takes_all/navigate), "
            "release 2 (root/winner_takes_all/navigate)\n"
            "    navigate                     running 5: heading 090°, release 2\n"
            "    probe                        running 1.5: speed 194 kt\n"
            "  probe                          -\n");
}

TEST(TraceDeathTest, MustBeMadeForTheTreesActionAndSize) {
  Robot robot(make<Wta>(probes(2)));
  Trace<Steer> other(robot.tree.size());
  RobotTrace small(2);
  RobotProposal out;
  Tick<State> tick{.state = robot.state, .memory = robot.slab.data(), .trace = &other};
  EXPECT_DEATH(robot.tree.tick(tick, out), "a trace of another action type");
  tick.trace = &small;
  EXPECT_DEATH(robot.tree.tick(tick, out), "a trace smaller than the tree");
}

}  // namespace
}  // namespace eyrie::ubf::testing
