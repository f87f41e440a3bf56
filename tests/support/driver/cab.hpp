// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: a cab made by hand, without a world around it, and a driver to sit in.
#include <stdexcept>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "core/yaml.hpp"
#include "driver/behaviors.hpp"
#include "driver/state.hpp"
#include "support/model/flying.hpp"

namespace eyrie::driver::testing {

/// One type of truck and a convoy of four with a route to the north.
[[nodiscard]] inline const model::Library& library() {
  static const model::Library l = [] {
    model::Library made;
    model::VehicleType truck;
    truck.prepare();
    made.vehicles.add("truck", truck);
    made.flights = {{.name = "supply",
                     .side = model::Side::blue,
                     .members = {PlayerId{1}, PlayerId{2}, PlayerId{3}, PlayerId{4}},
                     .routes = {{.name = "mission",
                                 .waypoints = {{.position = {2e3, 0, 0}, .speed = 12},
                                               {.position = {2e3, 4e3, 0}}},
                                 .end = model::RouteEnd::stop}},
                     .home = {}}};
    return made;
  }();
  return l;
}

/// The rows of one vehicle: heading north at 10 m/s over the reference point, at 100 s, alone.
struct Desk {
  model::Kinematics own = model::test::flying({}, 0, 10);
  model::Driving driving;
  model::Lookout lookout;
  model::DatalinkState datalink;
  model::DriveCommand command;
  Agent agent{.tree = 0};
  model::Fit fit{.rank = 1, .side = model::Side::blue};
  Spacing spacing;
  double time = 100;

  /// A convoy of `count`, of which this is number `rank` from 1; all alive and heard of, 50 m apart
  /// on a road to the north.
  void in_convoy(std::uint32_t count, std::uint32_t rank) {
    datalink.count = count;
    datalink.self = rank - 1;
    fit.rank = static_cast<std::uint8_t>(rank);
    for (std::uint32_t i = 0; i < count; ++i)
      datalink.members[i] = {
          .position = own.position + Vec3{50 * (double(datalink.self) - double(i)), 0, 0},
          .velocity = {10, 0, 0},
          .time = time,
          .heard_time = time,
          .id = PlayerId{i + 1},
          .alive = 1,
          .reported = 1};
  }
  void lose(std::uint32_t rank) { datalink.members[rank - 1].alive = 0; }
  /// An aircraft in sight `range` (m) to the north.
  void see(double range, model::Identity identity = model::Identity::hostile) {
    lookout.sighted[lookout.count++] = {.position = {range, 0, 0},
                                        .time = time,
                                        .seen_time = time,
                                        .truth = PlayerId{90 + lookout.count},
                                        .identity = identity};
  }
  [[nodiscard]] State state() const {
    return {{own, driving, lookout, datalink, agent}, library(), fit, spacing, time};
  }
};

struct Decided {
  Status status = Status::failure;
  Proposal proposal;
  [[nodiscard]] const Action& action() const { return proposal.action; }
};

/// A tree and what it remembers.
class Driver {
 public:
  explicit Driver(const std::string& text) : tree_(build(text)), slab_(tree_.memory_bytes() / 8) {}

  Decided decide(const Desk& desk) {
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

 private:
  static Tree build(const std::string& text) {
    static const Registry registry = make_registry();
    Diagnostics diagnostics;
    auto tree =
        registry.build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics);
    if (!tree)
      throw std::runtime_error(diagnostics.text());
    return std::move(*tree);
  }

  Tree tree_;
  std::vector<std::uint64_t> slab_;
};

/// One decision of a fresh driver.
inline Decided decide(const std::string& text, const Desk& desk) {
  return Driver(text).decide(desk);
}

}  // namespace eyrie::driver::testing
