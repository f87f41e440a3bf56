// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <memory>

#include "model/events.hpp"
#include "sim/difference.hpp"
#include "sim/simulation.hpp"
#include "support/model/lone_flight.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::model::flight {
namespace {

/// Two types of aircraft over one airframe, and one missile to hang under them.
std::shared_ptr<const Library> library() {
  auto result = std::make_shared<Library>();
  const auto airframe = result->airframes.add("simple", test::simple_airframe());
  for (const Dynamics dynamics : {Dynamics::laero, Dynamics::point_mass}) {
    AircraftType type;
    type.label = enum_name(dynamics);
    type.dynamics = dynamics;
    type.index.airframe = airframe;
    result->aircraft.add(type.label, type);
  }
  weapon::MissileType missile;
  missile.motor.mass = Table1({0, 5}, {150, 100});
  missile.carriage_drag_area = 0.02;
  result->missiles.add("missile", missile);
  result->flights.push_back(
      {.name = "eagle",
       .side = Side::blue,
       .members = {},
       .routes = {{.name = "mission",
                   .waypoints = {{.position = {0, 90e3, 0}, .altitude = 4000, .speed = {}}}}},
       .home = {}});
  return result;
}

constexpr std::uint32_t kDeciding = 5;  ///< steps from one decision to the next

struct Sky {
  std::shared_ptr<const Library> models = library();
  AircraftColumns columns;
  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;

  explicit Sky(std::uint32_t aircraft) {
    sim::SchemaBuilder schema;
    columns = AircraftColumns::define(schema, aircraft);
    sim::SimulationBuilder builder(schema.build());
    builder.add<FlightSystem>(columns, models, kDeciding);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(1));
    put(*world, aircraft);
  }
  void put(sim::World& into, std::uint32_t aircraft) const {
    for (std::uint32_t i = 0; i < aircraft; ++i) {
      const auto born = into.spawn(columns.table);
      const Vec3 place{0, 3000.0 * i, -3000};
      into.rows(columns.fit)[i].type = static_cast<std::uint16_t>(i % 2);
      into.rows(columns.fit)[i].side = Side::blue;
      into.rows(columns.kinematics)[i] =
          placed(models->reference, models->environment, place, 0, 220);
      into.rows(columns.propulsion)[i].fuel = 2000;
      Command& command = into.rows(columns.command)[i];
      command.altitude = 3000;
      command.speed = 220;
      command.load_factor = 4;
      EXPECT_TRUE(born);
    }
  }
};

std::size_t count(std::span<const sim::Event> events, EventKind kind) {
  std::size_t n = 0;
  for (const sim::Event& event : events)
    n += event.kind == sim::EventKind(kind);
  return n;
}

TEST(FlightSystem, FliesEachAircraftByItsOwnDynamics) {
  Sky scene(4);
  sim::Workspace work(*scene.simulation);
  for (int i = 0; i < 500; ++i)
    scene.simulation->step(*scene.world, work);
  const auto kinematics = scene.world->rows(scene.columns.kinematics);
  const auto propulsion = scene.world->rows(scene.columns.propulsion);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(kinematics[i].position.x, 2200, 10);
    EXPECT_NEAR(kinematics[i].altitude, 3000, 5);
    EXPECT_EQ(propulsion[i].thrust > 0, i % 2 == 1) << "laero has no forces";
  }
}

TEST(FlightSystem, FliesTheRouteOfTheFlight) {
  Sky scene(2);
  sim::Workspace work(*scene.simulation);
  for (Command& command : scene.world->rows(scene.columns.command))
    command.mode = AutopilotMode::route;
  for (int i = 0; i < 50 * 120; ++i)
    scene.simulation->step(*scene.world, work);
  for (const Kinematics& k : scene.world->rows(scene.columns.kinematics)) {
    EXPECT_NEAR(degrees(k.heading), 93, 5) << "to the waypoint, from where the turn left it";
    EXPECT_GT(k.altitude, 3300);
  }
}

