// SPDX-License-Identifier: MIT
/// \file  Laws that hold for every tree, whatever nodes it is made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/no_allocation.hpp"
#include "support/ubf/registry.hpp"
#include "support/ubf/trees.hpp"

namespace eyrie::ubf::testing {
namespace {

constexpr std::uint64_t kTrees = 600;
constexpr int kTicks = 40;

/// One tick without a trace.
Status tick_blind(const Robot& robot, std::vector<std::byte>& slab, RobotProposal& out) {
  return robot.tree.tick({.state = robot.state,
                          .time = robot.time,
                          .dt = 0.1,
                          .step = robot.step,
                          .memory = slab.data()},
                         out);
}

const Probe* as_probe(const Robot& robot, std::size_t index) {
  return dynamic_cast<const Probe*>(&robot.tree.node(static_cast<NodeIndex>(index)));
}

TEST(EveryTree, TheTestTreesContainEveryStandardNode) {
  std::set<std::string_view> seen;
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    const Robot robot(Gardener(seed).tree());
    for (std::size_t i = 0; i < robot.tree.size(); ++i)
      seen.insert(robot.tree.node(static_cast<NodeIndex>(i)).type());
  }
  for (const NodeInfo& info : standard_registry().catalog())
    EXPECT_TRUE(seen.contains(info.name)) << info.name;
}

TEST(EveryTree, DecidesTheSameWithAndWithoutATrace) {
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    std::vector<std::byte> blind_slab(robot.slab.size());
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      robot.tick();
      RobotProposal blind;
      const Status status = tick_blind(robot, blind_slab, blind);
      ASSERT_EQ(status, robot.status) << "tree " << seed;
      ASSERT_EQ(blind.vote, robot.out.vote);
      ASSERT_TRUE(equal(blind.action, robot.out.action));
      ASSERT_EQ(blind_slab, robot.slab);
    }
  }
}

TEST(EveryTree, AnAgentCopiedInMidRunDecidesAsTheOriginal) {
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    std::vector<std::byte> copy;
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      if (i == kTicks / 2)
        copy = robot.slab;
      robot.tick();
      if (copy.empty())
        continue;
      RobotProposal out;
      ASSERT_EQ(tick_blind(robot, copy, out), robot.status) << "tree " << seed;
      ASSERT_TRUE(equal(out.action, robot.out.action));
      ASSERT_EQ(copy, robot.slab);
    }
  }
}

TEST(EveryTree, SendsUpOneValidVoteAndNothingAfterAFailure) {
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      robot.tick();
      ASSERT_TRUE(is_vote(robot.out.vote));
      ASSERT_TRUE(robot.status != kFailure || robot.out.is_empty()) << "tree " << seed;
    }
  }
}

/// A probe that goes on (answered running, was not halted) and is not asked in the next tick has
/// lost control: its memory is zero then. Nothing else ever zeroes it.
TEST(EveryTree, WhatLosesControlForgetsAndNothingElseDoes) {
  int losses = 0;
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    std::vector<bool> going(robot.tree.size());
    std::vector<std::uint32_t> remembered(robot.tree.size());
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      robot.tick();
      for (std::size_t n = 0; n < robot.tree.size(); ++n) {
        const Probe* probe = as_probe(robot, n);
        if (!probe)
          continue;
        const auto& row = robot.trace.row(static_cast<NodeIndex>(n));
        const bool lost = going[n] && !row.ticked;
        losses += lost;
        ASSERT_GE(row.halts, lost ? 1 : 0)
            << "tree " << seed << ": " << robot.tree.path(probe->index());
        remembered[n] = row.halts ? 0 : remembered[n] + row.ticked;
        ASSERT_EQ(probe->asked(robot.slab.data()), remembered[n]) << "tree " << seed;
        going[n] = row.ticked && row.status == kRunning && !row.halts;
      }
    }
  }
  EXPECT_GT(losses, 1000) << "otherwise this test tests nothing";
}

/// Without nodes that blend, each field of the decision is found unchanged in the leaf that the
/// trace names as its supplier.
TEST(EveryTree, TheTraceNamesTheLeafThatSuppliedEachField) {
  int checked = 0;
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed, false).tree());
    Weather weather(seed);
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      robot.tick();
      for_each_field<Action>([&](const auto& f, auto field) {
        const NodeIndex supplier = robot.trace.row(0).supplier[field];
        const auto& value = robot.out.action.*f.member;
        ASSERT_EQ(value.has_value(), supplier != kNone) << "tree " << seed;
        if (!value)
          return;
        const Probe* probe = as_probe(robot, supplier);
        ASSERT_TRUE(probe) << "tree " << seed << ": " << robot.tree.path(supplier);
        ASSERT_TRUE(robot.trace.row(supplier).ticked);
        ASSERT_EQ(value, robot.state.cues[probe->cue].action.*f.member);
        ++checked;
      });
    }
  }
  EXPECT_GT(checked, 1000) << "otherwise this test tests nothing";
}

TEST(EveryTree, AllocatesNothingPerTickWithOrWithoutATrace) {
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    Robot robot(Gardener(seed).tree());
    Weather weather(seed);
    std::vector<std::byte> slab(robot.slab.size());
    RobotProposal out;
    const NoAllocation guard;
    for (int i = 0; i < kTicks; ++i) {
      weather.blow(robot.state);
      robot.tick();
      tick_blind(robot, slab, out);
    }
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
