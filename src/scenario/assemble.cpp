// SPDX-License-Identifier: MIT
#include "scenario/assemble.hpp"

#include "core/angle.hpp"
#include "core/math.hpp"
#include "driver/driver_system.hpp"
#include "model/flight/flight_system.hpp"
#include "model/motion_check.hpp"
#include "model/sensor/sensor_system.hpp"
#include "model/vehicle/vehicle.hpp"
#include "model/vehicle/vehicle_system.hpp"
#include "model/weapon/gun.hpp"
#include "model/weapon/systems.hpp"
#include "pilot/pilot_system.hpp"
#include "sim/system.hpp"

namespace eyrie::scenario {
namespace {

/// Missiles that can be in the air at once: all that hang under all aircraft.
std::uint32_t all_missiles(std::span<const Start> starts) {
  std::uint32_t count = 0;
  for (const Start& s : starts)
    for (const model::Station& station : s.stations)
      if (station.store)
        count += station.count;
  return std::max<std::uint32_t>(count, 1);
}

void populate(const Scenario& scenario, std::span<const Start> starts, sim::World& world) {
  const model::AircraftColumns& c = scenario.aircraft;
  const model::Library& library = *scenario.library;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Start& s = starts[i];
    const auto born = world.spawn(c.table);
    EYRIE_DEMAND(born && born->id.value == i + 1, "aircraft are born in the order of the roster");
    const std::uint32_t row = born->row;
    c.set_defaults(world, row);
    const Roster::Player& player = scenario.roster.players[i];
    const model::AircraftType& type = library.aircraft[s.type];

    model::Kinematics& k = world.rows(c.kinematics)[row];
    k = model::flight::placed(library.reference, library.environment, s.position, s.heading,
                              s.speed);
    if (player.remote)
      k.position = model::kNowhere;  // until it is heard of
    world.rows(c.fit)[row] = {.type = s.type,
                              .flight = player.flight,
                              .rank = static_cast<std::uint8_t>(player.rank),
                              .remote = player.remote,
                              .side = player.side,
                              .privileged = s.privileged};
    model::Command command{.heading = k.heading, .altitude = k.altitude, .speed = s.speed};
    if (!s.tree && !library.flights[player.flight].routes.empty())
      command.mode = model::AutopilotMode::route;
    world.rows(c.command)[row] = command;
    world.rows(c.propulsion)[row] = {.fuel = s.fuel};
    model::Stores stores;
    stores.stations = s.stations;
    world.rows(c.stores)[row] = stores;
    model::GunState gun;
    if (type.index.gun)
      gun = model::weapon::loaded(library.guns[*type.index.gun]);
    if (s.rounds)
      gun.rounds = *s.rounds;
    world.rows(c.gun)[row] = gun;
    if (type.index.dispenser)
      world.rows(c.decoys)[row] = model::weapon::loaded(library.dispensers[*type.index.dispenser]);
    world.rows(scenario.pilots.agent)[row] = {
        .bingo = s.bingo, .tree = player.remote ? pilot::kNoTree : s.tree.value_or(pilot::kNoTree)};
  }
}

void park(const Scenario& scenario, std::span<const VehicleStart> starts, sim::World& world) {
  const model::VehicleColumns& c = *scenario.vehicles;
  for (const VehicleStart& s : starts) {
    const auto born = world.spawn(c.table);
    EYRIE_DEMAND(born && scenario.roster.find(born->id), "vehicles are born behind the aircraft");
    const std::uint32_t row = born->row;
    const Roster::Player& player = *scenario.roster.find(born->id);
    c.set_defaults(world, row);
    world.rows(c.kinematics)[row] =
        model::vehicle::parked(scenario.library->reference, s.position, s.heading, s.speed);
    world.rows(c.fit)[row] = {.type = s.type,
                              .flight = player.flight,
                              .rank = static_cast<std::uint8_t>(player.rank),
                              .side = player.side};
    // until the tree says something, which it may never do: without a way there is nowhere to go
    const bool goes = s.tree && !scenario.library->flights[player.flight].routes.empty();
    world.rows(c.command)[row] = {.heading = wrap_pi(s.heading), .speed = goes ? s.speed : 0};
    world.rows(scenario.drivers.agent)[row] = {.tree = s.tree.value_or(team::kNoTree)};
  }
}

class AircraftFleet final : public Fleet {
 public:
  AircraftFleet(const Scenario& scenario, const pilot::PilotSystem* pilots)
      : Fleet({.name = "aircraft",
               .plural = "aircraft",
               .group = "flight",
               .there = "in the air",
               .acmi = "Air+FixedWing",
               .comes_home = true}),
        columns_(scenario.aircraft) {
    trees = scenario.trees->all();
    agents = pilots;
    fit = columns_.fit;
    kinematics = columns_.kinematics;
  }
  [[nodiscard]] Gauges gauges(const sim::World& world, std::size_t row) const override {
    const model::Kinematics& k = motion(world, row);
    Gauges gauges{.mach = k.mach, .load_factor = k.load_factor};
    if (!world.rows(columns_.fit)[row].remote)  // nobody tells what others have
      gauges.fuel = world.rows(columns_.propulsion)[row].fuel;
    const auto& tracks = world.rows(columns_.tracks)[row];
    const TrackId target = world.rows(columns_.request)[row].target;
    for (std::uint32_t i = 0; i < tracks.count; ++i)
      if (target && tracks.tracks[i].id == target)
        gauges.locked = tracks.tracks[i].truth;
    return gauges;
  }

