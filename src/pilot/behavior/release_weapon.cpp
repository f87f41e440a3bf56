// SPDX-License-Identifier: MIT
#include "pilot/behavior/release_weapon.hpp"

#include "model/weapon/stores.hpp"

namespace eyrie::pilot {

bool ReleaseWeapon::hold_fire(const State& s, const Seen& target) const {
  if (s.own_shot_flies(target.id()) && s.agent.shots_at_track >= salvo_)
    return true;
  const std::uint32_t self = 1U << s.datalink.self;
  const std::uint32_t shot_by = target.track->shot_by & ~self;
  std::uint32_t alive = 0;
  for (std::uint32_t i = 0; i < s.datalink.count; ++i)
    alive |= static_cast<std::uint32_t>(s.datalink.members[i].alive) << i;
  if (shot_by & alive)
    return true;
  // the first shooter is the best-ranked one who has it as his target
  return (target.track->targeted_by & alive & (self - 1)) != 0;
}

bool ReleaseWeapon::in_zone(const State& s, const Seen& target, std::uint16_t store) const {
  const model::EmploymentZone zone = s.zone(store, target);
  const double reach = zone.r_ne + zone_ * (zone.r_max - zone.r_ne);
  if (!zone.possible() || target.range < zone.r_min || target.range > std::max(reach, zone.r_min))
    return false;
  return target.range <= zone.r_ne || !hold_fire(s, target);
}

Status ReleaseWeapon::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  const Seen* target = s.target();
  if (!target || !target->hostile() || s.time - target->track->time > max_age_ ||
      s.off_nose(target->ned) > off_boresight_)
    return Status::failure;
  if (s.own_shot_flies(target->id()) && s.agent.shots_at_track >= salvo_)
    return Status::failure;
  // the store with the longest reach that is in its zone comes first on the stations
  for (const model::Station& station : s.stores.stations) {
    if (station.store == 0 || station.count == 0)
      continue;
    const auto store = static_cast<std::uint16_t>(station.store - 1);
    if (!model::can_release(s.stores, store, s.time) || !in_zone(s, *target, store))
      continue;
    out.action.target = target->id();
    out.action.release = Release{target->id(), store};
    out.vote = vote_;
    return Status::running;
  }
  return Status::failure;
}

}  // namespace eyrie::pilot
