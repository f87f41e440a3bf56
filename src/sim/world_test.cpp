// SPDX-License-Identifier: MIT
#include "sim/world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>
#include <vector>

#include "sim/swarm_test.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::sim {
namespace {

using swarm::Body;
using swarm::Swarm;

std::vector<std::uint32_t> ids_of(const World& world, TableId table) {
  std::vector<std::uint32_t> out;
  for (const PlayerId id : world.ids(table))
    out.push_back(id.value);
  return out;
}

TEST(World, GivesIdsInSpawnOrderAcrossTables) {
  const Swarm swarm;
  World world = swarm.simulation->world(7);
  EXPECT_EQ(world.spawn(swarm.keys.birds)->id, PlayerId{1});
  EXPECT_EQ(world.spawn(swarm.keys.pellets)->id, PlayerId{2});
  const auto third = world.spawn(swarm.keys.birds);
  EXPECT_EQ(third->id, PlayerId{3});
  EXPECT_EQ(third->row, 1u);
  EXPECT_EQ(ids_of(world, swarm.keys.birds), (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(world.next_id(), PlayerId{4});
  EXPECT_EQ(world.seed(), 7u);
  EXPECT_TRUE(world.canonical());
}

TEST(World, FindsAPlayerInWhateverTableItIs) {
  const Swarm swarm;
  World world = swarm.world(5);
  const auto pellet = world.spawn(swarm.keys.pellets);
  EXPECT_EQ(world.find(pellet->id), (RowRef{swarm.keys.pellets, 0}));
  EXPECT_EQ(world.find(PlayerId{4}), (RowRef{swarm.keys.birds, 3}));
  EXPECT_EQ(world.row(swarm.keys.birds, pellet->id), std::nullopt);
  EXPECT_EQ(world.find(PlayerId{}), std::nullopt);
  EXPECT_EQ(world.find(PlayerId{99}), std::nullopt);
}

TEST(World, RefusesABirthWhenTheTableIsFullAndCountsIt) {
  const Swarm swarm(3, 1);
  World world = swarm.world(3);
  const std::uint64_t before = world.hash();
  EXPECT_EQ(world.spawn(swarm.keys.birds), std::nullopt);
  EXPECT_EQ(world.refused_births(), 1u);
  EXPECT_EQ(world.next_id(), PlayerId{4});
  EXPECT_EQ(world.rows(swarm.keys.birds), 3u);
  EXPECT_NE(world.hash(), before) << "a refused birth is part of what happened";
}

TEST(World, RemovesMarkedRowsOnlyWhenItIsCompacted) {
  const Swarm swarm;
  World world = swarm.world(6);
  world.remove(swarm.keys.birds, 1);
  world.remove(swarm.keys.birds, 4);
  world.remove(swarm.keys.birds, 4);
  EXPECT_EQ(world.rows(swarm.keys.birds), 6u);
  EXPECT_FALSE(world.canonical());

  const double x = std::as_const(world).rows(swarm.keys.body)[5].position.x;
  world.compact();
  EXPECT_EQ(ids_of(world, swarm.keys.birds), (std::vector<std::uint32_t>{1, 3, 4, 6}));
  EXPECT_EQ(world.rows(swarm.keys.body)[3].position.x, x);
  EXPECT_EQ(world.find(PlayerId{5}), std::nullopt);
  EXPECT_TRUE(world.canonical()) << "freed rows are zero again";
}

TEST(World, NeverReusesAnId) {
  const Swarm swarm(2, 1);
  World world = swarm.world(2);
  world.remove(swarm.keys.birds, 1);
  world.compact();
  EXPECT_EQ(world.spawn(swarm.keys.birds)->id, PlayerId{3});
}

TEST(World, SpawnsRowsOfZeros) {
  const Swarm swarm(2, 1);
  World world = swarm.world(2);
  world.bytes(swarm.keys.brain, 1)[3] = std::byte{9};
  world.remove(swarm.keys.birds, 1);
  world.compact();
  const auto born = world.spawn(swarm.keys.birds);
  EXPECT_EQ(world.rows(swarm.keys.body)[born->row].position, Vec3{});
  EXPECT_EQ(world.bytes(swarm.keys.brain, born->row)[3], std::byte{0});
}

/// Random births and deaths against the simplest model of them: a list per table.
RC_GTEST_PROP(World, KeepsSpawnOrderThroughBirthsAndDeaths, ()) {
  const Swarm swarm(40, 20);
  World world = swarm.simulation->world(1);
  World follower = world;
  const auto follow = [&] {
    NoAllocation guard;
    follower.become(world);
    return follower.same_bytes(world);
  };
  const std::array tables{swarm.keys.birds, swarm.keys.pellets};
  std::array<std::vector<std::uint32_t>, 2> model;
  std::uint32_t next = 1;
  const auto rounds = *rc::gen::inRange(1, 30);
  for (int round = 0; round < rounds; ++round) {
    const auto births = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 2));
    for (const int t : births)
      if (world.spawn(tables[t]))
        model[t].push_back(next++);
    RC_ASSERT(follow());
    for (int t = 0; t < 2; ++t) {
      std::vector<std::uint32_t> left;
      for (std::uint32_t row = 0; row < model[t].size(); ++row)
        if (*rc::gen::inRange(0, 3) == 0)
          world.remove(tables[t], row);
        else
          left.push_back(model[t][row]);
      model[t] = left;
    }
    if (*rc::gen::arbitrary<bool>())
      RC_ASSERT(follow());  // also the marks
    world.compact();
    RC_ASSERT(follow());
    RC_ASSERT(world.canonical());
    RC_ASSERT(ids_of(world, tables[0]) == model[0]);
    RC_ASSERT(ids_of(world, tables[1]) == model[1]);
  }
}

TEST(World, IsAValue) {
  const Swarm swarm;
  World world = swarm.world(100);
  const World kept = world;
  EXPECT_TRUE(world.same_bytes(kept));
  EXPECT_EQ(world.hash(), kept.hash());

  world.rows(swarm.keys.body)[42].velocity.y += 1;
  EXPECT_FALSE(world.same_bytes(kept));
  EXPECT_NE(world.hash(), kept.hash());

  world = kept;
  EXPECT_EQ(world.hash(), kept.hash());
}

TEST(World, CopiesOverAnotherWithoutAllocating) {
  const Swarm swarm;
  World world = swarm.world(100);
  World other = swarm.world(900, 3);
  const Body* where = world.rows(swarm.keys.body).data();
  {
    NoAllocation guard;
    world = other;
  }
  EXPECT_EQ(world.rows(swarm.keys.body).data(), where) << "spans into a world stay good";
  EXPECT_TRUE(world.same_bytes(other));
}

TEST(World, TakesOverAWorldOfAnotherSchema) {
  const Swarm small(3, 3);
  const Swarm large;
  World world = small.world(3);
  const World other = large.world(30);
  World become = world;
  world = other;
  become.become(other);
  for (const World* taken : {&world, &become}) {
    EXPECT_EQ(&taken->schema(), &other.schema());
    EXPECT_TRUE(taken->same_bytes(other));
  }
}

TEST(World, HashesTheSameWhateverItsCapacity) {
  const Swarm small(10, 1);
  const Swarm large(1000, 1000);
  EXPECT_EQ(small.world(10).hash(), large.world(10).hash());
}

TEST(World, MovesToASchemaWithOtherCapacities) {
  const Swarm tight(5, 5), roomy(50, 20), small(4, 20);
  const World world = tight.world(5);
  const auto moved = world.moved_to(roomy.simulation->shared_schema());
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->hash(), world.hash());
  EXPECT_TRUE(moved->canonical());
  EXPECT_FALSE(world.moved_to(small.simulation->shared_schema())) << "five birds, room for four";
  SchemaBuilder other;
  other.add_table("bird", 50);
  EXPECT_FALSE(world.moved_to(other.build()));
}