 private:
  model::AircraftColumns columns_;
};

class VehicleFleet final : public Fleet {
 public:
  VehicleFleet(const Scenario& scenario, const driver::DriverSystem* drivers)
      : Fleet({.name = "vehicle",
               .plural = "vehicles",
               .group = "convoy",
               .there = "on the ground",
               .acmi = "Ground+Vehicle"}) {
    trees = scenario.driver_trees->all();
    agents = drivers;
    if (!scenario.vehicles)
      return;
    columns_ = *scenario.vehicles;
    fit = columns_.fit;
    kinematics = columns_.kinematics;
  }
  void count(const sim::World& world, const model::Library& library,
             std::span<Standing> standings) const override {
    for (std::size_t i = 0; i < rows(world); ++i) {
      const std::uint16_t flight = world.rows(fit)[i].flight;
      const auto& routes = library.flights[flight].routes;
      const model::NavState& nav = world.rows(columns_.driving)[i].nav;
      Standing& convoy = standings[flight];
      ++convoy.players;
      convoy.moving |= motion(world, i).speed > 0;
      convoy.at_the_end |=
          nav.route < routes.size() && nav.leg >= routes[nav.route].waypoints.size();
    }
  }

 private:
  model::VehicleColumns columns_;
};

}  // namespace

Vec3 beside(const Reference& reference, const Vec3& lead, double heading, const Vec3& offset) {
  const Vertical at = reference.vertical_at(lead);
  const auto [sin, cos] = math::sin_cos(heading);
  const Vec3 ned{offset.x * cos - offset.y * sin, offset.x * sin + offset.y * cos, 0};
  const Vec3 level = lead + from_ned(at, ned);
  return at_altitude(reference, level.x, level.y, at.altitude - offset.z);
}

sim::World Scenario::world(std::uint64_t seed) const {
  sim::World world = *start;
  begin(world, seed);
  return world;
}

void Scenario::begin(sim::World& world, std::uint64_t seed) const {
  world = *start;
  world.set_seed(seed);
  scatter(spreads, library->reference, library->environment, aircraft, world);
}

