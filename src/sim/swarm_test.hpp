// SPDX-License-Identifier: MIT
#pragma once
/// \file  A small world for the tests of the kernel: birds that hunt, shoot pellets, die and
/// hatch. It uses everything that a step offers: rates, draws, brain memory, both kinds of events,
/// births, deaths, orders, and a table that fills up.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/draw.hpp"
#include "core/vec.hpp"
#include "sim/simulation.hpp"
#include "sim/swarm_rows_test.hpp"
#include "sim/system.hpp"

namespace eyrie::sim::swarm {

/// Perceives, decides and shoots. Looks at a few others by draw, at its own rate.
class Hunter final : public System {
 public:
  explicit Hunter(const Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "hunter"; }
  TableId table() const override { return keys_.birds; }

  void perceive(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    const auto ids = world.ids(keys_.birds);
    const auto bodies = std::as_const(world).rows(keys_.body);
    const auto moods = world.rows(keys_.mood);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (!due(info.step, ids[i], kPeriod))
        continue;
      Draw draw(info.seed, ids[i], Stream::visual, info.step);
      double best = 1e300;
      moods[i].target = {};
      for (int look = 0; look < 8; ++look) {
        const auto other =
            static_cast<std::size_t>(draw.uniform() * static_cast<double>(bodies.size()));
        const double range = norm(bodies[other].position - bodies[i].position);
        if (other == i || range >= best)
          continue;
        best = range;
        moods[i].target = ids[other];
        moods[i].goal = bodies[other].position;
      }
      ++moods[i].looks;
    }
  }

  void decide(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    const auto ids = world.ids(keys_.birds);
    const auto moods = world.rows(keys_.mood);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto brain = world.bytes(keys_.brain, i);
      brain[0] = static_cast<std::byte>(std::to_integer<unsigned>(brain[0]) + 1);
      Draw draw(info.seed, ids[i], Stream::behavior, info.step);
      moods[i].angry = moods[i].target && draw.chance(0.2) ? 1 : 0;
    }
  }

  void act(World& world, const StepInfo&, Chunk chunk, Outbox& out) const override {
    const auto ids = world.ids(keys_.birds);
    const auto moods = std::as_const(world).rows(keys_.mood);
    const auto bodies = std::as_const(world).rows(keys_.body);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      if (moods[i].angry != 0)
        out.emit({.kind = Happening::shot,
                  .who = ids[i],
                  .whom = moods[i].target,
                  .place = bodies[i].position});
  }

 private:
  Keys keys_;
};

/// Moves birds towards their goals.
class Wings final : public System {
 public:
  explicit Wings(const Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "wings"; }
  TableId table() const override { return keys_.birds; }
  std::span<const OrderKind> accepts() const override { return kOrders; }

  void apply_order(World& world, const StepInfo&, const Order& order, Outbox& out) const override {
    const auto row = world.row(keys_.birds, order.player);
    if (!row)
      return;
    world.rows(keys_.body)[*row].velocity = order.as<Turn>().velocity;
    out.emit({.kind = Happening::turned, .who = order.player});
  }

  void move(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    const auto moods = std::as_const(world).rows(keys_.mood);
    const auto bodies = world.rows(keys_.body);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Body& body = bodies[i];
      body.velocity += (moods[i].goal - body.position) * (0.1 * info.dt);
      body.velocity *= 0.999;
      body.position += body.velocity * info.dt;
    }
  }

 private:
  static constexpr std::array<OrderKind, 1> kOrders{OrderKind(Wish::turn)};
  Keys keys_;
};

/// Flies pellets and reports those that come near their target.
class Pellets final : public System {
 public:
  explicit Pellets(const Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "pellets"; }
  TableId table() const override { return keys_.pellets; }

  void move(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Body& body = world.rows(keys_.pellet_body)[i];
      body.position += body.velocity * info.dt;
      ++world.rows(keys_.aim)[i].age;
    }
  }

  void interact(World& world, const StepInfo&, Chunk chunk, Outbox& out) const override {
    const auto ids = world.ids(keys_.pellets);
    const auto aims = std::as_const(world).rows(keys_.aim);
    const auto pellets = std::as_const(world).rows(keys_.pellet_body);
    const auto birds = std::as_const(world).rows(keys_.body);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto target = world.row(keys_.birds, aims[i].target);
      if (!target)
        continue;
      const double miss = norm(birds[*target].position - pellets[i].position);
      if (miss < kReach)
        out.emit({.kind = Happening::hit,
                  .detail = aims[i].owner.value,
                  .who = ids[i],
                  .whom = aims[i].target,
                  .place = pellets[i].position,
                  .values = {static_cast<float>(miss)}});
    }
  }

 private:
  Keys keys_;
};

