// SPDX-License-Identifier: MIT
#include "pilot/catalog.hpp"

#include "pilot/behavior/break_turn.hpp"
#include "pilot/behavior/pursue.hpp"
#include "pilot/behavior/release_weapon.hpp"
#include "pilot/behavior/shoot_gun.hpp"
#include "pilot/behavior/ways.hpp"
#include "pilot/conditions.hpp"
#include "ubf/standard_nodes.hpp"

namespace eyrie::pilot {

Registry make_registry() {
  Registry registry;
  ubf::add_standard_nodes(registry);

  registry.add<Navigate>();
  registry.add<FollowLead>();
  registry.add<Pursue>();
  registry.add<ReleaseWeapon>();
  registry.add<ShootGun>();
  registry.add<BreakTurn>();
  registry.add<Egress>();
  registry.add<AvoidGround>();

  registry.add<HostileTrack>();
  registry.add<HasTarget>();
  registry.add<InSight>();
  registry.add<AreaClear>();
  registry.add<Threatened>();
  registry.add<ShotInFlight>();
  registry.add<Bingo>();
  registry.add<Winchester>();
  registry.add<Losses>();
  registry.add<IsLead>();
  registry.add<NearHome>();
  registry.add<RouteDone>();
  return registry;
}

}  // namespace eyrie::pilot