std::string assemble(Scenario& scenario, std::span<const Start> starts,
                     std::span<const VehicleStart> vehicles,
                     std::span<const std::unique_ptr<PlayerKind>> kinds) {
  const double dt = 1 / scenario.spec.rates.kinematics;
  const sim::Period decisions = sim::period_steps(scenario.spec.rates.decisions, dt);
  if (!decisions)
    return "decisions: " + decisions.error;

  sim::SchemaBuilder schema;
  scenario.aircraft = model::AircraftColumns::define(
      schema, static_cast<std::uint32_t>(std::max<std::size_t>(starts.size(), 1)));
  scenario.missiles = model::MissileColumns::define(schema, all_missiles(starts));
  scenario.pilots = pilot::PilotColumns::define(
      schema, scenario.aircraft.table, static_cast<std::uint32_t>(scenario.trees->max_memory()));
  if (std::ranges::any_of(scenario.roster.players, &Roster::Player::remote))
    scenario.remote =
        model::RemoteColumns::define(schema, scenario.aircraft.table, scenario.missiles.table);
  if (!vehicles.empty()) {
    scenario.vehicles =
        model::VehicleColumns::define(schema, static_cast<std::uint32_t>(vehicles.size()));
    scenario.drivers = driver::DriverColumns::define(
        schema, scenario.vehicles->table,
        static_cast<std::uint32_t>(scenario.driver_trees->max_memory()));
  }
  for (std::size_t i = 0; i < starts.size(); ++i)
    if (starts[i].spread && !scenario.roster.players[i].remote)
      scenario.spreads.push_back(*starts[i].spread);
  std::vector<model::weapon::MovingTable> others;
  if (scenario.vehicles)
    others.push_back({scenario.vehicles->table, scenario.vehicles->kinematics});
  for (const auto& kind : kinds)
    if (!kind->is_empty())
      others.push_back(kind->define(schema));

  sim::SimulationBuilder builder(schema.build(), dt);
  builder.add<model::sensor::SensorSystem>(scenario.aircraft, scenario.missiles, scenario.library,
                                           dt);
  const auto& pilots =
      builder.add<pilot::PilotSystem>(pilot::PilotSetup{.columns = scenario.aircraft,
                                                        .agents = scenario.pilots,
                                                        .library = scenario.library,
                                                        .trees = scenario.trees,
                                                        .plans = scenario.formations,
                                                        .dt = dt,
                                                        .period = decisions.steps});
  const driver::DriverSystem* drivers = nullptr;
  if (scenario.vehicles) {
    builder.add<model::vehicle::VehicleSystem>(*scenario.vehicles, scenario.aircraft,
                                               scenario.library, dt);
    drivers = &builder.add<driver::DriverSystem>(driver::DriverSetup{.columns = *scenario.vehicles,
                                                                     .agents = scenario.drivers,
                                                                     .library = scenario.library,
                                                                     .trees = scenario.driver_trees,
                                                                     .plans = scenario.convoys,
                                                                     .dt = dt,
                                                                     .period = decisions.steps});
  }
  for (const auto& kind : kinds)
    if (!kind->is_empty())
      kind->add_systems(builder, scenario, dt, decisions.steps);
  builder.add<model::weapon::MissileSystem>(scenario.aircraft, scenario.missiles, scenario.library,
                                            dt);
  builder.add<model::weapon::StoresSystem>(scenario.aircraft, scenario.missiles, scenario.library);
  builder.add<model::weapon::GunSystem>(scenario.aircraft, scenario.library);
  if (scenario.remote) {
    builder.add<model::RemoteSystem>(scenario.aircraft, scenario.missiles, *scenario.remote,
                                     scenario.library);
    builder.add<model::RemoteMissiles>(scenario.missiles, *scenario.remote, scenario.library);
  }
  builder.add<model::flight::FlightSystem>(scenario.aircraft, scenario.library, decisions.steps);
  builder.add<model::MotionCheck>(scenario.aircraft.table, scenario.aircraft.kinematics);
  builder.add<model::MotionCheck>(scenario.missiles.table, scenario.missiles.kinematics);
  for (const model::weapon::MovingTable& other : others)
    builder.add<model::MotionCheck>(other.table, other.kinematics);
  builder.add<model::weapon::DamageSystem>(scenario.aircraft, std::move(others));
  scenario.simulation = builder.build();
  scenario.fleets = {std::make_shared<AircraftFleet>(scenario, &pilots),
                     std::make_shared<VehicleFleet>(scenario, drivers)};
  for (const auto& kind : kinds)
    scenario.fleets.push_back(kind->fleet());

  sim::World world = scenario.simulation->world(scenario.spec.seed);
  populate(scenario, starts, world);
  park(scenario, vehicles, world);
  for (const auto& kind : kinds)
    if (!kind->is_empty())
      kind->populate(scenario, world);
  scenario.start = std::move(world);
  return {};
}

Vec3 at_altitude(const Reference& reference, double north, double east, double altitude) {
  // moving down by what the height is off converges by a factor of 1 - cos(tilt) < 0.4 % each time
  // the Earth is symmetric about the reference's meridian, its rounding is not: look east only
  Vec3 p{north, std::fabs(east), -altitude};
  for (int i = 0; i < 8; ++i)
    p.z += reference.altitude_at(p) - altitude;
  p.y = east;
  return p;
}

Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
             const Location& where, Diagnostics& diagnostics) {
  const bool local = place.north && place.east;
  const bool geodetic = place.latitude && place.longitude;
  const bool any_local = place.north || place.east;
  const bool any_geodetic = place.latitude || place.longitude;
  if ((local && !any_geodetic) || (geodetic && !any_local)) {
    // the ground below it, straight through the Earth: the far side is far, too
    const Vec3 ground = local ? Vec3{*place.north, *place.east, 0}
                              : reference.to_local({*place.latitude, *place.longitude, 0});
    if (const double distance = norm(ground); distance > kReach) {
      diagnostics.error(where,
                        "this place is {:.{}f} km from the reference point; the "
                        "local frame reaches {:.0f} km",
                        distance / 1000, distance < kReach + 1000 ? 3 : 0, kReach / 1000);
      return {};
    }
    return local ? at_altitude(reference, *place.north, *place.east, altitude)
                 : reference.to_local({*place.latitude, *place.longitude, altitude});
  }
  diagnostics.error(where, any_local && any_geodetic
                               ? "a place is given by north and east or by latitude and longitude, "
                                 "not by both"
                           : any_local || any_geodetic
                               ? "a place needs both north and east, or both latitude and longitude"
                               : "no place is given: north and east, or latitude and longitude");
  return {};
}

}  // namespace eyrie::scenario
