// SPDX-License-Identifier: MIT
#include "sim/simulation.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Happening;
using swarm::Swarm;
using swarm::Vitals;

/// A world of birds without systems; tests add their own.
struct Bare {
  swarm::Keys keys;
  SimulationBuilder builder;

  explicit Bare(std::uint32_t birds = 1000) : builder(schema(keys, birds)) {}
  static std::shared_ptr<const Schema> schema(swarm::Keys& keys, std::uint32_t birds) {
    SchemaBuilder builder;
    keys.birds = builder.add_table("bird", birds);
    keys.vitals = builder.add_column<Vitals>(keys.birds, "vitals");
    return builder.build();
  }
};

/// Says in which phase, system and row it is, twice per row.
class Chatter : public System {
 public:
  Chatter(const swarm::Keys& keys, std::uint16_t number) : keys_(keys), number_(number) {}
  std::string_view name() const override { return "chatter"; }
  TableId table() const override { return keys_.birds; }

 protected:
  void say(Phase phase, const World& world, Chunk chunk, Outbox& out) const {
    for (std::size_t row = chunk.begin; row < chunk.end; ++row)
      for (const float repeat : {0.0f, 1.0f})
        out.emit({.kind = EventKind(static_cast<std::uint16_t>(phase)),
                  .aux = number_,
                  .who = world.ids(keys_.birds)[row],
                  .values = {repeat}});
  }
  swarm::Keys keys_;
  std::uint16_t number_;
};

class EarlyChatter final : public Chatter {
 public:
  using Chatter::Chatter;
  void perceive(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::perceive, w, c, out);
  }
  void act(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::act, w, c, out);
  }
};

class LateChatter final : public Chatter {
 public:
  using Chatter::Chatter;
  void decide(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::decide, w, c, out);
  }
  void act(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::act, w, c, out);
  }
  void move(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::move, w, c, out);
  }
  void interact(World& w, const StepInfo&, Chunk c, Outbox& out) const override {
    say(Phase::interact, w, c, out);
  }
};

TEST(Step, OrdersEventsByPhaseSystemRowAndEmission) {
  for (const unsigned workers : {1u, 3u}) {
    Bare bare;
    bare.builder.add<EarlyChatter>(bare.keys, std::uint16_t{1});
    bare.builder.add<LateChatter>(bare.keys, std::uint16_t{2});
    const auto simulation = bare.builder.build();
    World world = simulation->world(1);
    constexpr std::uint32_t kBirds = 600;  // three chunks
    for (std::uint32_t i = 0; i < kBirds; ++i)
      (void)world.spawn(bare.keys.birds);
    Workspace work(*simulation, workers);

    const std::vector<std::pair<Phase, std::uint16_t>> expected{
        {Phase::perceive, 1}, {Phase::decide, 2}, {Phase::act, 1},
        {Phase::act, 2},      {Phase::move, 2},   {Phase::interact, 2}};
    const auto events = simulation->step(world, work);
    ASSERT_EQ(events.size(), expected.size() * kBirds * 2);
    std::size_t i = 0;
    for (const auto& [phase, number] : expected)
      for (std::uint32_t row = 0; row < kBirds; ++row)
        for (const float repeat : {0.0f, 1.0f}) {
          const Event& event = events[i++];
          ASSERT_EQ(event.kind.value, static_cast<std::uint16_t>(phase)) << "event " << i - 1;
          ASSERT_EQ(event.aux, number);
          ASSERT_EQ(event.who, PlayerId{row + 1});
          ASSERT_EQ(event.values[0], repeat);
        }
  }
}

TEST(Step, KnowsTheTimeAtItsBeginning) {
  class Clock final : public System {
   public:
    explicit Clock(TableId table) : table_(table) {}
    std::string_view name() const override { return "clock"; }
    TableId table() const override { return table_; }
    void commit(World& world, const StepInfo& info, std::span<const Event>,
                CommitContext& context) const override {
      EXPECT_EQ(world.step(), info.step);
      EXPECT_EQ(info.seed, 99u);
      context.emit({.values = {static_cast<float>(info.time())}});
    }

   private:
    TableId table_;
  };
  Bare bare;
  bare.builder.add<Clock>(bare.keys.birds);
  const auto simulation = bare.builder.build();
  World world = simulation->world(99);
  Workspace work(*simulation);
  for (int i = 0; i < 50; ++i)
    simulation->step(world, work);
  EXPECT_EQ(world.step(), 50u);
  EXPECT_FLOAT_EQ(simulation->step(world, work)[0].values[0], 1.0f) << "50 steps are one second";
}

