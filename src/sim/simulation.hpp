// SPDX-License-Identifier: MIT
#pragma once
/// \file  The step: const systems in order, six phases, one world at a time.
#include <algorithm>
#include <array>

#include "core/executor.hpp"
#include "sim/check.hpp"
#include "sim/event.hpp"
#include "sim/schema.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

class Simulation;

/// 50 steps per second.
inline constexpr double kDefaultDt = 1.0 / 50;

/// What a step needs besides the world and keeps nothing in between: threads, and room for events.
/// One per thread that steps worlds; reuse it, also for several worlds in turn.
class Workspace {
 public:
  /// `workers` as for Executor, the calling thread included. They change the speed of a step,
  /// never its result. `room`: events per chunk of 256 rows that fit without an allocation.
  explicit Workspace(const Simulation& simulation, unsigned workers = 1, std::size_t room = 256);

  [[nodiscard]] unsigned workers() const { return executor_.workers(); }
  /// The events of the last step, in (phase, system, row, emission) order, then secondary ones.
  [[nodiscard]] std::span<const Event> events() const { return events_.events(); }
  /// Why the last step was not finished; null if it was. Of several faults of one system the first
  /// in row order, so it is the same for any number of workers.
  [[nodiscard]] const Fault* fault() const { return fault_.get(); }
  /// From the next step on who writes what is checked, in worlds like this one.
  void check_writes(const World& like) { check_ = std::make_unique<WriteCheck>(like); }
  /// The first that was found; null if writes are not checked.
  [[nodiscard]] WriteCheck* write_check() { return check_.get(); }

 private:
  friend class Simulation;
  void collect(std::size_t chunks);

  Executor executor_;
  std::vector<Outbox> by_chunk_;
  Outbox emitted_;
  Outbox events_;
  std::unique_ptr<Fault> fault_;
  std::unique_ptr<WriteCheck> check_;  ///< null: not checked
};

/// One of the worlds that are stepped together, what its step needs, and the orders that it takes.
struct Stepped {
  World* world = nullptr;
  Workspace* work = nullptr;
  std::span<const Order> orders = {};
};
inline constexpr std::size_t kMostTogether = 32;

/// Everything that does not change: the schema, the systems in their order and the length of a
/// step. Shared by any number of worlds and threads.
class Simulation {
 public:
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  [[nodiscard]] const Schema& schema() const { return *schema_; }
  [[nodiscard]] const std::shared_ptr<const Schema>& shared_schema() const { return schema_; }
  [[nodiscard]] double dt() const { return dt_; }
  [[nodiscard]] std::span<const std::unique_ptr<const System>> systems() const { return systems_; }
  /// An empty world of this simulation's schema.
  [[nodiscard]] World world(std::uint64_t seed) const { return World(schema_, seed); }
  /// The system that carries out this kind of order; null if nobody does.
  [[nodiscard]] const System* handler(OrderKind kind) const;

  /// One step of `dt` seconds: orders, perceive, decide, act, move, interact, commit. Gives the
  /// events of the step, good until the workspace is used again. The result depends on the world
  /// and the orders alone. `orders` are applied in the order given; each must name this step and
  /// a kind that has a handler (Run sees to it). A world of another schema throws std::logic_error.
  /// If the step could not be finished, work.fault() says why, there are no events, and the world
  /// is between two steps: only good for looking at.
  std::span<const Event> step(World& world, Workspace& work,
                              std::span<const Order> orders = {}) const {
    step(std::array{Stepped{&world, &work, orders}});
    return work.events();
  }
  /// One step of each of several worlds, at most kMostTogether, each with a workspace of its own:
  /// what a system does is done in all of them before the next one begins, which is faster for
  /// small worlds. Of each comes what comes of it alone.
  void step(std::span<const Stepped> worlds) const;

 private:
  friend class SimulationBuilder;
  friend class Workspace;
  Simulation(std::shared_ptr<const Schema> schema, double dt);
  /// A system's part in a phase, with its table beside it: a step asks each several times.
  struct Turn {
    const System* system;
    TableId table;
  };
  /// One of the worlds that are stepped together, in the step that is made.
  struct Going {
    World* world;
    Workspace* work;
    StepInfo info;
  };
  void apply(std::span<const Order> orders, const Going& one) const;
  template <auto kPart>
  void run(Phase phase, std::span<const Going> worlds) const;
  /// Rows of several chunks, or in a world where writes are checked.
  template <auto kPart>
  void run_at_length(const Turn& turn, Phase phase, const Going& one, std::uint32_t rows) const;
  void move_together(std::span<const Going> worlds) const;
  /// Whether the system made the step impossible.
  static bool failed(const System& system, const Going& one) {
    return one.work->events_.failed() && fail(system, one);
  }
  static bool fail(const System& system, const Going& one);
  void commit(const Going& one) const;

  std::shared_ptr<const Schema> schema_;
  double dt_;
  std::size_t chunks_;  ///< of the largest table, when it is full
  std::vector<std::unique_ptr<const System>> systems_;
  std::array<std::vector<Turn>, kPhases> by_phase_;
  std::vector<const System*> by_order_;  ///< index: kind
};

/// Which phases a system takes part in: those whose function it overrides.
template <class S>
[[nodiscard]] constexpr std::array<bool, kPhases> phases_of() {
  const auto overrides = []<class Mine, class Base>(Mine, Base) {
    return !std::same_as<Mine, Base>;
  };
  return {overrides(&S::apply_order, &System::apply_order),
          overrides(&S::perceive, &System::perceive),
          overrides(&S::decide, &System::decide),
          overrides(&S::act, &System::act),
          overrides(&S::move, &System::move),
          overrides(&S::interact, &System::interact),
          overrides(&S::commit, &System::commit)};
}

/// Collects systems, then builds the Simulation. Misuse (dt not positive and finite, a system of an
/// unknown table, an order kind taken twice) throws std::logic_error.
class SimulationBuilder {
 public:
  explicit SimulationBuilder(std::shared_ptr<const Schema> schema, double dt = kDefaultDt);

  /// Adds a system after the ones before it. `S` must be its final type, because the phases it
  /// takes part in are read off its overrides, which must be public.
  template <std::derived_from<System> S>
  S& add(std::unique_ptr<S> system) {
    static_assert(!std::is_abstract_v<S>, "add a system by its own type, not by a base");
    S& added = *system;
    add(std::move(system), phases_of<S>());
    return added;
  }
  template <std::derived_from<System> S, class... Args>
  S& add(Args&&... args) {
    return add(std::make_unique<S>(std::forward<Args>(args)...));
  }

  /// The finished simulation. The builder is empty afterwards.
  [[nodiscard]] std::shared_ptr<const Simulation> build();

 private:
  void add(std::unique_ptr<const System> system, const std::array<bool, kPhases>& phases);

  std::unique_ptr<Simulation> simulation_;
};

}  // namespace eyrie::sim
