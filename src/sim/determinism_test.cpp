// SPDX-License-Identifier: MIT
/// \file  The promise of the kernel: the same world and orders give the same bytes, whatever the
/// number of workers and wherever the run was saved, restored or branched.
#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <map>
#include <vector>

#include "sim/difference.hpp"
#include "sim/swarm_test.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::sim {
namespace {

using swarm::fly;
using swarm::Happening;
using swarm::Swarm;

/// A run of `birds` birds: the hash after every step, and every event.
struct Story {
  std::vector<std::uint64_t> hashes;
  std::vector<Event> events;
};

Story tell(const Swarm& swarm, std::uint32_t birds, unsigned workers, int steps) {
  Story story;
  World world = swarm.world(birds);
  Workspace work(*swarm.simulation, workers);
  for (int i = 0; i < steps; ++i) {
    const auto events = swarm.simulation->step(world, work);
    story.events.insert(story.events.end(), events.begin(), events.end());
    story.hashes.push_back(world.hash());
  }
  return story;
}

std::map<std::uint16_t, int> count(const std::vector<Event>& events) {
  std::map<std::uint16_t, int> counts;
  for (const Event& event : events)
    ++counts[event.kind.value];
  return counts;
}

/// Row counts on both sides of the borders of chunks.
class Workers : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Workers, NeverChangeAResult) {
  const Swarm swarm;
  const int steps = 150;
  const Story alone = tell(swarm, GetParam(), 1, steps);
  for (const unsigned workers : {2u, 3u, 7u}) {
    const Story many = tell(swarm, GetParam(), workers, steps);
    EXPECT_EQ(many.hashes, alone.hashes) << workers << " workers";
    EXPECT_EQ(first_difference(0, alone.events, many.events), std::nullopt)
        << workers << " workers";
  }
}

INSTANTIATE_TEST_SUITE_P(OfRows, Workers, testing::Values(1u, 255u, 256u, 257u, 1000u));

TEST(Swarm, DoesEverythingThatTheTestsRelyOn) {
  const Swarm swarm;
  auto counts = count(tell(swarm, 257, 1, 150).events);
  for (const Happening kind :
       {Happening::shot, Happening::hit, Happening::kill, Happening::hatched})
    EXPECT_GT(counts[static_cast<std::uint16_t>(kind)], 10) << static_cast<int>(kind);
}

TEST(Swarm, FillsItsTableOfPellets) {
  const Swarm swarm(300, 50);
  World world = swarm.world(257);
  fly(swarm, world, 100);
  EXPECT_GT(world.refused_births(), 0u);
  EXPECT_TRUE(world.canonical());
}

/// The bits of a long run, as every compiler and optimisation level must give them. They change
/// only with the swarm itself, the draws, or what World::hash() covers: then say so in the commit.
TEST(Determinism, HoldsAcrossCompilers) {
  const Swarm swarm;
  World world = swarm.world(257, 2026);
  fly(swarm, world, 120);
  EXPECT_EQ(world.rows(swarm.keys.birds), 87u);
  EXPECT_EQ(world.hash(), 0x1b4e4cbcf4b4e353u);
}

TEST(Determinism, HoldsWhenATableOverflows) {
  const Swarm swarm(300, 50);
  EXPECT_EQ(tell(swarm, 290, 1, 100).hashes, tell(swarm, 290, 3, 100).hashes);
}

TEST(Determinism, DependsOnTheSeed) {
  const Swarm swarm;
  World one = swarm.world(100, 1);
  World two = swarm.world(100, 2);
  fly(swarm, one, 20);
  fly(swarm, two, 20);
  EXPECT_NE(one.hash(), two.hash());
}

TEST(Snapshot, IsACopyAndARollbackAnAssignment) {
  const Swarm swarm;
  World world = swarm.world(300);
  fly(swarm, world, 40);
  const World kept = world;
  fly(swarm, world, 60);
  const std::uint64_t end = world.hash();

  world = kept;
  EXPECT_EQ(world.step(), 40u);
  fly(swarm, world, 60, 3);
  EXPECT_EQ(world.hash(), end);
}

TEST(Snapshot, BranchesIntoRunsThatDoNotTouchEachOther) {
  const Swarm swarm;
  World trunk = swarm.world(300);
  fly(swarm, trunk, 40);
  World branch = trunk;
  branch.rows(swarm.keys.body)[0].velocity.x += 100;
  fly(swarm, branch, 30);

  World same = swarm.world(300);
  fly(swarm, same, 70);
  fly(swarm, trunk, 30);
  EXPECT_EQ(trunk.hash(), same.hash());
  EXPECT_NE(branch.hash(), trunk.hash());
}

TEST(Workspace, KeepsNothingBetweenWorlds) {
  const Swarm swarm;
  Workspace work(*swarm.simulation);
  World one = swarm.world(300, 1);
  World two = swarm.world(50, 2);
  for (int i = 0; i < 50; ++i) {
    swarm.simulation->step(one, work);
    swarm.simulation->step(two, work);
  }
  World alone = swarm.world(50, 2);
  fly(swarm, alone, 50);
  EXPECT_EQ(two.hash(), alone.hash());
}

TEST(Step, MakesOfSeveralWorldsTogetherWhatItMakesOfEachAlone) {
  const Swarm swarm;
  const std::vector<std::uint32_t> birds = {1, 50, 257, 0, 50, 7};
  std::vector<World> worlds, alone;
  std::deque<Workspace> works;
  for (std::size_t i = 0; i < birds.size(); ++i) {
    worlds.push_back(swarm.world(birds[i], i));
    fly(swarm, worlds.back(), static_cast<int>(i));  // each is in a step of its own
    works.emplace_back(*swarm.simulation);
  }
  alone = worlds;
  works[4].check_writes(worlds[4]);
  Workspace work(*swarm.simulation);
  for (int step = 0; step < 100; ++step) {
    std::vector<Stepped> all;
    for (std::size_t i = 0; i < birds.size(); ++i)
      all.push_back({&worlds[i], &works[i]});
    swarm.simulation->step(all);
    for (std::size_t i = 0; i < birds.size(); ++i) {
      const auto events = swarm.simulation->step(alone[i], work);
      ASSERT_EQ(worlds[i].hash(), alone[i].hash()) << i << " in step " << step;
      ASSERT_EQ(first_difference(0, events, works[i].events()), std::nullopt) << i;
    }
  }
}

TEST(Step, AllocatesNothingOnceItIsWarm) {
  const Swarm swarm;
  for (const unsigned workers : {1u, 3u}) {
    World world = swarm.world(1000);
    const World start = world;
    Workspace work(*swarm.simulation, workers);
    const auto fly_on = [&] {
      for (int i = 0; i < 60; ++i)
        swarm.simulation->step(world, work);
    };
    fly_on();
    world = start;
    NoAllocation guard(NoAllocation::Scope::process);
    fly_on();
    EXPECT_EQ(guard.count(), 0u);
  }
}

TEST(Step, AllocatesNothingAtAllWhenTheRoomSuffices) {
  const Swarm swarm;
  World world = swarm.world(20);
  Workspace work(*swarm.simulation);
  NoAllocation guard;
  for (int i = 0; i < 60; ++i)
    swarm.simulation->step(world, work);
}

}  // namespace
}  // namespace eyrie::sim