TEST(FlightSystem, FliesSeveralWorldsSideBySideAsEachAlone) {
  const Sky scene(5);
  std::vector<sim::World> worlds;
  std::deque<sim::Workspace> works;
  std::uint64_t begin = 0;
  for (const std::uint32_t aircraft : {1U, 5U, 0U, 2U, 4U, 3U}) {
    sim::World world = scene.simulation->world(1);
    scene.put(world, aircraft);
    for (std::uint32_t i = 0; i < aircraft; ++i) {
      world.rows(scene.columns.propulsion)[i].fuel = 1 + 0.1 * i;
      world.rows(scene.columns.command)[i].heading = aircraft;
      world.rows(scene.columns.fit)[i].remote = aircraft == 4 && i == 1 ? 1 : 0;
    }
    works.emplace_back(*scene.simulation);
    for (begin += 7; world.step() < begin;)  // each is in a step of its own
      scene.simulation->step(world, works.back());
    worlds.push_back(std::move(world));
  }
  std::vector<sim::World> alone = worlds;
  sim::Workspace work(*scene.simulation);
  std::size_t dry = 0;
  for (int step = 0; step < 500; ++step) {
    std::vector<sim::Stepped> all;
    for (std::size_t i = 0; i < worlds.size(); ++i)
      all.push_back({&worlds[i], &works[i]});
    scene.simulation->step(all);
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      const auto events = scene.simulation->step(alone[i], work);
      ASSERT_EQ(worlds[i].hash(), alone[i].hash()) << i << " in step " << step;
      ASSERT_EQ(sim::first_difference(0, events, works[i].events()), std::nullopt) << i;
      dry += count(events, EventKind::fuel_out);
    }
  }
  EXPECT_EQ(dry, 5U) << "one of each point mass; those of laero burn nothing";
}

TEST(FlightSystem, SaysOnceThatTheTanksAreDry) {
  Sky scene(2);
  sim::Workspace work(*scene.simulation);
  scene.world->rows(scene.columns.propulsion)[1].fuel = 2;
  std::size_t dry = 0;
  PlayerId who;
  for (int i = 0; i < 500; ++i)
    for (const sim::Event& event : scene.simulation->step(*scene.world, work))
      if (event.kind == sim::EventKind(EventKind::fuel_out)) {
        ++dry;
        who = event.who;
        EXPECT_NEAR(event.place.z, -3000, 50);
      }
  EXPECT_EQ(dry, 1u);
  EXPECT_EQ(who, PlayerId{2});
  EXPECT_EQ(scene.world->rows(scene.columns.propulsion)[1].fuel, 0);
  EXPECT_EQ(scene.world->rows(scene.columns.propulsion)[1].thrust, 0);
}

TEST(FlightSystem, ReportsWhoHitsTheGround) {
  Sky scene(2);
  sim::Workspace work(*scene.simulation);
  scene.world->rows(scene.columns.kinematics)[1].pitch = -0.5;
  scene.world->rows(scene.columns.kinematics)[1].position.z = -60;
  scene.world->rows(scene.columns.kinematics)[1].altitude = 60;
  scene.world->rows(scene.columns.command)[1].altitude = -1000;
  int steps = 0;
  std::span<const sim::Event> events;
  do
    events = scene.simulation->step(*scene.world, work);
  while (count(events, EventKind::crash) == 0 && ++steps < 100);
  ASSERT_LT(steps, 100);
  EXPECT_GT(steps, 10);
  EXPECT_EQ(events[0].who, PlayerId{2});
  const double altitude = scene.world->rows(scene.columns.kinematics)[1].altitude;
  EXPECT_LT(altitude, 0);
  EXPECT_GT(altitude, -3) << "in the step in which it got there";
}

TEST(FlightSystem, AddsUpTheStores) {
  const Sky scene(1);
  const auto* system = dynamic_cast<const FlightSystem*>(scene.simulation->systems()[0].get());
  weapon::Stores stores;
  EXPECT_EQ(system->load_of(stores).mass, 0);
  stores.stations[0] = {.store = 1, .count = 2};
  stores.stations[5] = {.store = 1, .count = 1};
  EXPECT_EQ(system->load_of(stores).mass, 450);
  EXPECT_NEAR(system->load_of(stores).drag_area, 0.06, 1e-12);
}

