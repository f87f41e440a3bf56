// SPDX-License-Identifier: MIT
#include "model/weapon/damage_system.hpp"

#include "model/events.hpp"

namespace eyrie::model {

void DamageSystem::commit(sim::World& world, const sim::StepInfo&,
                          std::span<const sim::Event> events, sim::CommitContext& context) const {
  const auto damages = world.rows(aircraft_.damage);
  for (const sim::Event& event : events) {
    if (event.kind == EventKind::crash || event.kind == EventKind::home) {
      if (const auto row = world.row(aircraft_.table, event.who))
        context.remove(aircraft_.table, *row);
      continue;
    }
    if (event.kind != EventKind::hit)
      continue;
    const auto row = world.row(aircraft_.table, event.whom);
    if (!row)
      continue;
    Damage& damage = damages[*row];
    const bool alive = damage.damage < 1;
    damage.damage += static_cast<double>(event.values[0]);
    damage.last_hit_by = event.who;
    ++damage.hits;
    if (!alive || damage.damage < 1)
      continue;
    context.emit({.kind = EventKind::kill,
                  .detail = event.detail,
                  .who = event.who,
                  .whom = event.whom,
                  .place = event.place});
    context.remove(aircraft_.table, *row);
  }
}

}  // namespace eyrie::model
