// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include <gtest/gtest.h>

#include "support/model/firing_range.hpp"

namespace eyrie::model::weapon {
namespace {

/// Emits the events that a test prepared, in interact.
class Script final : public sim::System {
 public:
  Script(TableId table, const std::vector<sim::Event>& events) : table_(table), events_(events) {}
  [[nodiscard]] std::string_view name() const override { return "script"; }
  [[nodiscard]] TableId table() const override { return table_; }
  void interact(sim::World&, const sim::StepInfo&, sim::Chunk chunk,
                sim::Outbox& out) const override {
    if (chunk.begin == 0)
      for (const sim::Event& event : events_)
        out.emit(event);
  }

 private:
  TableId table_;
  const std::vector<sim::Event>& events_;
};

struct DamageTest : ::testing::Test {
  DamageTest() {
    sim::SchemaBuilder schema;
    columns = AircraftColumns::define(schema, 4);
    sim::SimulationBuilder builder(schema.build());
    builder.add<Script>(columns.table, script);
    builder.add<DamageSystem>(columns);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(1));
    work = std::make_unique<sim::Workspace>(*simulation);
    for (PlayerId* who : {&a, &b, &c})
      *who = world->spawn(columns.table)->id;
  }
  static sim::Event hit(PlayerId who, PlayerId whom, float damage, std::uint32_t weapon = 0) {
    return {.kind = EventKind::hit, .detail = weapon, .who = who, .whom = whom, .values = {damage}};
  }
  /// One step with these events; the kills that follow.
  std::vector<sim::Event> step(std::vector<sim::Event> events) {
    script = std::move(events);
    std::vector<sim::Event> kills;
    for (const sim::Event& event : simulation->step(*world, *work))
      if (event.kind == EventKind::kill)
        kills.push_back(event);
    return kills;
  }

  AircraftColumns columns;
  std::vector<sim::Event> script;
  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;
  std::unique_ptr<sim::Workspace> work;
  PlayerId a, b, c;
};

TEST_F(DamageTest, AddsUpUntilItKills) {
  EXPECT_TRUE(step({hit(a, b, 0.4F)}).empty());
  EXPECT_TRUE(step({hit(c, b, 0.4F)}).empty());
  const Damage damage = world->rows(columns.damage)[1];
  EXPECT_NEAR(damage.damage, 0.8, 1e-6);
  EXPECT_EQ(damage.hits, 2u);
  EXPECT_EQ(damage.last_hit_by, c);
  const auto kills = step({hit(a, b, 0.4F, 17)});
  ASSERT_EQ(kills.size(), 1u);
  EXPECT_EQ(kills[0].who, a);
  EXPECT_EQ(kills[0].whom, b);
  EXPECT_EQ(kills[0].detail, 17u);
  EXPECT_FALSE(world->find(b));
  EXPECT_TRUE(world->find(a) && world->find(c));
}

TEST_F(DamageTest, CountsTwoWhoKillEachOtherInOneStep) {
  const auto kills = step({hit(a, b, 1), hit(b, a, 1)});
  ASSERT_EQ(kills.size(), 2u);
  EXPECT_EQ(kills[0].who, a);
  EXPECT_EQ(kills[1].who, b);
  EXPECT_FALSE(world->find(a));
  EXPECT_FALSE(world->find(b));
}

TEST_F(DamageTest, CreditsTheFirstOfTwoHitsThatEachWouldKill) {
  const auto kills = step({hit(c, b, 1, 8), hit(a, b, 1, 9)});
  ASSERT_EQ(kills.size(), 1u);
  EXPECT_EQ(kills[0].who, c);
  EXPECT_EQ(kills[0].detail, 8u);
}

TEST_F(DamageTest, CreditsAShooterThatIsDead) {
  step({hit(c, a, 1)});
  const auto kills = step({hit(a, b, 1, 30)});
  ASSERT_EQ(kills.size(), 1u);
  EXPECT_EQ(kills[0].who, a);
}

TEST_F(DamageTest, TakesOutWhoCrashedOrIsHomeWithoutAKill) {
  EXPECT_TRUE(
      step({{.kind = EventKind::crash, .who = a}, {.kind = EventKind::home, .who = c}}).empty());
  EXPECT_FALSE(world->find(a));
  EXPECT_FALSE(world->find(c));
  EXPECT_TRUE(world->find(b));
}

TEST_F(DamageTest, LetsNobodyLeaveTwice) {
  EXPECT_TRUE(step({hit(a, b, 1), {.kind = EventKind::crash, .who = b}}).empty());
  EXPECT_FALSE(world->find(b));
  script.clear();
  const std::vector orders(3, lose_order(world->step(), c));
  EXPECT_EQ(simulation->step(*world, *work, orders).size(), 1u);
  EXPECT_FALSE(world->find(c));
}

TEST_F(DamageTest, IgnoresHitsOnWhoIsGone) {
  step({hit(a, b, 1)});
  EXPECT_TRUE(step({hit(a, b, 1)}).empty());
}

}  // namespace
}  // namespace eyrie::model::weapon
