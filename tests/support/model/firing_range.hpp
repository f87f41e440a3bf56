// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: a firing range. Aircraft that fly straight (or are put where a test wants
/// them), with the weapon systems and nothing else.
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "model/columns.hpp"
#include "model/events.hpp"
#include "model/flight/flight_system.hpp"
#include "model/library.hpp"
#include "model/weapon/gun.hpp"
#include "model/weapon/systems.hpp"
#include "sim/simulation.hpp"
#include "support/data_file.hpp"
#include "support/model/stores.hpp"

namespace eyrie::model::test {

using eyrie::test::load;

/// Carries every aircraft along its velocity.
class Straight final : public sim::System {
 public:
  Straight(const AircraftColumns& columns, std::shared_ptr<const Library> library)
      : columns_(columns), library_(std::move(library)) {}
  [[nodiscard]] std::string_view name() const override { return "straight"; }
  [[nodiscard]] TableId table() const override { return columns_.table; }
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox&) const override {
    const auto kinematics = world.rows(columns_.kinematics);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Kinematics& k = kinematics[i];
      k.position += info.dt * k.velocity;
      const Vertical vertical = library_->reference.vertical_at(k.position);
      k.north = vertical.north;
      k.east = vertical.east;
      k.down = vertical.down;
      k.altitude = vertical.altitude;
    }
  }

 private:
  AircraftColumns columns_;
  std::shared_ptr<const Library> library_;
};

/// Missile types of the library, by index.
enum Store : std::uint16_t { kMedium = 0, kShort = 1 };

class Range {
 public:
  explicit Range(std::uint64_t seed = 1, Library library = standard()) {
    library_ = std::make_shared<const Library>(std::move(library));
    sim::SchemaBuilder schema;
    aircraft_ = AircraftColumns::define(schema, 16);
    missiles_ = MissileColumns::define(schema, 32);
    sim::SimulationBuilder builder(schema.build());
    builder.add<Straight>(aircraft_, library_);
    builder.add<weapon::StoresSystem>(aircraft_, missiles_, library_);
    builder.add<weapon::MissileSystem>(aircraft_, missiles_, library_, sim::kDefaultDt);
    builder.add<weapon::GunSystem>(aircraft_, library_);
    builder.add<weapon::DamageSystem>(aircraft_);
    simulation_ = builder.build();
    world_ = std::make_unique<sim::World>(simulation_->world(seed));
    work_ = std::make_unique<sim::Workspace>(*simulation_);
    events_.reserve(4096);
  }

  /// A medium- and a short-range missile, a gun and one type of aircraft with two of each missile.
  [[nodiscard]] static Library standard() {
    Library library;
    library.missiles.add("medium", load<MissileType>("data/missiles/aim120.yaml"));
    library.missiles.add("short", load<MissileType>("data/missiles/aim9.yaml"));
    library.guns.add("gun", load<GunType>("data/guns/m61.yaml"));
    AircraftType fighter;
    fighter.stations = {{"medium", 1}, {"medium", 1}, {"short", 1}, {"short", 1}};
    fighter.index.gun = 0;
    library.aircraft.add("fighter", std::move(fighter));
    return library;
  }

  PlayerId add(const Vec3& position, double heading, double speed, Side side = Side::blue) {
    const auto born = world_->spawn(aircraft_.table);
    row(aircraft_.kinematics, born->id) =
        flight::placed(library_->reference, library_->environment, position, heading, speed);
    row(aircraft_.fit, born->id).side = side;
    const AircraftType& type = library_->aircraft[0];
    row(aircraft_.stores, born->id) = weapon::load_stores(type.stations, library_->missiles);
    row(aircraft_.gun, born->id) = weapon::loaded(library_->guns[0]);
    return born->id;
  }

  /// Gives `who` a perfect track of `whom`, or brings it up to date.
  TrackId track(PlayerId who, PlayerId whom) {
    TrackFile& file = row(aircraft_.tracks, who);
    std::uint32_t index = 0;
    while (index < file.count && file.tracks[index].truth != whom)
      ++index;
    Track& t = file.tracks[index];
    if (index == file.count) {
      ++file.count;
      file.next_id = std::max(file.next_id, 1u);
      t.id = TrackId{file.next_id++};
      t.truth = whom;
      t.confirmed = 1;
    }
    const Kinematics& k = row(aircraft_.kinematics, whom);
    t.position = k.position;
    t.velocity = k.velocity;
    t.time = time();
    return t.id;
  }

  /// Asks for a release at `whom`, of whom there must be a track.
  void shoot(PlayerId who, PlayerId whom, Store store) {
    Request& request = row(aircraft_.request, who);
    request.shoot_at = track(who, whom);
    request.store = static_cast<std::uint8_t>(store + 1);
  }
  void hold_fire(PlayerId who) { row(aircraft_.request, who) = {}; }

  /// One step; its events are kept.
  void step() {
    const auto events = simulation_->step(*world_, *work_);
    events_.insert(events_.end(), events.begin(), events.end());
  }
  /// Steps for so many seconds, or until `done()`.
  template <class Done>
  void run(double seconds, Done done) {
    const double end = time() + seconds - 1e-9;
    while (time() < end && !done())
      step();
  }
  void run(double seconds) {
    run(seconds, [] { return false; });
  }

  [[nodiscard]] double time() const {
    return static_cast<double>(world_->step()) * sim::kDefaultDt;
  }
  [[nodiscard]] std::span<const sim::Event> events() const { return events_; }
  [[nodiscard]] std::vector<sim::Event> all(EventKind kind) const {
    std::vector<sim::Event> result;
    for (const sim::Event& event : events_)
      if (event.kind == kind)
        result.push_back(event);
    return result;
  }
  [[nodiscard]] std::size_t count(EventKind kind) const { return all(kind).size(); }
  [[nodiscard]] bool alive(PlayerId who) const { return world_->find(who).has_value(); }
  [[nodiscard]] std::uint32_t in_flight() const { return world_->rows(missiles_.table); }

  /// The row of a player that is alive.
  template <class Row>
  Row& row(sim::Column<Row> column, PlayerId who) {
    return world_->rows(column)[world_->find(who).value().row];
  }
  [[nodiscard]] sim::World& world() { return *world_; }
  [[nodiscard]] const AircraftColumns& aircraft() const { return aircraft_; }
  [[nodiscard]] const MissileColumns& missiles() const { return missiles_; }
  [[nodiscard]] const Library& library() const { return *library_; }

 private:
  std::shared_ptr<const Library> library_;
  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const sim::Simulation> simulation_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<sim::Workspace> work_;
  std::vector<sim::Event> events_;
};

}  // namespace eyrie::model::test
