// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include "model/events.hpp"
#include "model/flight/collision.hpp"

namespace eyrie::model::flight {
namespace {

/// m: of a level turn, with the distance flown while rolling into it.
double turn_radius(double speed, double rate, double lag) {
  return speed / std::max(rate, 1e-3) + speed * lag;
}

double level_turn_rate(double load_factor, double speed) {
  return kGravity * std::sqrt(std::max(load_factor * load_factor - 1, 0.0)) / std::max(speed, 1.0);
}

/// What the place and the speed of an aircraft decide in a step.
struct Here {
  Air air;
  FlightCondition condition;  ///< of a point mass
};
Here look(const Atmosphere& atmosphere, const PointMass& model, Dynamics dynamics,
          const Kinematics& k, double fuel, const Load& load) {
  const Air air = atmosphere.at(k.altitude);
  if (dynamics == Dynamics::laero)
    return {air, {}};
  return {air, model.condition(k, air, fuel, load)};
}

/// Flies one step, but for the vertical at the new place.
bool fly_from(const Here& here, const PointMass& model, Dynamics dynamics,
              const FlightContext& context, const FlightRows& rows) {
  const Airframe& airframe = model.airframe();
  const Command& command = rows.command;
  Kinematics& k = rows.kinematics;
  const Vec3 wind = context.environment.wind.at(k.altitude);
  const double load_factor = std::max(command.load_factor, 1.0);
  RouteToFly plan{.routes = context.routes};

  if (dynamics == Dynamics::laero) {
    const Laero& laero = airframe.laero;
    const double turn_limit = laero.turn_rate_limit(k.speed, load_factor);
    plan.turn_radius = turn_radius(k.speed, turn_limit, laero.heading_time);
    Guidance wanted =
        guide(airframe.autopilot, k, command, plan, rows.flying, wind, context.time, context.dt);
    if (wanted.climb)
      wanted.altitude += k.speed * math::sin(*wanted.climb) * laero.altitude_time;
    const auto most = static_cast<float>(1 / math::cos(laero.max_bank));
    rows.flying.energy = {
        .available = most, .sustained = most, .corner_speed = static_cast<float>(k.speed)};
    laero.step(k, rows.flying, wanted, turn_limit, rows.propulsion, here.air, wind, context.dt);
    rows.propulsion.flow = rows.propulsion.fuel > 0 ? laero.fuel_flow : 0;
  } else {
    const FlightCondition& condition = here.condition;
    const double most = std::min(load_factor, condition.lift_limit);
    plan.turn_radius =
        turn_radius(k.speed, level_turn_rate(most, k.speed), airframe.autopilot.heading_time);
    const Guidance wanted =
        guide(airframe.autopilot, k, command, plan, rows.flying, wind, context.time, context.dt);
    if (context.tells_energy)
      rows.flying.energy = model.energy(condition, k.speed);
    const Controls controls =
        steer(model, k, condition, wanted, load_factor, rows.flying.afterburner);
    model.step(k, rows.propulsion, condition, controls, wind, context.dt);
  }
  return burn(rows.propulsion, context.dt);
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

bool fly(const PointMass& model, Dynamics dynamics, const FlightContext& context,
         const FlightRows& rows) {
  Kinematics& k = rows.kinematics;
  const Here here =
      look(context.environment.atmosphere, model, dynamics, k, rows.propulsion.fuel, context.load);
  const bool dry = fly_from(here, model, dynamics, context, rows);
  set_vertical(k, context.reference.vertical_at(k.position));
  return dry;
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

  // roots and quotients that wait for each other are taken of several aircraft in a row, so that
  // the processor is at work on several such chains at a time
  constexpr std::size_t kAbreast = 8;
  for (std::size_t begin = chunk.begin, end; begin < chunk.end; begin = end) {
    end = std::min(begin + kAbreast, chunk.end);
    std::array<Here, kAbreast> here;
    for (std::size_t i = begin; i < end; ++i) {
      const Type& type = types_[fit[i].type];
      here[i - begin] = look(library_->environment.atmosphere, models_[type.airframe],
                             type.dynamics, kinematics[i], propulsion[i].fuel, load_of(stores[i]));
    }
    for (std::size_t i = begin; i < end; ++i) {
      if (fit[i].remote != 0)
        continue;
      const Type& type = types_[fit[i].type];
      FlightContext context{.reference = library_->reference,
                            .environment = library_->environment,
                            .time = time,
                            .dt = info.dt,
                            .tells_energy = sim::due(info.step + 1, ids[i], period_)};
      if (fit[i].flight < library_->flights.size())
        context.routes = library_->flights[fit[i].flight].routes;
      const bool dry = fly_from(here[i - begin], models_[type.airframe], type.dynamics, context,
                                {kinematics[i], flying[i], propulsion[i], command[i]});
      if (dry)
        out.emit({.kind = EventKind::fuel_out, .who = ids[i], .place = kinematics[i].position});
    }
    for (std::size_t i = begin; i < end; ++i)
      if (fit[i].remote == 0)
        set_vertical(kinematics[i], library_->reference.vertical_at(kinematics[i].position));
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
