// SPDX-License-Identifier: MIT
#include "pilot/catalog.hpp"

#include "pilot/behavior/break_turn.hpp"
#include "pilot/behavior/crank.hpp"
#include "pilot/behavior/evade.hpp"
#include "pilot/behavior/maneuvers.hpp"
#include "pilot/behavior/policy.hpp"
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

  registry
      .add<Navigate, FollowLead, Pursue, ReleaseWeapon, ShootGun, BreakTurn, Egress, AvoidGround>();
  registry.add<LeadPursuit, PurePursuit, LagPursuit, HighYoYo, LowYoYo, MergeTurn, Reacquire, Jink,
               Extend, Snapshot, AvoidCollision>();
  registry.add<HostileTrack, HasTarget, InSight, AreaClear, Threatened, ShotInFlight, Bingo,
               Winchester, Losses, IsLead, NearHome, RouteDone>();
  registry.add<Policy, LearnedVote>();
  registry.add<Crank, Notch, Drag, LastDitch>();
  registry.add<Spiked, MissileInbound, AbortRange, Outnumbered, SupportNeeded, ShotActive>();
  return registry;
}

}  // namespace eyrie::pilot
