// SPDX-License-Identifier: MIT
#include "ubf/behavior.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

/// Recommends an altitude by lot.
class Gambler final : public Node {
 public:
  static constexpr std::string_view type_name = "gambler";
  Status tick(const RobotTick& t, RobotProposal& out) const override {
    Draw lot = draw(t);
    out.action.altitude = lot.uniform();
    out.action.heading = lot.uniform();
    out.vote = 1;
    return Status::running;
  }
};

TEST(Vote, IsFiniteAndNotNegative) {
  EXPECT_TRUE(is_vote(0));
  EXPECT_TRUE(is_vote(1e30F));
  EXPECT_FALSE(is_vote(-1e-9F));
  EXPECT_FALSE(is_vote(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(is_vote(std::numeric_limits<float>::infinity()));
}

TEST(Proposal, IsEmptyOnlyWithoutVoteAndFields) {
  EXPECT_TRUE(RobotProposal{}.is_empty());
  EXPECT_FALSE((RobotProposal{{}, 1}.is_empty()));
  EXPECT_FALSE((RobotProposal{{.mode = 0}, 0}.is_empty()));
}

TEST(Condition, SucceedsOrFailsAndRecommendsNothing) {
  Robot robot(check(0));
  EXPECT_EQ(robot.tick(), kFailure);
  robot.say(0, kSuccess, 9);
  robot.cue(0).action.heading = 1;
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Behavior, IsCalledByItsTypeUnlessItHasALabel) {
  const Child node = probe(0);
  EXPECT_EQ(node->label(), "probe");
  node->set_label("left wing");
  EXPECT_EQ(node->label(), "left wing");
  EXPECT_EQ(node->type(), "probe");
}

TEST(Behavior, DrawsAreAFunctionOfSeedPlayerStepAndNode) {
  const RobotTree tree("dice", make<Parallel<State, Action>>(make<Gambler>(), make<Gambler>()));
  const State state;
  const auto drawn = [&](std::uint64_t seed, std::uint32_t player, std::uint64_t step,
                         NodeIndex node) {
    RobotTrace trace(tree.size());
    RobotProposal out;
    tree.tick({.state = state, .step = step, .seed = seed, .player = {player}, .trace = &trace},
              out);
    return *trace.row(node).proposal.action.altitude;
  };
  const double value = drawn(1, 2, 3, 1);
  EXPECT_EQ(drawn(1, 2, 3, 1), value);
  EXPECT_NE(drawn(2, 2, 3, 1), value);
  EXPECT_NE(drawn(1, 3, 3, 1), value);
  EXPECT_NE(drawn(1, 2, 4, 1), value);
  EXPECT_NE(drawn(1, 2, 3, 2), value);
}

TEST(Behavior, TellsItsParametersThatHaveAValueAsAFileWouldWriteThem) {
  const auto told = [](const Node& node) {
    std::string text;
    for (const ParamValue& param : node.values())
      text += (text.empty() ? "" : ", ") + param.name + " " + param.text;
    return text;
  };
  auto fusion = make<Fusion<State, Action>>(probe(0));
  fusion->top = 2;
  fusion->vote = 7;
  EXPECT_EQ(told(*fusion), "top 2, conflicts blend, vote 7, vote_scale 1");
  auto ranks = make<Priority<State, Action>>(probes(2));
  ranks->interruptible = {true, false};
  EXPECT_EQ(told(*ranks), "interruptible [true, false], vote_scale 1");
  auto verify = make<Verify<State, Action>>(probe(0));
  EXPECT_EQ(verify->bounds.set("altitude", 3048, {}), "");
  EXPECT_EQ(told(*verify), "bounds.altitude.min 10000 ft, fallback false, vote_scale 1");
  auto grid = make<VoteGrid<State, Action>>(probe(0));
  EXPECT_EQ(grid->grid.add("altitude", 0, 100, 3, 50), "");
  EXPECT_EQ(told(*grid),
            "grid.altitude.from 0 m, grid.altitude.to 100 m, grid.altitude.steps 3, "
            "grid.altitude.reach 50 m, grid.altitude.spread 0 m, vote_scale 1");
  EXPECT_EQ(told(*probe(3)), "cue 3, bias 0");
}

}  // namespace
}  // namespace eyrie::ubf::testing
