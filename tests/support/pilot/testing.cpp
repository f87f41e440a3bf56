// SPDX-License-Identifier: MIT
#include "support/pilot/testing.hpp"

#include <stdexcept>
#include <utility>

#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "pilot/controller.hpp"
#include "support/data_file.hpp"
#include "support/model/lone_flight.hpp"

namespace eyrie::pilot::testing {
namespace {

model::Library make_library() {
  const auto missile = [](const char* path) {
    auto type = eyrie::test::load<model::MissileType>(path);
    type.prepare();
    return type;
  };
  model::Library l;
  l.missiles.add("medium", missile("data/missiles/aim120.yaml"));
  l.missiles.add("short", missile("data/missiles/aim9.yaml"));
  l.guns.add("gun", eyrie::test::load<model::GunType>("data/guns/m61.yaml"));
  l.airframes.add("simple", model::test::simple_airframe());
  model::AircraftType fighter;
  fighter.stations = {{"medium", 1}, {"medium", 1}, {"short", 1}, {"short", 1}};
  fighter.index.gun = 0;
  l.aircraft.add("fighter", fighter);
  l.flights.resize(2);
  l.flights[0] = {.name = "eagle",
                  .side = model::Side::blue,
                  .members = {PlayerId{1}, PlayerId{2}, PlayerId{3}, PlayerId{4}},
                  .routes = {{.name = "mission",
                              .waypoints = {{.position = {20e3, 0, 0}, .altitude = 7000},
                                            {.position = {60e3, 0, 0}, .altitude = 7000}}}},
                  .home = Vec3{-50 * kNmi, 0, 0}};
  l.flights[1] = {.name = "bogey",
                  .side = model::Side::red,
                  .members = {PlayerId{5}, PlayerId{6}, PlayerId{7}, PlayerId{8}},
                  .routes = {},
                  .home = {}};
  return l;
}

Tree build(const std::string& text) {
  Diagnostics diagnostics;
  auto tree =
      registry().build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics);
  if (!tree)
    throw std::runtime_error(diagnostics.text());
  return std::move(*tree);
}

}  // namespace

const model::Library& library() {
  static const model::Library l = make_library();
  return l;
}

const model::Library& windy_library() {
  static const model::Library windy = [] {
    model::Library result = library();
    const model::WindLayer south{.speed = 60, .from = kPi};
    result.environment.wind = model::Wind(std::span(&south, 1));
    return result;
  }();
  return windy;
}

Registry& registry() {
  static Registry all = make_registry();
  return all;
}

Pilot::Pilot(const std::string& text) : tree_(build(text)), slab_(tree_.memory_bytes() / 8) {}

Decided Pilot::decide(const Desk& desk) {
  const State state = desk.state();
  Decided d;
  d.status = tree_.tick({.state = state,
                         .time = desk.time,
                         .dt = 0.1,
                         .step = static_cast<std::uint64_t>(desk.time / 0.02 + 0.5),
                         .player = PlayerId{1},
                         .memory = reinterpret_cast<std::byte*>(slab_.data())},
                        d.proposal);
  return d;
}

Decided Pilot::fly(Desk& desk) {
  const State state = desk.state();
  account_for_shots(state, desk.agent);
  Decided d = decide(desk);
  ++desk.agent.ticks;
  execute(d.proposal.action, desk.state(), desk.command, desk.request, desk.agent);
  return d;
}

Decided decide(const std::string& text, const Desk& desk) {
  return Pilot(text).decide(desk);
}

bool holds(const std::string& text, const Desk& desk) {
  return decide(text, desk).status == kSuccess;
}

}  // namespace eyrie::pilot::testing
