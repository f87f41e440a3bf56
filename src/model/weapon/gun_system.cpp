// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include "model/events.hpp"
#include "model/weapon/gun.hpp"

namespace eyrie::model::weapon {

namespace {

/// Who is nearest to the sight of a gun.
struct InSight {
  std::size_t row = 0;
  Lead lead;
};
std::optional<InSight> in_sight(const GunType& gun, double density, std::size_t self,
                                std::span<const Kinematics> everybody) {
  const Kinematics& own = everybody[self];
  const Vec3 nose = body_axes(own).forward;
  std::optional<InSight> best;
  for (std::size_t row = 0; row < everybody.size(); ++row) {
    const Vec3 apart = everybody[row].position - own.position;
    if (row == self || norm2(apart) > gun.greatest_range * gun.greatest_range ||
        dot(apart, nose) <= 0)
      continue;
    const Lead lead = lead_on(gun, density, own, nose, everybody[row]);
    if (!best || lead.off_bore < best->lead.off_bore)
      best = InSight{row, lead};
  }
  return best;
}

void end_burst(PlayerId who, const Vec3& place, GunState& gun, sim::Outbox& out) {
  if (gun.burst_rounds != 0)
    out.emit({.kind = EventKind::gun_burst,
              .who = who,
              .whom = gun.burst_target,
              .place = place,
              .values = {static_cast<float>(gun.burst_rounds),
                         gun.burst_target ? static_cast<float>(gun.burst_range) : kNothing,
                         static_cast<float>(gun.burst_hits)}});
  gun.owed = 0;
  gun.burst_range = 0;
  gun.burst_rounds = 0;
  gun.burst_hits = 0;
  gun.burst_target = {};
}

}  // namespace

void GunSystem::interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                         sim::Outbox& out) const {
  const auto requests = std::as_const(world).rows(aircraft_.request);
  const auto guns = std::as_const(world).rows(aircraft_.gun);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    if (requests[i].trigger != 0 || guns[i].burst_rounds != 0)
      use(world, info, i, out);
}

void GunSystem::use(sim::World& world, const sim::StepInfo& info, std::size_t self,
                    sim::Outbox& out) const {
  const auto ids = world.ids(aircraft_.table);
  const auto fit = world.rows(aircraft_.fit);
  const auto kinematics = std::as_const(world).rows(aircraft_.kinematics);
  GunState& state = world.rows(aircraft_.gun)[self];
  const auto end = [&] { end_burst(ids[self], kinematics[self].position, state, out); };

  const auto& mounted = library_->aircraft[fit[self].type].index.gun;
  if (!mounted || std::as_const(world).rows(aircraft_.request)[self].trigger == 0 ||
      state.rounds == 0) {
    if (state.burst_rounds != 0)
      end();
    return;
  }
  const GunType& gun = library_->guns[*mounted];
  const double density = library_->environment.atmosphere.at(kinematics[self].altitude).density;
  const auto target = in_sight(gun, density, self, kinematics);
  const double chance =
      target
          ? hit_probability(gun, target->lead, library_->aircraft[fit[target->row].type].signature,
                            kinematics[target->row])
          : 0;
  // another one takes the burst over as soon as it can hit him
  if (target && (state.burst_rounds == 0 || !state.burst_target ||
                 (state.burst_target != ids[target->row] && chance > 0))) {
    if (state.burst_target) {  // to each his own burst; the gun fires on
      const double owed = state.owed;
      end();
      state.owed = owed;
    }
    state.burst_target = ids[target->row];
    state.burst_range = target->lead.range;
  }

  const std::uint32_t rounds = fire(gun, info.dt, state);
  std::uint32_t hits = 0;
  if (target) {
    Draw draw(info.seed, ids[self], Stream::gun, info.step);
    for (std::uint32_t round = 0; chance > 0 && round < rounds; ++round)
      hits += draw.chance(chance) ? 1 : 0;
    if (hits != 0 && fit[target->row].remote == 0)
      out.emit({.kind = EventKind::hit,
                .who = ids[self],
                .whom = ids[target->row],
                .place = kinematics[target->row].position,
                .values = {static_cast<float>(hits * gun.damage), kNothing}});
  }
  state.burst_hits += hits;
  if (state.rounds == 0 || state.burst_rounds >= gun.longest_burst * gun.rate)
    end();
}

}  // namespace eyrie::model::weapon
