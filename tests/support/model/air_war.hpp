// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: a small air war in which everybody flies straight on and sensors work.
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/columns.hpp"
#include "model/events.hpp"
#include "model/library.hpp"
#include "model/sensor/sensor_system.hpp"
#include "sim/simulation.hpp"
#include "support/model/flying.hpp"

namespace eyrie::model::test {

/// Moves everybody along a straight line.
class StraightOn final : public sim::System {
 public:
  StraightOn(TableId table, sim::Column<Kinematics> kinematics)
      : table_(table), kinematics_(kinematics) {}
  [[nodiscard]] std::string_view name() const override { return "straight on"; }
  [[nodiscard]] TableId table() const override { return table_; }
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox&) const override {
    const auto rows = world.rows(kinematics_);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      rows[i].position += info.dt * rows[i].velocity;
  }

 private:
  TableId table_;
  sim::Column<Kinematics> kinematics_;
};

/// One type of everything; the same aircraft for both sides.
inline Library library() {
  Library l;
  AircraftType type;
  type.label = "fighter";
  type.signature = {.rcs_front = 5, .rcs_side = 30, .rcs_rear = 8};
  type.index.radar = l.radars.add("radar", {});
  type.index.rwr = l.rwrs.add("rwr", {});
  type.index.visual = l.visuals.add("visual", {});
  type.index.iff = l.iffs.add("iff", {});
  type.index.datalink = l.datalinks.add("datalink", {});
  type.index.tracker = l.trackers.add("tracker", {});
  l.aircraft.add("fighter", type);
  weapon::MissileType missile;
  missile.motor.thrust = Table1({0, 5}, {10e3, 10e3});
  l.missiles.add("missile", missile);
  l.flights.resize(2);
  l.flights[0].name = "eagle";
  l.flights[0].side = Side::blue;
  l.flights[1].name = "bogey";
  l.flights[1].side = Side::red;
  return l;
}

/// Collects a Library's players first, then builds the simulation on them.
struct AirWar {
  AircraftColumns aircraft;
  MissileColumns missiles;
  Library models = library();
  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;
  std::unique_ptr<sim::Workspace> work;
  const sensor::SensorSystem* sensors = nullptr;
  std::map<EventKind, std::vector<sim::Event>> events;

  /// Adds a player to the flight of its side; ids count from 1 in this order.
  PlayerId add(Side side, const Kinematics& k, bool privileged = false) {
    const std::uint16_t flight = side == Side::blue ? 0 : 1;
    const PlayerId id{static_cast<std::uint32_t>(players_.size()) + 1};
    std::vector<PlayerId>& members = models.flights[flight].members;
    if (members.size() < kMaxFlight)
      members.push_back(id);
    players_.push_back({{.flight = flight,
                         .rank = static_cast<std::uint8_t>(members.size()),
                         .side = side,
                         .privileged = privileged},
                        k});
    return id;
  }

  void build(std::uint64_t seed = 1, unsigned workers = 1) {
    sim::SchemaBuilder schema;
    aircraft = AircraftColumns::define(schema, static_cast<std::uint32_t>(players_.size()));
    missiles = MissileColumns::define(schema, 8);
    sim::SimulationBuilder builder(schema.build());
    sensors = &builder.add<sensor::SensorSystem>(aircraft, missiles,
                                                 std::make_shared<const Library>(models), 0.02);
    builder.add<StraightOn>(aircraft.table, aircraft.kinematics);
    builder.add<StraightOn>(missiles.table, missiles.kinematics);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(seed));
    work = std::make_unique<sim::Workspace>(*simulation, workers);
    for (const auto& [fit, kinematics] : players_) {
      const auto born = world->spawn(aircraft.table);
      world->rows(aircraft.fit)[born->row] = fit;
      world->rows(aircraft.kinematics)[born->row] = kinematics;
    }
  }

  PlayerId launch(PlayerId shooter, Side side, const Kinematics& k, PlayerId target) {
    const auto born = world->spawn(missiles.table);
    world->rows(missiles.kinematics)[born->row] = k;
    weapon::MissileState& state = world->rows(missiles.state)[born->row];
    state.shooter = shooter;
    state.side = side;
    state.intended = target;
    state.launch_time = static_cast<double>(world->step()) * 0.02;
    return born->id;
  }

  void fly(double seconds) {
    const auto steps = static_cast<int>(seconds / 0.02 + 0.5);
    for (int i = 0; i < steps; ++i)
      for (const sim::Event& e : simulation->step(*world, *work))
        events[e.kind.as<EventKind>()].push_back(e);
  }

  template <class Row>
  Row& row(sim::Column<Row> column, PlayerId id) {
    return world->rows(column)[*world->row(aircraft.table, id)];
  }
  TrackFile& tracks(PlayerId id) { return row(aircraft.tracks, id); }
  const Track* track_of(PlayerId owner, PlayerId truth) {
    const TrackFile& file = tracks(owner);
    for (std::uint32_t i = 0; i < file.count; ++i)
      if (file.tracks[i].truth == truth)
        return &file.tracks[i];
    return nullptr;
  }
  int told(EventKind kind, PlayerId who, PlayerId whom) {
    int count = 0;
    for (const sim::Event& e : events[kind])
      count += e.who == who && e.whom == whom;
    return count;
  }

 private:
  struct Born {
    Fit fit;
    Kinematics kinematics;
  };
  std::vector<Born> players_;
};

}  // namespace eyrie::model::test
