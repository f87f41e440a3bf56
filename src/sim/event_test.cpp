// SPDX-License-Identifier: MIT
#include "sim/event.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "sim/run.hpp"
#include "sim/swarm_rows_test.hpp"
#include "sim/swarm_test.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::sim {
namespace {

using swarm::Vitals;

constexpr std::uint32_t kFlock = 1000;  // four chunks

/// Counts a hit of everybody in each step; from a step on the players that it is given fail.
class Fails final : public System {
 public:
  Fails(const swarm::Keys& keys, std::vector<std::uint32_t> players, std::uint64_t from)
      : keys_(keys), players_(std::move(players)), from_(from) {}
  std::string_view name() const override { return "fails"; }
  TableId table() const override { return keys_.birds; }
  void move(World& world, const StepInfo& info, Chunk chunk, Outbox& out) const override {
    for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
      const PlayerId who = world.ids(keys_.birds)[row];
      ++world.rows(keys_.vitals)[row].hits;
      if (info.step >= from_ &&
          std::find(players_.begin(), players_.end(), who.value) != players_.end())
        out.fail({.player = who, .what = "is " + std::to_string(who.value)});
    }
  }

 private:
  swarm::Keys keys_;
  std::vector<std::uint32_t> players_;
  std::uint64_t from_;
};

/// Keeps the hash of every world that it is shown.
class Hashes final : public Observer {
 public:
  void observe(const World& world, const StepInfo&, std::span<const Event>) override {
    seen.push_back(world.hash());
  }
  void finish(const World& world) override { last = world.hash(); }
  std::vector<std::uint64_t> seen;
  std::uint64_t last = 0;
};

TEST(FaultInAStep, IsTheFirstByRowForAnyNumberOfWorkers) {
  swarm::Keys keys;
  SchemaBuilder schema;
  keys.birds = schema.add_table("bird", kFlock);
  keys.vitals = schema.add_column<Vitals>(keys.birds, "vitals");
  SimulationBuilder builder(schema.build());
  builder.add<Fails>(keys, std::vector<std::uint32_t>{999, 700, 301, 620}, 60);
  const auto simulation = builder.build();
  World world = simulation->world(1);
  for (std::uint32_t i = 0; i < kFlock; ++i)
    ASSERT_TRUE(world.spawn(keys.birds));

  for (const unsigned workers : {1U, 2U, 3U, 7U}) {
    sim::Run run(simulation, world, {.workers = workers});
    Hashes hashes;
    run.attach(hashes);
    while (!run.fault() && run.world().step() < 100)
      run.step();
    run.finish();
    ASSERT_TRUE(run.fault());
    EXPECT_EQ(run.fault()->player, PlayerId{301});
    EXPECT_EQ(run.fault()->what, "is 301");
    EXPECT_EQ(run.fault()->system, "fails");
    EXPECT_EQ(run.fault()->step, 60U);
    // nobody saw the step, and the world is that of the last whole one
    EXPECT_EQ(hashes.seen.size(), 60U);
    EXPECT_EQ(run.world().step(), 60U);
    EXPECT_EQ(hashes.last, hashes.seen.back());
    EXPECT_EQ(run.world().rows(keys.vitals)[0].hits, 60U);
    EXPECT_TRUE(run.step().empty()) << "it is over";
    // unless somebody says so
    run.forgive();
    EXPECT_FALSE(run.fault());
    EXPECT_EQ(run.world().hash(), hashes.last);
    run.step();
    ASSERT_TRUE(run.fault()) << "it is made again";
    EXPECT_EQ(run.fault()->what, "is 301");
    EXPECT_EQ(run.world().hash(), hashes.last);
  }
}

TEST(FaultInAStep, IsThatOfOneAmongWorldsSteppedTogether) {
  swarm::Keys keys;
  SchemaBuilder schema;
  keys.birds = schema.add_table("bird", 10);
  keys.vitals = schema.add_column<Vitals>(keys.birds, "vitals");
  SimulationBuilder builder(schema.build());
  builder.add<Fails>(keys, std::vector<std::uint32_t>{3}, 5);
  builder.add<Fails>(keys, std::vector<std::uint32_t>{}, 0);
  const auto simulation = builder.build();
  std::vector<World> worlds(3, simulation->world(1));
  std::deque<Workspace> works;
  for (std::uint32_t i = 0; i < worlds.size(); ++i) {
    for (std::uint32_t bird = 0; bird < 1 + 2 * (i % 2); ++bird)
      ASSERT_TRUE(worlds[i].spawn(keys.birds));
    works.emplace_back(*simulation);
  }
  for (int step = 0; step < 6; ++step) {
    std::vector<Stepped> all;
    for (std::size_t i = 0; i < worlds.size(); ++i)
      all.push_back({&worlds[i], &works[i]});
    simulation->step(all);
  }
  for (const std::size_t whole : {0, 2}) {
    EXPECT_FALSE(works[whole].fault());
    EXPECT_EQ(worlds[whole].step(), 6U);
    EXPECT_EQ(worlds[whole].rows(keys.vitals)[0].hits, 12U);
  }
  ASSERT_TRUE(works[1].fault());
  EXPECT_EQ(works[1].fault()->what, "is 3");
  EXPECT_EQ(works[1].fault()->step, 5U);
  EXPECT_EQ(worlds[1].step(), 5U);
  EXPECT_EQ(worlds[1].rows(keys.vitals)[0].hits, 11U) << "the system behind it does nothing";
}

TEST(Outbox, AllocatesNothingWithinItsRoom) {
  Outbox outbox(8);
  NoAllocation guard;
  for (std::uint32_t i = 0; i < 8; ++i)
    outbox.emit({.detail = i});
  EXPECT_EQ(outbox.events().size(), 8u);
}

TEST(Outbox, NeverDropsAnEventAndKeepsTheRoomThatWasNeededOnce) {
  Outbox outbox(4);
  for (std::uint32_t i = 0; i < 1000; ++i)
    outbox.emit({.detail = i});
  ASSERT_EQ(outbox.events().size(), 1000u);
  for (std::uint32_t i = 0; i < 1000; ++i)
    EXPECT_EQ(outbox.events()[i].detail, i);

  outbox.clear();
  NoAllocation guard;
  for (std::uint32_t i = 0; i < 1000; ++i)
    outbox.emit({.detail = i});
  EXPECT_EQ(outbox.events().size(), 1000u);
}

TEST(Kind, ConvertsFromAndToTheEnumerationOfADomain) {
  const Event event{.kind = swarm::Happening::kill};
  EXPECT_TRUE(event.kind == swarm::Happening::kill);
  EXPECT_FALSE(event.kind == swarm::Happening::hit);
  EXPECT_EQ(event.kind.as<swarm::Happening>(), swarm::Happening::kill);
  EXPECT_TRUE(event.kind);
  EXPECT_FALSE(Event{}.kind);
}

TEST(Order, CarriesItsPayloadUnchanged) {
  const swarm::Turn turn{.velocity = {1, -2.5, 1e300}};
  const Order order = order_for(7, PlayerId{3}, swarm::Wish::turn, turn);
  EXPECT_EQ(order.step, 7u);
  EXPECT_EQ(order.player, PlayerId{3});
  EXPECT_TRUE(order.kind == swarm::Wish::turn);
  EXPECT_EQ(order.as<swarm::Turn>().velocity, turn.velocity);
}

}  // namespace
}  // namespace eyrie::sim
