// SPDX-License-Identifier: MIT
/// A world is a value: copy it in the middle of a fight, and fly the rest twice, once with another
/// tree for eagle1 from then on.
#include <fmt/format.h>

#include "pilot/pilot_system.hpp"
#include "scenario/mission.hpp"
#include "sim/difference.hpp"

using namespace eyrie;

int main() {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  const sim::Simulation& simulation = *sweep->simulation;
  sim::Workspace work(simulation);

  sim::World world = sweep->world(1);
  while (world.step() < 8 * 60 * 50)  // eight minutes
    simulation.step(world, work);
  const sim::World kept = world;  // the snapshot

  for (int i = 0; i < 100; ++i)
    simulation.step(world, work);

  sim::World again = kept;  // the rollback
  for (int i = 0; i < 100; ++i)
    simulation.step(again, work);
  fmt::print("flown again from the snapshot: {}\n",
             again.hash() == world.hash() ? "the same" : "different");

  sim::World branch = kept;
  const auto eagle1 = sweep->roster.find("eagle1").value();
  const auto homeward = sweep->trees->find("homeward").value();
  for (int i = 0; i < 100; ++i) {
    const sim::Order order = pilot::PilotSystem::swap_tree_order(branch.step(), eagle1, homeward);
    simulation.step(branch, work, i == 0 ? std::span(&order, 1) : std::span<const sim::Order>{});
  }
  const auto where = sim::first_difference(world, branch);
  fmt::print("with another tree for eagle1: {}\n", where ? where->text() : "the same");
}
