// SPDX-License-Identifier: MIT
#include "sim/run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sim/swarm_test.hpp"
#include "sim/trail.hpp"

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

using swarm::Swarm;
using swarm::Turn;
using swarm::Wish;

Order turn(std::uint64_t step, double speed, std::uint32_t player = 1) {
  return order_for(step, PlayerId{player}, Wish::turn, Turn{{speed, 0, 0}});
}

/// Writes down what it is shown.
class Diary final : public Observer {
 public:
  void begin(const World& world, double dt) override {
    lines.push_back("begin " + std::to_string(world.step()) + " dt " + std::to_string(dt));
  }
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override {
    EXPECT_EQ(world.step(), info.step + 1);
    lines.push_back("step " + std::to_string(info.step));
    for (const Event& event : events)
      if (event.kind == swarm::Happening::turned)
        lines.push_back("turned " + std::to_string(event.who.value));
  }
  void finish(const World& world) override {
    lines.push_back("finish " + std::to_string(world.step()));
  }

  std::vector<std::string> lines;
};

TEST(Run, ShowsEveryCommittedStepToItsObservers) {
  const Swarm swarm;
  sim::Run run(swarm.simulation, swarm.world(3));
  Diary diary;
  run.attach(diary);
  EXPECT_EQ(run.submit(turn(1, 5, 2)), "");
  run.step();
  run.step();
  run.finish();
  EXPECT_EQ(diary.lines, (std::vector<std::string>{"begin 0 dt 0.020000", "step 0", "step 1",
                                                   "turned 2", "finish 2"}));
  EXPECT_DOUBLE_EQ(run.time(), 0.04);
}

TEST(Run, AppliesOrdersAtTheirStepInTheOrderTheyCame) {
  const Swarm swarm;
  sim::Run run(swarm.simulation, swarm.world(3));
  EXPECT_EQ(run.submit(turn(2, 1e6)), "");
  EXPECT_EQ(run.submit(turn(1, 2e6)), "");
  EXPECT_EQ(run.submit(turn(1, 3e6)), "");
  const auto speed = [&] { return run.world().rows(swarm.keys.body)[0].velocity.x; };
  run.step();
  EXPECT_LT(speed(), 1e5);
  run.step();
  EXPECT_NEAR(speed(), 3e6, 1e5);
  run.step();
  EXPECT_NEAR(speed(), 1e6, 1e5);
  ASSERT_EQ(run.orders().size(), 3u);
  EXPECT_EQ(run.orders()[0].as<Turn>().velocity.x, 2e6);
  EXPECT_EQ(run.orders()[2].as<Turn>().velocity.x, 1e6);
}

TEST(Run, RefusesOrdersThatAreLateOrUnknown) {
  const Swarm swarm;
  sim::Run run(swarm.simulation, swarm.world(3));
  run.step();
  EXPECT_EQ(run.submit(turn(0, 1)), "an order for step 0 comes too late: step 1 is next");
  EXPECT_EQ(run.submit({.step = 5, .kind = OrderKind(9)}), "nobody accepts orders of kind 9");
  EXPECT_EQ(run.submit({.step = 5}), "nobody accepts orders of kind 0");
  EXPECT_TRUE(run.orders().empty());
}

TEST(Run, IsDeterminedByItsStartAndItsOrders) {
  const Swarm swarm;
  const World start = swarm.world(257);
  TrailRecorder recorder;
  sim::Run first(swarm.simulation, start);
  first.attach(recorder);
  for (std::uint64_t i = 0; i < 70; ++i) {
    if (i % 7 == 3) {
      EXPECT_EQ(first.submit(turn(i + 2, 100.0 * static_cast<double>(i), 40)), "");
    }
    first.step();
  }
  first.finish();

  sim::Run second(swarm.simulation, start, {.workers = 3});
  const HashTrail trail = recorder.trail();
  TrailChecker checker(trail);
  second.attach(checker);
  for (const Order& order : first.orders())
    EXPECT_EQ(second.submit(order), "");
  for (int i = 0; i < 70; ++i)
    second.step();
  second.finish();
  EXPECT_FALSE(checker.departure()) << checker.departure()->reason;
  EXPECT_TRUE(second.world().same_bytes(first.world()));
}

TEST(Run, ThatIsParanoidIsTheSameRun) {
  const Swarm swarm;
  sim::Run plain(swarm.simulation, swarm.world(300));
  sim::Run paranoid(swarm.simulation, swarm.world(300), {.workers = 1, .paranoid_workers = 3});
  Diary diary;
  paranoid.attach(diary);
  for (int i = 0; i < 40; ++i) {
    plain.step();
    paranoid.step();
  }
  EXPECT_FALSE(paranoid.difference());
  EXPECT_EQ(diary.lines.size(), 41u) << "every step is seen once";
  EXPECT_TRUE(paranoid.world().same_bytes(plain.world()));
}

/// Counts its calls where no World can see it.
class Forgetful final : public System {
 public:
  explicit Forgetful(const swarm::Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "forgetful"; }
  TableId table() const override { return keys_.birds; }
  void commit(World& world, const StepInfo&, std::span<const Event>,
              CommitContext&) const override {
    world.rows(keys_.vitals)[0].kills = ++calls_;
  }

 private:
  swarm::Keys keys_;
  mutable std::uint32_t calls_ = 0;
};

TEST(Run, ThatIsParanoidKeepsTheFirstDifference) {
  SchemaBuilder schema;
  const auto keys = Swarm::describe(schema, 5, 5);
  SimulationBuilder builder(schema.build());
  builder.add<swarm::Wings>(keys);
  builder.add<Forgetful>(keys);
  const auto simulation = builder.build();
  World start = simulation->world(1);
  ASSERT_TRUE(start.spawn(keys.birds));
  sim::Run run(simulation, start, {.workers = 1, .paranoid_workers = 2});
  run.step();
  run.step();
  ASSERT_TRUE(run.difference());
  EXPECT_EQ(run.difference()->text(),
            "step 1: bird.vitals.kills of player 1 (row 0) is 1, and 2 in the other");
}

TEST(Run, RefusesAWorldOfAnotherSimulation) {
  const Swarm one(5, 5);
  const Swarm other(5, 5);
  EXPECT_THROW(sim::Run(one.simulation, other.world(3)), std::logic_error);
}

}  // namespace
}  // namespace eyrie::sim
