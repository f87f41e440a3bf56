// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include "model/events.hpp"
#include "model/flight/abreast.hpp"
#include "model/flight/collision.hpp"

namespace eyrie::model::flight {
namespace {

std::size_t station_index(const weapon::Station& station) {
  return station.store * std::size_t{256} + station.count;
}

}  // namespace

Kinematics placed(const Reference& reference, const Environment& environment, const Vec3& position,
                  double heading, double speed) {
  Kinematics k;
  k.position = position;
  set_vertical(k, reference.vertical_at(position));
  const Vec3 wind = environment.wind.at(k.altitude);
  const auto [sine, cosine] = math::sin_cos(heading);
  k.heading = wrap_pi(heading);
  k.speed = speed;
  k.velocity = (speed * cosine + wind.x) * k.north + (speed * sine + wind.y) * k.east;
  k.mach = speed / environment.atmosphere.at(k.altitude).speed_of_sound;
  return k;
}

FlightSystem::FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library,
                           std::uint32_t period)
    : columns_(columns), library_(std::move(library)), period_(period) {
  for (std::size_t i = 0; i < library_->airframes.size(); ++i)
    models_.emplace_back(library_->airframes[i]);
  for (const Flight& flight : library_->flights)
    routes_.emplace_back(flight.routes);
  routes_.emplace_back();
  loads_.resize(station_index({static_cast<std::uint8_t>(library_->missiles.size()), 255}) + 1,
                math::Lanes<2>(0));
  for (std::size_t i = 0; i < library_->missiles.size(); ++i)
    for (std::size_t count = 0; count <= 255; ++count)
      loads_[station_index({static_cast<std::uint8_t>(i + 1), static_cast<std::uint8_t>(count)})] =
          math::Lanes<2>(static_cast<double>(count)) *
          math::Lanes<2>(math::Lanes<2>::Vector{library_->missiles[i].motor.launch_mass(),
                                                library_->missiles[i].carriage_drag_area});
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i) {
    const AircraftType& type = library_->aircraft[i];
    EYRIE_THROW_UNLESS(type.index.airframe < models_.size(), "an aircraft without an airframe");
    types_.push_back({type.index.airframe, type.dynamics});
  }
}

Load FlightSystem::load_of(const weapon::Stores& stores) const {
  math::Lanes<2> load(0);
  for (const weapon::Station& station : stores.stations)
    load += loads_[station_index(station)];
  return {.mass = load.v[0], .drag_area = load.v[1]};
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

  const Sky sky{library_->reference, library_->environment, time, info.dt};
  constexpr std::size_t kAbreast = 4;
  for (std::size_t begin = chunk.begin, end; begin < chunk.end; begin = end) {
    end = std::min(begin + kAbreast, chunk.end);
    std::array<Flyer, kAbreast> flyers;
    std::array<std::size_t, kAbreast> rows_of;
    std::size_t count = 0;
    std::uint32_t dry = 0;  // a bit for each row
    for (std::size_t i = begin; i < end; ++i) {
      if (fit[i].remote != 0)
        continue;
      const Type& type = types_[fit[i].type];
      Flyer& f = flyers[count];
      f.model = &models_[type.airframe];
      f.kinematics = &kinematics[i];
      f.flying = &flying[i];
      f.propulsion = &propulsion[i];
      f.command = &command[i];
      f.routes = routes_[std::min<std::size_t>(fit[i].flight, routes_.size() - 1)];
      if (type.dynamics == Dynamics::laero) {
        fly_laero(sky, f);
        dry |= f.ran_dry ? 1u << (i - begin) : 0;
        continue;
      }
      f.load = load_of(stores[i]);
      f.tells_energy = sim::due(info.step + 1, ids[i], period_);
      rows_of[count++] = i - begin;
    }
    fly(sky, std::span(flyers).first(count));
    for (std::size_t i = 0; i < count; ++i)
      dry |= flyers[i].ran_dry ? 1u << rows_of[i] : 0;
    for (std::size_t i = begin; dry != 0; ++i, dry >>= 1)
      if ((dry & 1) != 0)
        out.emit({.kind = EventKind::fuel_out, .who = ids[i], .place = kinematics[i].position});
  }
}

void FlightSystem::interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                            sim::Outbox& out) const {
  const auto ids = world.ids(columns_.table);
  const auto fit = world.rows(columns_.fit);
  const auto kinematics = world.rows(columns_.kinematics);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    if (kinematics[i].altitude < 0 && fit[i].remote == 0)
      out.emit({.kind = EventKind::crash, .who = ids[i], .place = kinematics[i].position});

  // ten times a second, over the way flown since the last time
  const auto every = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(0.1 / info.dt + 0.5));
  if (info.step % every == 0)
    for_each_collision(kinematics, chunk.begin, chunk.end, static_cast<double>(every) * info.dt,
                       [&](std::size_t i, std::size_t other) {
                         if (fit[i].remote == 0)
                           out.emit({.kind = EventKind::crash,
                                     .who = ids[i],
                                     .whom = ids[other],
                                     .place = kinematics[i].position});
                       });
}

}  // namespace eyrie::model::flight
