// SPDX-License-Identifier: MIT
#include "sim/paranoid.hpp"

namespace eyrie::sim {

Paranoid::Paranoid(const Simulation& simulation, const World& like, unsigned workers)
    : simulation_(simulation), second_(simulation, workers), again_(like) {
  second_.check_writes(like);
}

std::optional<Difference> Paranoid::step(World& world, Workspace& work,
                                         std::span<const Order> orders) {
  again_ = world;
  const std::span<const Event> events = simulation_.step(world, work, orders);
  if (work.fault())
    return std::nullopt;
  const std::span<const Event> events_again = simulation_.step(again_, second_, orders);

  if (!world.same_bytes(again_)) {
    if (auto found = first_difference(world, again_))
      return found;
  }
  if (auto found = first_difference(world.step() - 1, events, events_again))
    return found;
  if (auto found = second_.write_check()->take())
    return found;
  if (!world.canonical())
    return Difference{.step = world.step(),
                      .field = "form",
                      .left = "not canonical (a write beyond the live rows, or a changed id)",
                      .right = "as it should be"};
  return std::nullopt;
}

}  // namespace eyrie::sim