TEST(World, MovesToASchemaInWhichSomebodyRemembersMore) {
  const auto schema = [](std::uint32_t bytes, std::string_view name) {
    SchemaBuilder builder;
    const TableId table = builder.add_table("bird", 5);
    static_cast<void>(builder.add_bytes(table, name, bytes));
    static_cast<void>(builder.add_bytes(table, "nest", 8));
    return builder.build();
  };
  World world(schema(8, "brain"), 1);
  const TableId table{1};
  ASSERT_TRUE(world.spawn(table));
  for (const std::uint32_t column : {2u, 3u})
    std::ranges::fill(world.bytes(ByteColumn{column}, 0), std::byte{7});
  const auto moved = world.moved_to(schema(16, "brain"));
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->rows(table), 1u);
  EXPECT_EQ(moved->bytes(ByteColumn{2}, 0)[0], std::byte{0}) << "of another size";
  EXPECT_EQ(moved->bytes(ByteColumn{3}, 0)[0], std::byte{7});
  EXPECT_TRUE(moved->canonical());
  EXPECT_FALSE(world.moved_to(schema(16, "mind")));
}

TEST(World, HashesTheSeedTheStepAndEveryByteOfALiveRow) {
  const Swarm swarm(4, 4);
  World world = swarm.world(3);
  (void)world.spawn(swarm.keys.pellets);
  const std::uint64_t hash = world.hash();
  EXPECT_NE(swarm.world(3, 2).hash(), swarm.world(3, 1).hash());
  for (std::size_t row = 0; row < 3; ++row)
    for (std::byte& byte : world.bytes(swarm.keys.brain, row)) {
      byte ^= std::byte{1};
      EXPECT_NE(world.hash(), hash);
      byte ^= std::byte{1};
    }
  const auto body = std::as_writable_bytes(world.rows(swarm.keys.pellet_body));
  for (std::byte& byte : body) {
    byte ^= std::byte{0x80};
    EXPECT_NE(world.hash(), hash);
    byte ^= std::byte{0x80};
  }
  EXPECT_EQ(world.hash(), hash);
}

TEST(World, NoticesWritesBeyondItsRows) {
  const Swarm swarm;
  World world = swarm.world(3);
  Body* beyond = world.rows(swarm.keys.body).data() + 3;
  beyond->position.x = 1;
  EXPECT_FALSE(world.canonical());
}

}  // namespace
}  // namespace eyrie::sim
