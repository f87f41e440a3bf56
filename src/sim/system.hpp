// SPDX-License-Identifier: MIT
#pragma once
/// \file  What takes part in a step, what watches it, and how often things happen that are not done
/// in every step.
#include <limits>

#include "sim/event.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// Once in so many steps, at least 1. Keeps what it takes to find multiples without a division:
/// Lemire, Kaser & Kurz, "Faster remainder by direct computation", Software: Practice and
/// Experience 49 (2019), sec. 3.2.
class Every {
 public:
  constexpr Every(std::uint32_t steps = 1)  // NOLINT: a number of steps is a period
      : steps_(steps), inverse_(steps == 0 ? 0 : ~std::uint64_t{0} / steps + 1) {}
  [[nodiscard]] constexpr std::uint32_t steps() const { return steps_; }
  [[nodiscard]] constexpr bool divides(std::uint64_t n) const {
    EYRIE_ASSERT(steps_ != 0);
    if (n <= std::numeric_limits<std::uint32_t>::max()) [[likely]]
      return n * inverse_ <= inverse_ - 1;
    return n % steps_ == 0;
  }

 private:
  std::uint32_t steps_;
  std::uint64_t inverse_;
};

/// True in one of every `period` steps, in another one for the next id, so that the work of a
/// period spreads over its steps. A player born late is first due at most period - 1 steps later.
[[nodiscard]] constexpr bool due(std::uint64_t step, PlayerId id, const Every& period) {
  return period.divides(step + id.value);
}

/// A period in whole steps, or why there is none.
struct Period {
  std::uint32_t steps = 0;
  std::string error;  ///< empty if `steps` is good
  explicit operator bool() const { return error.empty(); }
};

/// How many steps of `dt` seconds lie between two happenings at `rate` (Hz). Refuses, with a text
/// that names the nearest rates that fit, a rate that is not positive and finite, that is faster
/// than one per step, that the base rate 1/dt is no whole multiple of, or slower than one per hour.
[[nodiscard]] Period period_steps(double rate, double dt);

/// In whole steps, at least 1.
[[nodiscard]] std::uint32_t steps_in_a_second(double dt);

/// What is the same for everybody during one step.
struct StepInfo {
  std::uint64_t step;  ///< number of the step being made, counted from 0
  std::uint64_t seed;  ///< of the run: key of every Draw
  double dt;           ///< s, length of a step
  /// s, at the beginning of the step.
  [[nodiscard]] double time() const { return static_cast<double>(step) * dt; }
  /// s, at the end of the step: as every clock has it, without the rounding of time() + dt.
  [[nodiscard]] double time_after() const { return static_cast<double>(step + 1) * dt; }
};

/// Rows [begin, end) of a table.
struct Chunk {
  std::size_t begin;
  std::size_t end;
};

/// The only place where players are born and removed: handed to System::commit.
class CommitContext {
 public:
  /// A new player in a row of zeros at the end of the table; its id is the highest so far. Nothing
  /// when the table is full: the caller must cope, and World::refused_births() counts it.
  [[nodiscard]] std::optional<Born> spawn(TableId table) { return world_.spawn(table); }

  /// Marks a row for removal at the end of the commit; until then everybody still finds it, so a
  /// second event about the same player counts too. Marking twice is harmless.
  void remove(TableId table, std::uint32_t row) { world_.remove(table, row); }
  /// The same by id; false when there is no such player.
  bool remove(PlayerId who);

  /// A secondary event (a kill that follows from hits). Observers see it after the events of the
  /// parallel phases, and so do the systems whose commit comes later in this step.
  void emit(const Event& event) { emitted_.emit(event); }

 private:
  friend class Simulation;
  CommitContext(World& world, Outbox& emitted) : world_(world), emitted_(emitted) {}
  World& world_;
  Outbox& emitted_;
};

/// Rows of one of several worlds that are stepped together.
struct Share {
  World* world;
  StepInfo info;
  Chunk chunk;
  Outbox* out;
};

/// One const model's share of the step. It keeps nothing: everything that changes is in the World.
///
/// In perceive … interact a call gets a chunk of rows of table(); chunks run on any thread in any
/// order, so a row writes only itself and reads only columns that nobody writes in that phase.
/// commit and apply_order run alone. Override what you need; the rest is never called.
class System {
 public:
  System() = default;
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  virtual ~System() = default;

  /// For messages and profiles, such as "radar".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Whose rows the parallel phases are cut from.
  [[nodiscard]] virtual TableId table() const = 0;
  /// The kinds of orders that go to apply_order. Each kind has one system.
  [[nodiscard]] virtual std::span<const OrderKind> accepts() const { return {}; }

  /// At the step boundary, before perceive. An order about a player that is gone is to be ignored.
  virtual void apply_order(World&, const StepInfo&, const Order&, Outbox&) const {}

  virtual void perceive(World&, const StepInfo&, Chunk, Outbox&) const {}
  virtual void decide(World&, const StepInfo&, Chunk, Outbox&) const {}
  virtual void act(World&, const StepInfo&, Chunk, Outbox&) const {}
  virtual void move(World&, const StepInfo&, Chunk, Outbox&) const {}
  /// The same for several worlds: to be overridden by who computes side by side what it finds in
  /// them. What comes of a world must be what comes of it alone.
  virtual void move_together(std::span<const Share> shares) const {
    for (const Share& share : shares)
      move(*share.world, share.info, share.chunk, *share.out);
  }
  virtual void interact(World&, const StepInfo&, Chunk, Outbox&) const {}

  /// `events`: everything of this step's orders and parallel phases in (phase, system, row,
  /// emission) order, then what the commits of earlier systems emitted.
  virtual void commit(World&, const StepInfo&, std::span<const Event>, CommitContext&) const {}
};

/// Sees every committed step. It gets a const World: it can never change a run.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// Once, before the first step that is observed. `dt` in s.
  virtual void begin(const World&, double /*dt*/) {}
  /// After each step: `info` is the step just made, so world.step() == info.step + 1 and the time
  /// of `world` is info.time_after(). The events belong to the caller and are gone afterwards.
  virtual void observe(const World& world, const StepInfo& info, std::span<const Event> events) = 0;
  /// Once, after the last step.
  virtual void finish(const World&) {}
};

}  // namespace eyrie::sim