TEST(FlightSystem, FliesSlowerWithStores) {
  Sky scene(4);
  for (Command& command : scene.world->rows(scene.columns.command))
    command.speed = 500;
  for (int i = 0; i < 4; ++i)
    scene.world->rows(scene.columns.stores)[3].stations[static_cast<std::size_t>(i)] = {1, 2};
  sim::Workspace work(*scene.simulation);
  for (int i = 0; i < 1000; ++i)
    scene.simulation->step(*scene.world, work);
  const auto kinematics = scene.world->rows(scene.columns.kinematics);
  EXPECT_LT(kinematics[3].speed, kinematics[1].speed - 5);
}

TEST(FlightSystem, TellsEnergyInTheStepBeforeEachDecision) {
  Sky scene(4);
  sim::Workspace work(*scene.simulation);
  const auto flying = scene.world->rows(scene.columns.flying);
  for (int i = 0; i < 40; ++i) {
    for (Flying& row : flying)
      row.energy = {};
    scene.simulation->step(*scene.world, work);
    for (std::size_t row = 1; row < flying.size(); row += 2)  // those of point_mass
      EXPECT_EQ(
          flying[row].energy.available > 0,
          sim::due(scene.world->step(), scene.world->ids(scene.columns.table)[row], kDeciding));
  }
}

TEST(FlightSystem, AllocatesNothing) {
  Sky scene(300);
  sim::Workspace work(*scene.simulation);
  scene.simulation->step(*scene.world, work);
  NoAllocation guard;
  for (int i = 0; i < 20; ++i)
    scene.simulation->step(*scene.world, work);
}

TEST(FlightSystem, GivesTheSameBitsForAnyNumberOfWorkers) {
  std::uint64_t first = 0;
  for (const unsigned workers : {1u, 3u}) {
    Sky scene(600);
    for (std::size_t i = 0; i < 600; ++i)
      scene.world->rows(scene.columns.command)[i].heading = 0.01 * static_cast<double>(i) - 3;
    sim::Workspace work(*scene.simulation, workers);
    for (int i = 0; i < 100; ++i)
      scene.simulation->step(*scene.world, work);
    if (workers == 1)
      first = scene.world->hash();
    EXPECT_EQ(scene.world->hash(), first);
  }
}

TEST(FlightSystem, ReportsBothWhoCollide) {
  Sky scene(3);
  sim::Workspace work(*scene.simulation);
  const auto k = scene.world->rows(scene.columns.kinematics);
  k[1] = placed(scene.models->reference, scene.models->environment,
                k[0].position + Vec3{4000, 1, 0}, kPi, 220);  // head-on
  scene.world->rows(scene.columns.command)[1].heading = kPi;
  std::vector<sim::Event> crashed;
  for (int i = 0; i < 50 * 15 && crashed.empty(); ++i)
    for (const sim::Event& event : scene.simulation->step(*scene.world, work))
      if (event.kind == sim::EventKind(EventKind::crash))
        crashed.push_back(event);
  ASSERT_EQ(crashed.size(), 2U);
  EXPECT_EQ(crashed[0].who, PlayerId{1});
  EXPECT_EQ(crashed[0].whom, PlayerId{2});
  EXPECT_EQ(crashed[1].who, PlayerId{2});
  EXPECT_EQ(crashed[1].whom, PlayerId{1});
}

TEST(FlightSystem, ReportsNoCollisionOfBeforeTheStart) {
  Sky scene(3);
  sim::Workspace work(*scene.simulation);
  const auto k = scene.world->rows(scene.columns.kinematics);
  k[1] = placed(scene.models->reference, scene.models->environment, k[0].position + Vec3{-12, 0, 0},
                kPi, 220);  // tail to tail, and away
  scene.world->rows(scene.columns.command)[1].heading = kPi;
  for (int i = 0; i < 20; ++i)
    for (const sim::Event& event : scene.simulation->step(*scene.world, work))
      EXPECT_NE(event.kind, sim::EventKind(EventKind::crash)) << i;
}

}  // namespace
}  // namespace eyrie::model::flight
