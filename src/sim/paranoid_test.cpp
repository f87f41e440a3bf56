// SPDX-License-Identifier: MIT
#include "sim/paranoid.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <utility>

#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Body;
using swarm::Keys;
using swarm::Swarm;

/// What goes wrong in a broken system, which takes part in the swarm's steps.
enum class Sin { none, hidden_state, extra_event, beyond_rows };

/// Each sin is one that a review can miss: the code works, and single runs look alike.
class Sinner final : public System {
 public:
  Sinner(const Keys& keys, Sin sin) : keys_(keys), sin_(sin) {}
  std::string_view name() const override { return "sinner"; }
  TableId table() const override { return keys_.birds; }

  void move(World& world, const StepInfo& info, Chunk chunk, Outbox& out) const override {
    const auto bodies = world.rows(keys_.body);
    if (info.step < 5)
      return;
    if (sin_ == Sin::hidden_state && chunk.begin == 0)
      bodies[3].velocity.y += static_cast<double>(++calls_);
    if (sin_ == Sin::extra_event && chunk.begin == 0 && ++calls_ % 2 == 0)
      out.emit({.kind = swarm::Happening::turned, .who = PlayerId{1}});
    if (sin_ == Sin::beyond_rows && chunk.begin == 0)
      bodies.data()[bodies.size()].position.x = 1;
  }

 private:
  Keys keys_;
  Sin sin_;
  mutable std::atomic<int> calls_{0};
};

struct BrokenSwarm {
  Keys keys;
  std::shared_ptr<const Simulation> simulation;

  explicit BrokenSwarm(Sin sin) {
    SchemaBuilder schema;
    keys = Swarm::describe(schema, 900, 900);
    SimulationBuilder builder(schema.build());
    builder.add<swarm::Hunter>(keys);
    builder.add<swarm::Wings>(keys);
    builder.add<swarm::Pellets>(keys);
    builder.add<swarm::Referee>(keys);
    builder.add<Sinner>(keys, sin);
    simulation = builder.build();
  }

  World world(std::uint32_t birds) const {
    World out = simulation->world(1);
    for (std::uint32_t i = 0; i < birds; ++i)
      out.rows(keys.body)[out.spawn(keys.birds)->row].position.x = 30.0 * i;
    return out;
  }

  /// What the first suspicious step of 30 shows.
  std::optional<Difference> suspicion(std::uint32_t birds = 300, unsigned second = 3) const {
    World w = world(birds);
    Workspace work(*simulation);
    Paranoid paranoid(*simulation, w, second);
    for (int i = 0; i < 30; ++i)
      if (auto found = paranoid.step(w, work))
        return found;
    return std::nullopt;
  }
};

TEST(Paranoid, FindsNothingInAHonestSwarm) {
  EXPECT_EQ(BrokenSwarm(Sin::none).suspicion(), std::nullopt);
}

TEST(Paranoid, ChangesNeitherTheWorldNorTheEvents) {
  const Swarm swarm;
  World plain = swarm.world(300);
  World checked = plain;
  Workspace plain_work(*swarm.simulation);
  Workspace work(*swarm.simulation, 2);
  Paranoid paranoid(*swarm.simulation, checked, 3);
  for (int i = 0; i < 40; ++i) {
    const Order turn = order_for(plain.step(), PlayerId{5}, swarm::Wish::turn, swarm::Turn{});
    const auto events = swarm.simulation->step(plain, plain_work, {&turn, 1});
    ASSERT_EQ(paranoid.step(checked, work, {&turn, 1}), std::nullopt);
    ASSERT_EQ(first_difference(plain.step(), events, work.events()), std::nullopt);
  }
  EXPECT_EQ(checked.hash(), plain.hash());
}

TEST(Paranoid, NamesTheFieldThatDependsOnStateOutsideTheWorld) {
  const auto found = BrokenSwarm(Sin::hidden_state).suspicion();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 6u) << "the world after step 5, the first bad one";
  EXPECT_EQ(found->table, "bird");
  EXPECT_EQ(found->column, "body");
  EXPECT_EQ(found->row, 3u);
  EXPECT_EQ(found->player, PlayerId{4});
  EXPECT_EQ(found->field, "velocity.y");
}

TEST(Paranoid, NoticesEventsThatDifferWhileTheWorldsAgree) {
  const auto found = BrokenSwarm(Sin::extra_event).suspicion();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 5u);
  EXPECT_EQ(found->table, "events");
}

TEST(Paranoid, NoticesWritesBeyondTheLiveRows) {
  const auto found = BrokenSwarm(Sin::beyond_rows).suspicion();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "form");
}

}  // namespace
}  // namespace eyrie::sim
