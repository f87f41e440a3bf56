// SPDX-License-Identifier: MIT
/// \file  What flying costs: bare loops over rows without the framework, and the system in a world
/// beside them, so that the framework's own share can be read as a ratio. Times are per aircraft
/// and step ("ns"); "allocs" counts heap allocations per step.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/flight/abreast.hpp"
#include "model/flight/flight_system.hpp"
#include "sim/simulation.hpp"
#include "support/model/lapse.hpp"
#include "support/no_allocation.hpp"

namespace {

using namespace eyrie;
using namespace eyrie::model;

constexpr double kDt = sim::kDefaultDt;

/// A twin-engined fighter with tables of the size that data/ has.
Airframe fighter() {
  Airframe a;
  a.empty_mass = 12700;
  a.internal_fuel = 5950;
  a.aerodynamics.wing_area = 56.5;
  a.aerodynamics.zero_lift_drag = Table1(
      {0, 0.85, 0.9, 0.95, 1, 1.05, 1.2, 1.4, 1.6, 1.8, 2, 2.25, 2.5},
      {0.019, 0.019, 0.02, 0.024, 0.03, 0.038, 0.037, 0.035, 0.034, 0.033, 0.032, 0.03, 0.029});
  a.aerodynamics.induced_drag = Table1({0, 0.9, 1.05, 1.2, 1.4, 1.6, 1.8, 2, 2.25, 2.5},
                                       {0.12, 0.12, 0.12, 0.16, 0.21, 0.26, 0.3, 0.34, 0.39, 0.44});
  a.aerodynamics.max_lift = Table1({0, 0.6, 0.8, 0.9, 1, 1.2, 1.6, 2, 2.5},
                                   {1.15, 1.1, 0.98, 0.9, 0.85, 0.75, 0.6, 0.48, 0.38});
  const std::vector<double> mach{0,   0.2, 0.4, 0.6, 0.8, 0.9,  1,  1.1,
                                 1.2, 1.4, 1.6, 1.8, 2,   2.25, 2.5};
  std::vector<double> altitude, dry, wet;
  for (int i = 0; i <= 14; ++i)
    altitude.push_back(si(5000, "ft") * i);
  for (const double m : mach)
    for (const double h : altitude) {
      dry.push_back(std::max(180e3 * flight::military_lapse(m, standard_air(h), 1.07), 100.0));
      wet.push_back(std::max(200e3 * flight::afterburner_lapse(m, standard_air(h), 1.07), 100.0));
    }
  a.engine.military = Table2(mach, altitude, dry);
  a.engine.afterburner = Table2(mach, altitude, wet);
  return a;
}

/// What the aircraft of a loop do: all the same, each at its own place and phase.
enum class Task { straight, turning, following, routing };

struct Row {
  Kinematics kinematics;
  Flying flying;
  Propulsion propulsion;
  Command command;
};

struct Loop {
  explicit Loop(flight::Dynamics d, Task task) : model(fighter()), dynamics(d) {
    routes = {{.name = "mission",
               .waypoints = {{.position = {100e3, 0, 0}, .altitude = 6000, .speed = 240},
                             {.position = {100e3, 100e3, 0}, .altitude = 6000, .speed = 240},
                             {.position = {-100e3, -100e3, 0}, .altitude = 6000, .speed = 240}},
               .end = flight::RouteEnd::repeat}};
    for (int i = 0; i < 64; ++i) {
      Row row;
      row.kinematics =
          flight::placed(reference, environment, {200.0 * i, 900.0 * i, -6000}, 0.1 * i, 240);
      row.propulsion.fuel = 5000;
      row.command = {.heading = 0.1 * i, .altitude = row.kinematics.altitude, .speed = 240};
      if (task == Task::following)
        row.command.mode = AutopilotMode::follow;
      if (task == Task::routing)
        row.command.mode = AutopilotMode::route;
      turns = task == Task::turning;
      row.command.reference_position = row.kinematics.position + Vec3{500, 1800, 0};
      row.command.reference_velocity = row.kinematics.velocity;
      rows.push_back(row);
    }
  }
  void step() {
    const flight::Sky sky{reference, environment, kDt};
    for (Row& row : rows) {
      if (turns)
        row.command.heading = row.kinematics.heading + 1;
      row.propulsion.fuel = 5000;
      flight::Flyer flyer{.model = &model,
                          .kinematics = &row.kinematics,
                          .flying = &row.flying,
                          .propulsion = &row.propulsion,
                          .command = &row.command,
                          .routes = routes,
                          .load = {.mass = 600, .drag_area = 0.06},
                          .time = time};
      if (dynamics == flight::Dynamics::laero)
        flight::fly_laero(sky, flyer);
      else
        flight::fly(sky, std::array{&flyer});
      benchmark::DoNotOptimize(flyer.ran_dry);
    }
    time += kDt;
  }

