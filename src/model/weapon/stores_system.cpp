// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include "model/events.hpp"
#include "model/kinematics.hpp"
#include "model/weapon/homing.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/stores.hpp"

namespace eyrie::model::weapon {

bool waits_for_lock(const sim::World& world, const AircraftColumns& aircraft,
                    const Library& library, std::size_t row, double time) {
  const Request& request = world.rows(aircraft.request)[row];
  const Track* target = find(world.rows(aircraft.tracks)[row], request.shoot_at);
  if (request.store == 0 || request.store > library.missiles.size() || target == nullptr)
    return false;
  const MissileType& missile = library.missiles[request.store - 1u];
  if (!missile.locks_before_launch())
    return false;
  const Kinematics& own = world.rows(aircraft.kinematics)[row];
  const SeekerView view{.position = own.position,
                        .velocity = own.velocity,
                        .axis = body_axes(own).forward,
                        .down = own.down};
  const Vec3 apart = position_at(*target, time) - own.position;
  const SearchVolume volume{.direction = normalized(apart, view.axis),
                            .except = world.ids(aircraft.table)[row]};
  return !search(missile.seeker, view, TargetScene::of(world, aircraft, library, time), volume);
}

void StoresSystem::act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                       sim::Outbox& out) const {
  const auto requests = std::as_const(world).rows(aircraft_.request);
  const auto stores = std::as_const(world).rows(aircraft_.stores);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Request& request = requests[i];
    if (request.dispense != Dispense::none)
      dispense(world, info, i, out);
    if (stores[i].pending_track || (request.store != 0 && request.shoot_at))
      release(world, info.time(), i, out);
  }
}

void StoresSystem::release(sim::World& world, double time, std::size_t row,
                           sim::Outbox& out) const {
  const Request& request = std::as_const(world).rows(aircraft_.request)[row];
  const TrackFile& tracks = std::as_const(world).rows(aircraft_.tracks)[row];
  const Kinematics& own = std::as_const(world).rows(aircraft_.kinematics)[row];
  const PlayerId id = world.ids(aircraft_.table)[row];
  Stores& stores = world.rows(aircraft_.stores)[row];

  // a launch that is under way
  const Track* pending = find(tracks, stores.pending_track);
  if (const auto ejection = finish_release(stores, pending != nullptr, time)) {
    out.emit({.kind = EventKind::eject,
              .aux = ejection->station,
              .detail = ejection->track.value,
              .who = id,
              .whom = pending->truth,
              .place = own.position,
              .values = {static_cast<float>(ejection->type), ejection->last ? 1.0F : 0.0F}});
  }

  // a new one
  const Track* target = find(tracks, request.shoot_at);
  if (request.store == 0 || request.store > library_->missiles.size() || target == nullptr)
    return;
  const auto type = static_cast<std::uint16_t>(request.store - 1);
  if (!can_release(stores, type, time) || waits_for_lock(world, aircraft_, *library_, row, time))
    return;
  begin_release(stores, type, library_->missiles[type], request.shoot_at, time);
  const double range = norm(position_at(*target, time) - own.position);
  out.emit({.kind = EventKind::release,
            .who = id,
            .whom = target->truth,
            .place = own.position,
            .values = {static_cast<float>(type), static_cast<float>(range)}});
}

void StoresSystem::dispense(sim::World& world, const sim::StepInfo& info, std::size_t row,
                            sim::Outbox& out) const {
  const auto& index = library_->aircraft[world.rows(aircraft_.fit)[row].type].index.dispenser;
  if (!index)
    return;
  Decoys& decoys = world.rows(aircraft_.decoys)[row];
  const Kinematics& own = std::as_const(world).rows(aircraft_.kinematics)[row];
  const Request& request = std::as_const(world).rows(aircraft_.request)[row];
  const Dispense thrown = throw_out(library_->dispensers[*index], request.dispense, own.position,
                                    own.velocity, info.time(), info.step, decoys);
  if (thrown != Dispense::none)
    out.emit({.kind = EventKind::dispense,
              .who = world.ids(aircraft_.table)[row],
              .place = own.position,
              .values = {static_cast<float>(thrown), static_cast<float>(decoys.chaff),
                         static_cast<float>(decoys.flares)}});
}

void StoresSystem::commit(sim::World& world, const sim::StepInfo& info,
                          std::span<const sim::Event> events, sim::CommitContext& context) const {
  for (const sim::Event& event : events)
    if (event.kind == EventKind::eject)
      launch(world, info, event, context);
    else if (event.kind == EventKind::timeout &&
             event.values[0] == static_cast<float>(MissileEnd::decoy))
      lose_towed(world, info.time() + info.dt, event.whom);
}

void StoresSystem::lose_towed(sim::World& world, double time, PlayerId who) const {
  const auto row = world.row(aircraft_.table, who);
  if (!row)
    return;
  const auto& index = library_->aircraft[world.rows(aircraft_.fit)[*row].type].index.dispenser;
  Decoys& decoys = world.rows(aircraft_.decoys)[*row];
  if (!index || decoys.towed == 0 || time < decoys.tow_time)
    return;  // two missiles may reach it in one step
  --decoys.towed;
  decoys.tow_time = time + library_->dispensers[*index].tow_time;
}

void StoresSystem::launch(sim::World& world, const sim::StepInfo& info, const sim::Event& eject,
                          sim::CommitContext& context) const {
  const auto row = world.row(aircraft_.table, eject.who);
  if (!row)
    return;
  const TrackId track_id{eject.detail};
  const Track* track = find(world.rows(aircraft_.tracks)[*row], track_id);
  if (track == nullptr)
    return;
  const auto born = context.spawn(missiles_.table);
  if (!born)
    return;  // no room: World::refused_births() counts it
  const auto type = static_cast<std::uint16_t>(eject.values[0]);
  const Kinematics& shooter = world.rows(aircraft_.kinematics)[*row];
  const Newborn missile = launched({.type = library_->missiles[type],
                                    .type_index = type,
                                    .shooter = eject.who,
                                    .side = world.rows(aircraft_.fit)[*row].side,
                                    .time = info.time() + info.dt},
                                   shooter, *track);
  world.rows(missiles_.kinematics)[born->row] = missile.kinematics;
  world.rows(missiles_.state)[born->row] = missile.state;
  const double range = norm(missile.state.target_position - shooter.position);
  context.emit({.kind = EventKind::launch,
                .detail = eject.who.value,
                .who = born->id,
                .whom = track->truth,
                .place = shooter.position,
                .values = {static_cast<float>(range), static_cast<float>(type)}});
  if (eject.values[1] != 0)
    context.emit({.kind = EventKind::winchester, .who = eject.who, .place = shooter.position});
}

}  // namespace eyrie::model::weapon
