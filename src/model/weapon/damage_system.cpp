// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include <algorithm>

#include "model/events.hpp"

namespace eyrie::model::weapon {

namespace {

constexpr std::array kOrders{sim::OrderKind(OrderKind::lose)};

/// Whether somebody has already left in this step.
bool has_left(std::span<const sim::Event> events, PlayerId who) {
  return std::ranges::any_of(events, [&](const sim::Event& event) {
    return event.who == who && (event.kind == EventKind::crash || event.kind == EventKind::home ||
                                event.kind == EventKind::loss);
  });
}

}  // namespace

sim::Order lose_order(std::uint64_t step, PlayerId player) {
  return {.step = step, .player = player, .kind = OrderKind::lose};
}

std::span<const sim::OrderKind> DamageSystem::accepts() const {
  return kOrders;
}

void DamageSystem::apply_order(sim::World& world, const sim::StepInfo&, const sim::Order& order,
                               sim::Outbox& out) const {
  if (has_left(out.events(), order.player))
    return;
  const auto lose = [&](const MovingTable& moving) {
    if (const auto row = world.row(moving.table, order.player))
      out.emit({.kind = EventKind::loss,
                .who = order.player,
                .place = world.rows(moving.kinematics)[*row].position});
  };
  lose({aircraft_.table, aircraft_.kinematics});
  for (const MovingTable& other : others_)
    lose(other);
}

void DamageSystem::commit(sim::World& world, const sim::StepInfo&,
                          std::span<const sim::Event> events, sim::CommitContext& context) const {
  for (const sim::Event& event : events) {
    if (event.kind == EventKind::crash || event.kind == EventKind::home ||
        event.kind == EventKind::loss) {
      context.remove(event.who);
      continue;
    }
    if (event.kind != EventKind::hit)
      continue;
    const auto row = world.row(aircraft_.table, event.whom);
    if (!row)
      continue;
    Damage& damage = world.rows(aircraft_.damage)[*row];
    const bool alive = damage.damage < 1;
    damage.damage += static_cast<double>(event.values[0]);
    damage.last_hit_by = event.who;
    ++damage.hits;
    if (!alive || damage.damage < 1 || has_left(events, event.whom))
      continue;
    context.emit({.kind = EventKind::kill,
                  .detail = event.detail,
                  .who = event.who,
                  .whom = event.whom,
                  .place = event.place});
    context.remove(aircraft_.table, *row);
  }
}

}  // namespace eyrie::model::weapon