  flight::PointMass model;
  flight::Dynamics dynamics;
  bool turns = false;
  Reference reference;
  Environment environment;
  std::vector<Route> routes;
  std::vector<Row> rows;
  double time = 0;
};

void report(benchmark::State& state, std::size_t aircraft, std::uint64_t allocations) {
  const double steps = static_cast<double>(state.iterations());
  state.counters["ns"] =
      benchmark::Counter(steps * static_cast<double>(aircraft) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["allocs"] = static_cast<double>(allocations) / std::max(steps, 1.0);
}

void bare(benchmark::State& state, flight::Dynamics dynamics, Task task) {
  Loop loop(dynamics, task);
  loop.step();
  NoAllocation guard;
  for (auto _ : state)
    loop.step();
  report(state, loop.rows.size(), guard.count());
  guard.dismiss();
}
BENCHMARK_CAPTURE(bare, laero_straight, flight::Dynamics::laero, Task::straight);
BENCHMARK_CAPTURE(bare, laero_turning, flight::Dynamics::laero, Task::turning);
BENCHMARK_CAPTURE(bare, laero_following, flight::Dynamics::laero, Task::following);
BENCHMARK_CAPTURE(bare, laero_routing, flight::Dynamics::laero, Task::routing);
BENCHMARK_CAPTURE(bare, point_mass_straight, flight::Dynamics::point_mass, Task::straight);
BENCHMARK_CAPTURE(bare, point_mass_turning, flight::Dynamics::point_mass, Task::turning);
BENCHMARK_CAPTURE(bare, point_mass_following, flight::Dynamics::point_mass, Task::following);
BENCHMARK_CAPTURE(bare, point_mass_routing, flight::Dynamics::point_mass, Task::routing);

/// The same inside the kernel, level flight; the ratio to `bare` is what the framework costs.
void in_world(benchmark::State& state, flight::Dynamics dynamics) {
  const auto aircraft = static_cast<std::uint32_t>(state.range(0));
  auto library = std::make_shared<Library>();
  AircraftType type;
  type.dynamics = dynamics;
  type.index.airframe = library->airframes.add("fighter", fighter());
  library->aircraft.add("fighter", type);
  library->flights.resize(1);
  sim::SchemaBuilder schema;
  const AircraftColumns columns = AircraftColumns::define(schema, aircraft);
  sim::SimulationBuilder builder(schema.build());
  builder.add<flight::FlightSystem>(columns, library, 5u);
  const auto simulation = builder.build();
  sim::World world = simulation->world(1);
  for (std::uint32_t i = 0; i < aircraft; ++i) {
    benchmark::DoNotOptimize(world.spawn(columns.table));
    Kinematics& k = world.rows(columns.kinematics)[i];
    k = flight::placed(library->reference, library->environment, {0, 1800.0 * i, -6000}, 0, 240);
    world.rows(columns.propulsion)[i].fuel = 1e6;
    world.rows(columns.command)[i] = {.altitude = k.altitude, .speed = 240};
  }
  sim::Workspace work(*simulation);
  simulation->step(world, work);
  NoAllocation guard(NoAllocation::Scope::process);
  for (auto _ : state)
    simulation->step(world, work);
  report(state, aircraft, guard.count());
  guard.dismiss();
}
BENCHMARK_CAPTURE(in_world, laero, flight::Dynamics::laero)->Arg(6)->Arg(1000);
BENCHMARK_CAPTURE(in_world, point_mass, flight::Dynamics::point_mass)->Arg(6)->Arg(1000);

void atmosphere(benchmark::State& state) {
  const Atmosphere air;
  double altitude = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(air.at(altitude));
    altitude = altitude < 20e3 ? altitude + 17 : 0;
  }
  report(state, 1, 0);
}
BENCHMARK(atmosphere);

void vertical(benchmark::State& state) {
  const Reference reference(Geodetic{.latitude = radians(40)});
  Vec3 place{0, 0, -6000};
  for (auto _ : state) {
    benchmark::DoNotOptimize(reference.vertical_at(place));
    place.x = place.x < 300e3 ? place.x + 13 : 0;
  }
  report(state, 1, 0);
}
BENCHMARK(vertical);

}  // namespace

BENCHMARK_MAIN();
