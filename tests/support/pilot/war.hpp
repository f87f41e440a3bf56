// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: a small air war with every system in it, flown by trees from texts.
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/yaml.hpp"
#include "model/events.hpp"
#include "model/flight/flight_system.hpp"
#include "model/sensor/sensor_system.hpp"
#include "model/weapon/systems.hpp"
#include "pilot/catalog.hpp"
#include "pilot/pilot_system.hpp"
#include "sim/simulation.hpp"
#include "support/model/stores.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot::testing {

/// The library of testing.hpp with an aircraft that flies; players 1 to 4 are eagles, 5 to 8 are
/// bogeys, and all of them see the truth.
class War {
 public:
  static constexpr double kDt = 0.02;

  /// `trees`: document by document; they are called "0", "1" ...
  explicit War(std::vector<std::string> trees) {
    auto library = std::make_shared<model::Library>(testing::library());
    library_ = library;
    auto built = std::make_shared<Trees>();
    const Registry registry = make_registry();
    for (const std::string& text : trees) {
      Diagnostics diagnostics;
      auto tree = registry.build_tree(std::to_string(built->size()),
                                      parse_yaml(text, "test.yaml", diagnostics), diagnostics);
      EYRIE_DEMAND(tree, diagnostics.text().c_str());
      built->add(std::move(*tree));
    }
    trees_ = built;

    sim::SchemaBuilder schema;
    aircraft = model::AircraftColumns::define(schema, 8);
    missiles = model::MissileColumns::define(schema, 64);
    pilots = PilotColumns::define(schema, aircraft.table,
                                  static_cast<std::uint32_t>(trees_->max_memory()));
    sim::SimulationBuilder builder(schema.build(), kDt);
    builder.add<model::sensor::SensorSystem>(aircraft, missiles, library_, kDt);
    system = &builder.add<PilotSystem>(PilotSetup{.columns = aircraft,
                                                  .agents = pilots,
                                                  .library = library_,
                                                  .trees = trees_,
                                                  .plans = {{}, {}},
                                                  .dt = kDt,
                                                  .period = 5});
    builder.add<model::weapon::MissileSystem>(aircraft, missiles, library_, kDt);
    builder.add<model::weapon::StoresSystem>(aircraft, missiles, library_);
    builder.add<model::weapon::GunSystem>(aircraft, library_);
    builder.add<model::flight::FlightSystem>(aircraft, library_, 5u);
    builder.add<model::weapon::DamageSystem>(aircraft);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(1));
    work = std::make_unique<sim::Workspace>(*simulation);
  }

  /// The next player: `north`, `east` and height in m, heading in rad.
  PlayerId add(const Vec3& north_east_up, double heading, std::uint16_t tree) {
    const auto born = world->spawn(aircraft.table);
    const std::uint32_t i = born->row;
    const bool blue = born->id.value <= 4;
    world->rows(aircraft.fit)[i] = {.flight = static_cast<std::uint16_t>(blue ? 0 : 1),
                                    .rank = static_cast<std::uint8_t>((born->id.value - 1) % 4 + 1),
                                    .side = blue ? model::Side::blue : model::Side::red,
                                    .privileged = 1};
    const Vec3 place{north_east_up.x, north_east_up.y, -north_east_up.z};
    auto& k = world->rows(aircraft.kinematics)[i];
    k = model::flight::placed(library_->reference, library_->environment, place, heading, 250);
    world->rows(aircraft.command)[i] = {.heading = k.heading, .altitude = k.altitude, .speed = 250};
    world->rows(aircraft.propulsion)[i] = {.fuel = 2500};
    world->rows(aircraft.stores)[i] =
        model::weapon::load_stores(library_->aircraft[0].stations, library_->missiles);
    world->rows(aircraft.gun)[i] = model::weapon::loaded(library_->guns[0]);
    world->rows(pilots.agent)[i] = {.bingo = 500, .tree = tree};
    return born->id;
  }

  /// One step; collects its events.
  void step(std::span<const sim::Order> orders = {}) {
    for (const sim::Event& e : simulation->step(*world, *work, orders))
      events.push_back(e);
  }
  void fly(double seconds) {
    for (int i = static_cast<int>(seconds / kDt + 0.5); i > 0; --i)
      step();
  }

  /// What the pilot of `id` decided in the step since `before`, with every node's answer.
  [[nodiscard]] std::optional<Proposal> trace_decision(
      const sim::World& before, PlayerId id, Trace& trace,
      std::span<const sim::Order> orders = {}) const {
    std::optional<Proposal> decided;
    system->revisit(before, *world, id, orders, [&](const team::Moment<State>& m) {
      decided = team::ask_again(tree(m.state.agent.tree), m, &trace);
    });
    return decided;
  }

  [[nodiscard]] Agent& agent(PlayerId id) { return row(pilots.agent, id); }
  template <class Row>
  [[nodiscard]] Row& row(sim::Column<Row> column, PlayerId id) {
    return world->rows(column)[*world->row(aircraft.table, id)];
  }
  [[nodiscard]] std::vector<sim::Event> told(model::EventKind kind) const {
    std::vector<sim::Event> found;
    for (const sim::Event& e : events)
      if (e.kind == kind)
        found.push_back(e);
    return found;
  }
  [[nodiscard]] const Tree& tree(std::uint16_t index) const { return (*trees_)[index]; }
  [[nodiscard]] const Trees& trees() const { return *trees_; }

  model::AircraftColumns aircraft;
  model::MissileColumns missiles;
  PilotColumns pilots;
  const PilotSystem* system = nullptr;
  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;
  std::unique_ptr<sim::Workspace> work;
  std::vector<sim::Event> events;

 private:
  std::shared_ptr<const model::Library> library_;
  std::shared_ptr<const Trees> trees_;
};

}  // namespace eyrie::pilot::testing
