// SPDX-License-Identifier: MIT
/// \file  What a missile costs: flying one step, all its phases in a world, and the launch zone.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>

#include "model/columns.hpp"
#include "model/events.hpp"
#include "model/library.hpp"
#include "model/weapon/kept_zones.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/systems.hpp"
#include "sim/simulation.hpp"
#include "support/no_allocation.hpp"

namespace {

using namespace eyrie;
using namespace eyrie::model;

/// As many breakpoints as the missiles of data/ have.
MissileType medium_range() {
  const std::vector<double> mach{0.7, 0.9, 1.1, 1.4, 1.8, 2.5, 3.5, 5};
  MissileType type;
  type.motor = {.mass = Table1({0, 2.5, 8}, {152, 129, 101}),
                .thrust = Table1({0, 2.5, 2.6, 8}, {22000, 22000, 12500, 12000}),
                .nozzle_area = 0.0095};
  type.aero = {
      .reference_area = 0.0254,
      .drag_power_on = Table1(mach, {0.207, 0.317, 0.751, 0.682, 0.575, 0.611, 0.613, 0.585}),
      .drag_power_off = Table1(mach, {0.260, 0.369, 0.830, 0.754, 0.638, 0.657, 0.644, 0.607}),
      .induced_drag =
          Table1(mach, {0.0753, 0.0611, 0.0457, 0.0575, 0.0686, 0.0793, 0.0878, 0.0920}),
      .greatest_lift = Table1(mach, {6.335, 8.048, 10.56, 10.15, 9.081, 8.191, 7.917, 7.719}),
      .greatest_load_factor = 40};
  type.guidance.link_interval = 1;
  type.guidance.loft = weapon::Loft{.angle = 0.175, .end_range = 18e3, .ceiling = 24e3};
  type.greatest_time = 70;
  type.least_speed = 300;
  return type;
}

/// `missiles` in flight at one target 40 km away, which flies on and on.
struct Scene {
  explicit Scene(std::uint32_t missiles) {
    auto library = std::make_shared<Library>();
    MissileType type = medium_range();
    type.greatest_time = 1e9;
    type.least_speed = 1;
    library->missiles.add("medium", type);
    library->aircraft.add("target", AircraftType{});
    sim::SchemaBuilder schema;
    const AircraftColumns aircraft = AircraftColumns::define(schema, 2);
    const MissileColumns columns = MissileColumns::define(schema, missiles);
    sim::SimulationBuilder builder(schema.build());
    builder.add<weapon::MissileSystem>(aircraft, columns, library, sim::kDefaultDt);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(1));

    Kinematics shooter;
    shooter.north = {1, 0, 0};
    shooter.east = {0, 1, 0};
    shooter.down = {0, 0, 1};
    shooter.position = {0, 0, -8000};
    shooter.altitude = 8000;
    shooter.velocity = {300, 0, 0};
    shooter.speed = 300;
    Kinematics target = shooter;
    target.position = {40e3, 0, -8000};
    target.velocity = {-300, 0, 0};
    for (const Kinematics& k : {shooter, target}) {
      const auto born = world->spawn(aircraft.table);
      world->rows(aircraft.kinematics)[born->row] = k;
    }
    const Track track{.position = target.position, .velocity = target.velocity, .id = TrackId{1}};
    for (std::uint32_t i = 0; i < missiles; ++i) {
      const auto born = world->spawn(columns.table);
      const weapon::Newborn missile =
          weapon::launched({.type = library->missiles[0], .shooter = PlayerId{1}}, shooter, track);
      world->rows(columns.kinematics)[born->row] = missile.kinematics;
      world->rows(columns.state)[born->row] = missile.state;
    }
  }

  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;
};

/// Seeker, guidance, flight and fuze of every missile of a world, per missile.
void missile_step(benchmark::State& state) {
  const auto missiles = static_cast<std::uint32_t>(state.range(0));
  const Scene scene(missiles);
  sim::World world = *scene.world;
  sim::Workspace work(*scene.simulation);
  scene.simulation->step(world, work);  // the workspace grows once
  world = *scene.world;
  NoAllocation guard;
  for (auto _ : state) {
    if (world.step() == 2000) {  // 40 s: boost, loft and the way down
      state.PauseTiming();
      world = *scene.world;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(scene.simulation->step(world, work));
  }
  state.counters["allocs"] = static_cast<double>(guard.count());
  guard.dismiss();
  state.counters["ns_per_missile"] = benchmark::Counter(
      static_cast<double>(missiles) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(missile_step)->Arg(1)->Arg(8)->Arg(256);

/// Flight alone.
void missile_flyout(benchmark::State& state) {
  Library library;
  const MissileType type = medium_range();
  Kinematics k;
  k.down = {0, 0, 1};
  k.north = {1, 0, 0};
  k.east = {0, 1, 0};
  k.position = {0, 0, -8000};
  k.altitude = 8000;
  k.velocity = {300, 0, 0};
  const Kinematics start = k;
  MissileState missile;
  missile.wanted = {0, 5, -9.8};
  double time = 0;
  for (auto _ : state) {
    move_missile(type, library, time, sim::kDefaultDt, k, missile);
    time += sim::kDefaultDt;
    if (time > 40) {
      time = 0;
      k = start;
    }
    benchmark::DoNotOptimize(k);
  }
}
BENCHMARK(missile_flyout);

void launch_zone_lookup(benchmark::State& state) {
  const weapon::LaunchZone zone = weapon::KeptZones().of(medium_range());
  double x = 0;
  for (auto _ : state) {
    x = x > 0.99 ? 0 : x + 0.013;
    benchmark::DoNotOptimize(
        zone.at({12e3 * x, 12e3 * (1 - x), 200 + 200 * x, 380 - 200 * x, 3 * x, x}));
  }
}
BENCHMARK(launch_zone_lookup);

void launch_zone_build(benchmark::State& state) {
  const MissileType type = medium_range();
  for (auto _ : state)
    benchmark::DoNotOptimize(fly_zone(type));
}
BENCHMARK(launch_zone_build)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
