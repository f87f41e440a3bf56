// SPDX-License-Identifier: MIT
/// \file  How a simulation is built, and how orders reach it.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/simulation.hpp"
#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Swarm;
using swarm::Vitals;
using swarm::Wish;

TEST(Step, AppliesOrdersInTheirOrderBeforeAnythingElse) {
  const Swarm swarm;
  World world = swarm.world(3);
  Workspace work(*swarm.simulation);
  const std::vector<Order> orders{
      order_for(0, PlayerId{2}, Wish::turn, swarm::Turn{{1, 0, 0}}),
      order_for(0, PlayerId{2}, Wish::turn, swarm::Turn{{5e6, 0, 0}}),
      order_for(0, PlayerId{77}, Wish::turn, swarm::Turn{}),
  };
  const auto events = swarm.simulation->step(world, work, orders);
  ASSERT_GE(events.size(), 2u);
  EXPECT_TRUE(events[0].kind == swarm::Happening::turned);
  EXPECT_TRUE(events[1].kind == swarm::Happening::turned);
  const double way = world.rows(swarm.keys.body)[1].position.x - 3;
  EXPECT_NEAR(way, 5e6 * swarm.simulation->dt(), 200) << "the last order holds, in the same step";
}

/// Perceives what an order of the same step changed.
class Listener final : public System {
 public:
  explicit Listener(const swarm::Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "listener"; }
  TableId table() const override { return keys_.birds; }
  std::span<const OrderKind> accepts() const override { return kOrders; }
  void apply_order(World& world, const StepInfo&, const Order& order, Outbox&) const override {
    world.rows(keys_.vitals)[*world.row(keys_.birds, order.player)].hits = 7;
  }
  void perceive(World& world, const StepInfo&, Chunk chunk, Outbox&) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      world.rows(keys_.vitals)[i].kills = world.rows(keys_.vitals)[i].hits;
  }

 private:
  static constexpr std::array<OrderKind, 1> kOrders{OrderKind(Wish::turn)};
  swarm::Keys keys_;
};

TEST(Step, PerceivesWhatItsOrdersChanged) {
  swarm::Keys keys;
  SchemaBuilder schema;
  keys.birds = schema.add_table("bird", 5);
  keys.vitals = schema.add_column<Vitals>(keys.birds, "vitals");
  SimulationBuilder builder(schema.build());
  builder.add<Listener>(keys);
  const auto simulation = builder.build();
  World world = simulation->world(1);
  ASSERT_TRUE(world.spawn(keys.birds));
  Workspace work(*simulation);
  const Order order = order_for(0, PlayerId{1}, Wish::turn, swarm::Turn{});
  simulation->step(world, work, {&order, 1});
  EXPECT_EQ(world.rows(keys.vitals)[0].kills, 7u);
}

TEST(StepDeathTest, EndsTheProgramOnAnOrderForAnotherStep) {
  const Swarm swarm;
  World world = swarm.world(3);
  Workspace work(*swarm.simulation);
  const std::array orders{order_for(1, PlayerId{2}, Wish::turn, swarm::Turn{})};
  EXPECT_DEATH(swarm.simulation->step(world, work, orders), "applied in the step it names");
}

TEST(Phases, AreThoseThatASystemOverrides) {
  using Phases = std::array<bool, kPhases>;
  EXPECT_EQ(phases_of<swarm::Hunter>(), (Phases{false, true, true, true, false, false, false}));
  EXPECT_EQ(phases_of<swarm::Wings>(), (Phases{true, false, false, false, true, false, false}));
  EXPECT_EQ(phases_of<swarm::Referee>(), (Phases{false, false, false, false, false, false, true}));
  EXPECT_EQ(enum_name(Phase::orders), "orders");
  EXPECT_EQ(enum_name(Phase::commit), "commit");
}

TEST(SimulationBuilder, RefusesOrdersThatTwoAccept) {
  const auto complaint = [](int handlers) -> std::string {
    SchemaBuilder schema;
    const auto keys = Swarm::describe(schema, 1, 1);
    SimulationBuilder builder(schema.build());
    try {
      for (int i = 0; i < handlers; ++i)
        builder.add<swarm::Wings>(keys);
      (void)builder.build();
    } catch (const std::logic_error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(complaint(1), "");
  EXPECT_NE(complaint(2).find("two systems accept"), std::string::npos);
}

TEST(SimulationBuilder, KeepsNothingOfWhatItRefuses) {
  SchemaBuilder schema;
  const auto keys = Swarm::describe(schema, 1, 1);
  SimulationBuilder builder(schema.build());
  builder.add<swarm::Wings>(keys);
  EXPECT_THROW(builder.add<swarm::Wings>(keys), std::logic_error);
  const auto simulation = builder.build();
  EXPECT_EQ(simulation->systems().size(), 1U);
  World world = simulation->world(1);
  ASSERT_TRUE(world.spawn(keys.birds));
  Workspace work(*simulation);
  simulation->step(world, work);
  EXPECT_EQ(world.step(), 1U);
}

/// Cannot carry out what it is asked.
class Unable final : public System {
 public:
  explicit Unable(TableId table) : table_(table) {}
  std::string_view name() const override { return "unable"; }
  TableId table() const override { return table_; }
  std::span<const OrderKind> accepts() const override { return kKinds; }
  void apply_order(World&, const StepInfo&, const Order&, Outbox& out) const override {
    out.fail({.what = "bad order"});
  }

 private:
  static constexpr std::array kKinds{OrderKind(1)};
  TableId table_;
};

TEST(Step, IsNotMadeIfAnOrderCannotBeCarriedOut) {
  SchemaBuilder schema;
  const TableId nobody = schema.add_table("nobody", 1);
  SimulationBuilder builder(schema.build());
  builder.add<Unable>(nobody);
  const auto simulation = builder.build();
  World world = simulation->world(1);
  Workspace work(*simulation);
  const Order order{.step = 0, .kind = OrderKind(1)};
  simulation->step(world, work, {&order, 1});
  ASSERT_NE(work.fault(), nullptr);
  EXPECT_EQ(work.fault()->system, "unable");
  EXPECT_EQ(world.step(), 0U);
  simulation->step(world, work);
  EXPECT_EQ(work.fault(), nullptr) << "of the step before";
  EXPECT_EQ(world.step(), 1U);
}

TEST(Step, OfSeveralWorldsRefusesAllOrNone) {
  const Swarm one, other;
  World a = one.world(3), b = other.world(3), c = one.world(3);
  Workspace of_a(*one.simulation), of_b(*other.simulation), of_c(*one.simulation);
  const std::uint64_t before = a.hash();
  const auto refused = [&](std::initializer_list<Stepped> worlds) {
    EXPECT_THROW(one.simulation->step(std::span(worlds.begin(), worlds.size())), std::logic_error);
    EXPECT_EQ(a.hash(), before);
  };
  refused({{&a, &of_a}, {&b, &of_b}});
  refused({{&a, &of_a}, {&a, &of_c}});
  refused({{&a, &of_a}, {&c, &of_a}});
  refused({{&a, &of_a}, {&c, nullptr}});
  one.simulation->step(std::span<const Stepped>{});
}

TEST(SimulationBuilder, RefusesAStepWithoutLength) {
  SchemaBuilder schema;
  (void)schema.add_table("bird", 1);
  const auto built = schema.build();
  EXPECT_THROW(SimulationBuilder(built, 0.0), std::logic_error);
  EXPECT_THROW(SimulationBuilder(built, -1.0), std::logic_error);
  EXPECT_THROW(SimulationBuilder(nullptr), std::logic_error);
}

}  // namespace
}  // namespace eyrie::sim