/// Births and deaths: shots become pellets, hits become kills, kills become eggs.
class Referee final : public System {
 public:
  explicit Referee(const Keys& keys) : keys_(keys) {}
  std::string_view name() const override { return "referee"; }
  TableId table() const override { return keys_.birds; }

  void commit(World& world, const StepInfo& info, std::span<const Event> events,
              CommitContext& context) const override {
    for (const Event& event : events) {
      if (event.kind == Happening::shot)
        launch(world, event, context);
      else if (event.kind == Happening::hit)
        hit(world, info, event, context);
    }
    const auto aims = std::as_const(world).rows(keys_.aim);
    for (std::uint32_t i = 0; i < aims.size(); ++i)
      if (aims[i].age > 100)
        context.remove(keys_.pellets, i);
  }

 private:
  void launch(World& world, const Event& event, CommitContext& context) const {
    const auto target = world.row(keys_.birds, event.whom);
    const auto pellet = target ? context.spawn(keys_.pellets) : std::nullopt;
    if (!pellet)
      return;
    const Vec3 way = world.rows(keys_.body)[*target].position - event.place;
    world.rows(keys_.pellet_body)[pellet->row] = {event.place, way};
    world.rows(keys_.aim)[pellet->row] = {.target = event.whom, .owner = event.who};
  }

  void hit(World& world, const StepInfo& info, const Event& event, CommitContext& context) const {
    context.remove(event.who);
    const auto victim = world.row(keys_.birds, event.whom);
    const auto owner = world.row(keys_.birds, PlayerId{event.detail});
    if (!victim || ++world.rows(keys_.vitals)[*victim].hits < kHits)
      return;
    context.remove(keys_.birds, *victim);
    context.emit({.kind = Happening::kill, .who = PlayerId{event.detail}, .whom = event.whom});
    if (owner)
      ++world.rows(keys_.vitals)[*owner].kills;
    if (!Draw(info.seed, event.whom, Stream::lethality, info.step).chance(0.5))
      return;
    if (const auto egg = context.spawn(keys_.birds)) {
      world.rows(keys_.body)[egg->row].position = event.place;
      context.emit({.kind = Happening::hatched, .who = egg->id});
    }
  }

  Keys keys_;
};

/// A simulation of at most so many birds and pellets.
struct Swarm {
  Keys keys;
  std::shared_ptr<const Simulation> simulation;

  explicit Swarm(std::uint32_t birds = 1200, std::uint32_t pellets = 4000) {
    SchemaBuilder schema;
    keys = describe(schema, birds, pellets);
    SimulationBuilder builder(schema.build());
    builder.add<Hunter>(keys);
    builder.add<Wings>(keys);
    builder.add<Pellets>(keys);
    builder.add<Referee>(keys);
    simulation = builder.build();
  }

  static Keys describe(SchemaBuilder& schema, std::uint32_t birds, std::uint32_t pellets) {
    Keys keys;
    keys.birds = schema.add_table("bird", birds);
    keys.pellets = schema.add_table("pellet", pellets);
    keys.body = schema.add_column<Body>(keys.birds, "body");
    keys.mood = schema.add_column<Mood>(keys.birds, "mood");
    keys.vitals = schema.add_column<Vitals>(keys.birds, "vitals");
    keys.brain = schema.add_bytes(keys.birds, "brain", 24);
    keys.pellet_body = schema.add_column<Body>(keys.pellets, "body");
    keys.aim = schema.add_column<Aim>(keys.pellets, "aim");
    return keys;
  }

  /// `birds` birds on a crowded spiral.
  World world(std::uint32_t birds, std::uint64_t seed = 1) const {
    World world = simulation->world(seed);
    for (std::uint32_t i = 0; i < birds; ++i) {
      const auto born = world.spawn(keys.birds);
      const double n = i;
      world.rows(keys.body)[born.value().row] = {{3 * n, 50 - n * n / 40, 2 * n}, {n, 1, -n}};
    }
    return world;
  }
};

/// Steps a world `steps` times.
inline void fly(const Swarm& swarm, World& world, int steps, unsigned workers = 1) {
  Workspace work(*swarm.simulation, workers);
  for (int i = 0; i < steps; ++i)
    swarm.simulation->step(world, work);
}

}  // namespace eyrie::sim::swarm
