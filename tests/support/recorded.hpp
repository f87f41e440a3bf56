// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flights recorded in memory.
#include <string>
#include <vector>

#include "debrief/recorded.hpp"
#include "sim/trail.hpp"
#include "support/flight.hpp"

namespace eyrie::test {

/// A scenario flown for `until` s with a seed (none: its own), and orders from outside.
[[nodiscard]] inline debrief::Recorded recorded_flight(
    const std::shared_ptr<const scenario::Scenario>& scenario, const std::string& name,
    double until, std::optional<std::uint64_t> seed = {},
    const std::vector<sim::Order>& given = {}) {
  sim::TrailRecorder trail;
  scenario::Mission mission(scenario, seed.value_or(scenario->spec.seed), until);
  mission.run().attach(trail);
  for (const sim::Order& order : given)
    EXPECT_EQ(mission.run().submit(order), "");
  mission.fly();
  debrief::Recorded r;
  r.file = name;
  r.run = {.build = "test",
           .scenario = scenario->file,
           .files = scenario->files,
           .sets = scenario->sets,
           .seed = seed.value_or(scenario->spec.seed),
           .layout_hash = scenario->simulation->schema().layout_hash(),
           .plugins = {},
           .trail = trail.trail(),
           .orders = scenario->orders,
           .outcome = ""};
  r.run.orders.insert(r.run.orders.end(), given.begin(), given.end());
  r.scenario = scenario;
  return r;
}
[[nodiscard]] inline debrief::Recorded recorded_flight(const std::string& name, double until,
                                                       std::optional<std::uint64_t> seed = {},
                                                       const std::vector<std::string>& sets = {}) {
  return recorded_flight(load_scenario(name, sets), name, until, seed);
}
/// The text of a scenario.
[[nodiscard]] inline debrief::Recorded recorded_text(const std::string& text, double until) {
  scenario::Source source = scenario::Source::disk(".");
  source.add("test.yaml", text);
  return recorded_flight(scenario::load({.file = "test.yaml"}, std::move(source)), "test", until);
}

}  // namespace eyrie::test
