// SPDX-License-Identifier: MIT
#pragma once
/// \file  A run: the simulation, its world, its orders and its observers; and the paranoid way to
/// step.
#include "sim/check.hpp"
#include "sim/difference.hpp"
#include "sim/event.hpp"
#include "sim/simulation.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// Save, step, restore, step again with another worker count, compare the worlds and the events.
/// Finds what the World does not hold (a cache in a system, a static, a clock), what depends on the
/// number of workers or on their order, broken invariants, and who writes what it may not (see
/// WriteCheck), in the very step where it happens.
/// `simulation` must outlive it.
class Paranoid {
 public:
  /// `workers` of the second step; pick another number than that of the first.
  Paranoid(const Simulation& simulation, const World& like, unsigned workers);

  /// Steps `world` with `work`, whose events() are those of the step as always, and returns what
  /// was different the second time (left: `work`, right: the second).
  [[nodiscard]] std::optional<Difference> step(World& world, Workspace& work,
                                               std::span<const Order> orders = {});

 private:
  const Simulation& simulation_;
  Workspace second_;
  World again_;
};

struct RunOptions {
  unsigned workers = 1;
  /// Workers of the second step of every step (see Paranoid); 0 makes each step once.
  unsigned paranoid_workers = 0;
  /// Steps between two copies of the world. After a fault the steps since the last copy are made
  /// again, so that the run ends with its last whole step; where code takes part that may do
  /// otherwise the second time, it is 1.
  std::uint64_t steps_per_copy = 500;
};

/// Steps one world, feeds it its orders and shows every committed step to the observers. The
/// orders of the whole run are kept: together with the initial world they are the recording.
class Run {
 public:
  Run(std::shared_ptr<const Simulation> simulation, World start, const RunOptions& options = {});

  [[nodiscard]] const Simulation& simulation() const { return *simulation_; }
  /// After the last whole step.
  [[nodiscard]] const World& world() const { return fault_ ? copy_ : world_; }
  /// s
  [[nodiscard]] double time() const {
    return static_cast<double>(world().step()) * simulation_->dt();
  }
  [[nodiscard]] const Workspace& workspace() const { return work_; }

  /// The observer sees begin() now and every later step; it must outlive the run's last step.
  void attach(Observer& observer);
  /// Tells the observers that the run is over. To be called once.
  void finish();

  /// Queues an order for the step it names; orders of one step are applied in the order in which
  /// they came. Gives why an order is refused (its step is over, nobody accepts its kind), else "".
  [[nodiscard]] std::string submit(const Order& order);
  /// All orders accepted so far, by step.
  [[nodiscard]] std::span<const Order> orders() const { return orders_; }
  /// Those of a step.
  [[nodiscard]] std::span<const Order> orders_for(std::uint64_t step) const;

  /// One step; the events are good until the next one. After a fault nothing happens any more.
  std::span<const Event> step();
  /// Why the step after world() cannot be made; null if nothing is known against it.
  [[nodiscard]] const Fault* fault() const { return fault_ ? &*fault_ : nullptr; }
  /// The step that is being made ends here, with this fault: for whoever is called in the middle of
  /// it because the program is about to end. Needs steps_per_copy = 1.
  void fail(Fault fault);
  /// Takes a fault back: the step after world() may be tried again.
  void forgive();

  /// The first thing that a paranoid run found, if any.
  [[nodiscard]] const std::optional<Difference>& difference() const { return difference_; }

 private:
  std::shared_ptr<const Simulation> simulation_;
  World world_;
  Workspace work_;
  std::optional<Paranoid> paranoid_;
  std::vector<Order> orders_;
  std::vector<Observer*> observers_;
  std::optional<Difference> difference_;
  World copy_;  ///< of world_, at most steps_per_copy_ older
  std::uint64_t steps_per_copy_;
  NumberCheck numbers_;
  Every check_;  ///< in one simulated second
  std::optional<Fault> fault_;

  void end_with(Fault fault);
};

}  // namespace eyrie::sim