/// Every bird with an odd id hits bird 1; the referee counts.
class Mob final : public System {
 public:
  explicit Mob(const swarm::Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "mob"; }
  TableId table() const override { return keys_.birds; }
  void interact(World& world, const StepInfo&, Chunk chunk, Outbox& out) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      if (i == 1 || i == 2)
        out.emit({.kind = Happening::hit, .who = world.ids(keys_.birds)[i], .whom = PlayerId{1}});
  }
  void commit(World& world, const StepInfo&, std::span<const Event> events,
              CommitContext& context) const override {
    for (const Event& event : events) {
      const auto victim = world.row(keys_.birds, event.whom);
      const auto hero = world.row(keys_.birds, event.who);
      ASSERT_TRUE(victim && hero) << "the fallen are found until the end of the commit";
      ++world.rows(keys_.vitals)[*hero].kills;
      EXPECT_TRUE(context.remove(event.whom));
      context.emit({.kind = Happening::kill, .who = event.who, .whom = event.whom});
    }
    EXPECT_FALSE(context.remove(PlayerId{1000})) << "nobody of that id";
  }

 private:
  swarm::Keys keys_;
};

/// Reads what earlier commits emitted.
class Herald final : public System {
 public:
  explicit Herald(const swarm::Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "herald"; }
  TableId table() const override { return keys_.birds; }
  void commit(World& world, const StepInfo&, std::span<const Event> events,
              CommitContext&) const override {
    for (const Event& event : events)
      if (event.kind == Happening::kill)
        ++world.rows(keys_.vitals)[2].hits;
  }

 private:
  swarm::Keys keys_;
};

TEST(Step, CountsBothOfTwoSimultaneousKills) {
  Bare bare;
  bare.builder.add<Mob>(bare.keys);
  const auto simulation = bare.builder.build();
  World world = simulation->world(1);
  for (int i = 0; i < 4; ++i)
    (void)world.spawn(bare.keys.birds);
  Workspace work(*simulation);
  simulation->step(world, work);
  ASSERT_EQ(world.rows(bare.keys.birds), 3u);
  const auto vitals = std::as_const(world).rows(bare.keys.vitals);
  EXPECT_EQ(vitals[0].kills, 1u);
  EXPECT_EQ(vitals[1].kills, 1u);
  EXPECT_EQ(vitals[2].kills, 0u);
}

TEST(Step, ShowsSecondaryEventsToLaterSystemsAndToObserversLast) {
  Bare bare;
  bare.builder.add<Mob>(bare.keys);
  bare.builder.add<Herald>(bare.keys);
  const auto simulation = bare.builder.build();
  World world = simulation->world(1);
  for (int i = 0; i < 4; ++i)
    (void)world.spawn(bare.keys.birds);
  Workspace work(*simulation);
  const auto events = simulation->step(world, work);
  ASSERT_EQ(events.size(), 4u);
  EXPECT_TRUE(events[1].kind == Happening::hit);
  EXPECT_TRUE(events[2].kind == Happening::kill);
  EXPECT_EQ(events[3].who, PlayerId{3});
  EXPECT_EQ(std::as_const(world).rows(bare.keys.vitals)[1].hits, 2u)
      << "row 2 of the commit is row 1 once bird 1 is gone";
}

TEST(Step, RefusesAWorldOrWorkspaceOfAnotherSimulation) {
  const Swarm small(10, 10);
  const Swarm large(1000, 10);
  World foreign = large.world(3);
  World own = large.world(3);
  Workspace small_work(*small.simulation);
  EXPECT_THROW(small.simulation->step(foreign, small_work), std::logic_error);
  EXPECT_THROW(large.simulation->step(own, small_work), std::logic_error);
}

}  // namespace
}  // namespace eyrie::sim
