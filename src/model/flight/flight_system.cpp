// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include "model/events.hpp"
#include "model/flight/abreast.hpp"
#include "model/flight/collision.hpp"

namespace eyrie::model::flight {
namespace {

/// Flies one step of laero. True when the tanks ran dry in it.
bool fly_laero(const Sky& sky, const Flyer& flyer) {
  const Airframe& airframe = flyer.model->airframe();
  const Laero& laero = airframe.laero;
  const Command& command = *flyer.command;
  Kinematics& k = *flyer.kinematics;
  Flying& flying = *flyer.flying;
  const Air air = sky.environment.atmosphere.at(k.altitude);
  const Vec3 wind = sky.environment.wind.at(k.altitude);
  const double turn_limit = laero.turn_rate_limit(k.speed, std::max(command.load_factor, 1.0));
  const RouteToFly plan{.routes = flyer.routes,
                        .turn_radius = turn_radius(k.speed, turn_limit, laero.heading_time)};
  Guidance wanted = guide(airframe.autopilot, k, command, plan, flying, wind, sky.time, sky.dt);
  if (wanted.climb)
    wanted.altitude += k.speed * math::sin(*wanted.climb) * laero.altitude_time;
  const auto most = static_cast<float>(1 / math::cos(laero.max_bank));
  flying.energy = {
      .available = most, .sustained = most, .corner_speed = static_cast<float>(k.speed)};
  laero.step(k, flying, wanted, turn_limit, *flyer.propulsion, air, wind, sky.dt);
  flyer.propulsion->flow = flyer.propulsion->fuel > 0 ? laero.fuel_flow : 0;
  set_vertical(k, sky.reference.vertical_at(k.position));
  return burn(*flyer.propulsion, sky.dt);
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

void fly_all(const Sky& sky, std::span<Flyer> flyers) {
#ifdef __x86_64__
  static const bool has_lanes = __builtin_cpu_supports("avx2");
#else
  constexpr bool has_lanes = false;
#endif
  for (std::size_t i = has_lanes ? fly_in_lanes(sky, flyers) : 0; i < flyers.size(); ++i)
    fly_abreast<double>(sky, &flyers[i]);
}

bool fly(const PointMass& model, Dynamics dynamics, const FlightContext& context,
         const FlightRows& rows) {
  const Sky sky{context.reference, context.environment, context.time, context.dt};
  Flyer one{.model = &model,
            .kinematics = &rows.kinematics,
            .flying = &rows.flying,
            .propulsion = &rows.propulsion,
            .command = &rows.command,
            .routes = context.routes,
            .load = context.load,
            .tells_energy = context.tells_energy};
  if (dynamics == Dynamics::laero)
    return fly_laero(sky, one);
  fly_abreast<double>(sky, &one);
  return one.ran_dry;
}

FlightSystem::FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library,
                           std::uint32_t period)
    : columns_(columns), library_(std::move(library)), period_(period) {
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

  const Sky sky{library_->reference, library_->environment, time, info.dt};
  constexpr std::size_t kAbreast = 8;
  for (std::size_t begin = chunk.begin, end; begin < chunk.end; begin = end) {
    end = std::min(begin + kAbreast, chunk.end);
    std::array<Flyer, kAbreast> flyers;
    std::array<std::size_t, kAbreast> rows_of;
    std::array<bool, kAbreast> dry{};
    std::size_t count = 0;
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
      f.routes = fit[i].flight < library_->flights.size()
                     ? std::span<const Route>(library_->flights[fit[i].flight].routes)
                     : std::span<const Route>();
      if (type.dynamics == Dynamics::laero) {
        dry[i - begin] = fly_laero(sky, f);
        continue;
      }
      f.load = load_of(stores[i]);
      f.tells_energy = sim::due(info.step + 1, ids[i], period_);
      rows_of[count++] = i - begin;
    }
    fly_all(sky, std::span(flyers).first(count));
    for (std::size_t i = 0; i < count; ++i)
      dry[rows_of[i]] = flyers[i].ran_dry;
    for (std::size_t i = begin; i < end; ++i)
      if (dry[i - begin])
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
