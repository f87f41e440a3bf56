// SPDX-License-Identifier: MIT
#include "ubf/agent.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using RobotTrees = Trees<State, Action>;
using RobotBrain = Brain<64>;

RobotTrees two_trees() {
  RobotTrees trees;
  trees.add(RobotTree("one", probe(0)));
  trees.add(RobotTree("many", make<WinnerTakesAll<State, Action>>(probes(4))));
  return trees;
}

bool is_fresh(const RobotBrain& brain) {
  return std::all_of(brain.memory.begin(), brain.memory.end(),
                     [](std::byte byte) { return byte == std::byte{0}; });
}

TEST(Trees, AreFoundByNameAndKnowTheLargest) {
  const RobotTrees trees = two_trees();
  EXPECT_EQ(trees.size(), 2u);
  EXPECT_EQ(trees.find("many"), 1);
  EXPECT_EQ(trees.find("few"), std::nullopt);
  EXPECT_EQ(trees[0].name(), "one");
  EXPECT_EQ(trees.max_memory(), trees[1].memory_bytes());
  EXPECT_EQ(trees.max_size(), 5u);
}

TEST(Trees, RefuseANameThatIsTaken) {
  RobotTrees trees = two_trees();
  EXPECT_THROW(trees.add(RobotTree("one", probe(1))), std::logic_error);
}

TEST(Brain, IsPlainBytesWithoutPadding) {
  static_assert(NoPadding<RobotBrain>);
  static_assert(sizeof(RobotBrain) == 72);
  EXPECT_TRUE(is_fresh({}));
}

TEST(Agent, DecidesWithItsTreeAndItsMemory) {
  const RobotTrees trees = two_trees();
  RobotBrain brain;
  State state;
  state.cues[0] = {kRunning, 2, {.heading = 1}};
  RobotProposal out;
  EXPECT_EQ(tick_agent(trees, brain, Tick<State>{.state = state}, out), kRunning);
  EXPECT_EQ(out.action.heading, 1);
  EXPECT_FALSE(is_fresh(brain));
}

TEST(Agent, BeginsASwappedTreeWithNothingRemembered) {
  const RobotTrees trees = two_trees();
  RobotBrain brain;
  const State state;
  RobotProposal out;
  tick_agent(trees, brain, Tick<State>{.state = state}, out);
  swap_tree(brain, 1);
  EXPECT_EQ(brain.tree, 1);
  EXPECT_TRUE(is_fresh(brain));
  tick_agent(trees, brain, Tick<State>{.state = state}, out);
  const auto& last = static_cast<const Probe&>(trees[1].node(4));
  EXPECT_EQ(last.asked(brain.memory.data()), 1u);
}

TEST(Agent, SwappedToTheTreeItUsesStartsAnew) {
  const RobotTrees trees = two_trees();
  RobotBrain brain;
  const State state;
  RobotProposal out;
  tick_agent(trees, brain, Tick<State>{.state = state}, out);
  swap_tree(brain, 0);
  EXPECT_TRUE(is_fresh(brain));
}

TEST(TickAgentDeathTest, DemandsABrainThatIsLargeEnough) {
  const RobotTrees trees = two_trees();
  Brain<8> small{.tree = 1};
  RobotProposal out;
  EXPECT_DEATH(static_cast<void>(tick_agent(trees, small, RobotTick{.state = State{}}, out)),
               "smaller than the memory");
}

}  // namespace
}  // namespace eyrie::ubf::testing
