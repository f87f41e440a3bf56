// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include <utility>

#include "model/events.hpp"

namespace eyrie::model::flight {

FlightSystem::FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library)
    : columns_(columns), library_(std::move(library)) {
  for (std::size_t i = 0; i < library_->airframes.size(); ++i)
    models_.emplace_back(library_->airframes[i]);
  for (std::size_t i = 0; i < library_->missiles.size(); ++i)
    stores_.push_back({.mass = library_->missiles[i].motor.launch_mass(),
                       .drag_area = library_->missiles[i].carriage_drag_area});
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i) {
    const AircraftType& type = library_->aircraft[i];
    EYRIE_THROW_UNLESS(type.index.airframe < models_.size(), "an aircraft without an airframe");
    types_.push_back({type.index.airframe, type.dynamics});
  }
}

Load FlightSystem::load_of(const weapon::Stores& stores) const {
  Load load;
  for (const weapon::Station& station : stores.stations)
    if (station.store != 0 && station.count != 0) {
      const Load& each = stores_[station.store - 1u];
      load.mass += station.count * each.mass;
      load.drag_area += station.count * each.drag_area;
    }
  return load;
}

void FlightSystem::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                        sim::Outbox& out) const {
  const auto ids = world.ids(columns_.table);
  const auto fit = world.rows(columns_.fit);
  const auto command = world.rows(columns_.command);
  const auto stores = world.rows(columns_.stores);
  const auto kinematics = world.rows(columns_.kinematics);
  const auto flying = world.rows(columns_.flying);
  const auto propulsion = world.rows(columns_.propulsion);
  const double time = info.time();

  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Type& type = types_[fit[i].type];
    FlightContext context{.reference = library_->reference,
                          .environment = library_->environment,
                          .time = time,
                          .dt = info.dt};
    if (fit[i].flight < library_->flights.size())
      context.routes = library_->flights[fit[i].flight].routes;
    if (type.dynamics == Dynamics::point_mass)
      context.load = load_of(stores[i]);
    const bool dry = fly(models_[type.airframe], type.dynamics, context,
                         {kinematics[i], flying[i], propulsion[i], command[i]});
    if (dry)
      out.emit({.kind = EventKind::fuel_out, .who = ids[i], .place = kinematics[i].position});
  }
}

void FlightSystem::interact(sim::World& world, const sim::StepInfo&, sim::Chunk chunk,
                            sim::Outbox& out) const {
  const auto ids = world.ids(columns_.table);
  const auto kinematics = world.rows(columns_.kinematics);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    if (kinematics[i].altitude < 0)
      out.emit({.kind = EventKind::crash, .who = ids[i], .place = kinematics[i].position});
}

}  // namespace eyrie::model::flight
