// SPDX-License-Identifier: MIT
#pragma once
/// \file  Makes every step twice, with different numbers of workers, and compares.
#include <optional>
#include <span>

#include "sim/difference.hpp"
#include "sim/order.hpp"
#include "sim/simulation.hpp"
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

}  // namespace eyrie::sim
