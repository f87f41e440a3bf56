// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flights recorded in memory.
#include <string>
#include <vector>

#include "debrief/recorded.hpp"
#include "sim/trail.hpp"
#include "support/flight.hpp"

namespace eyrie::test {

/// A scenario flown for `until` s with a seed (none: its own).
[[nodiscard]] inline debrief::Recorded recorded_flight(const std::string& name, double until,
                                                       std::optional<std::uint64_t> seed = {},
                                                       const std::vector<std::string>& sets = {}) {
  const auto scenario = load_scenario(name, sets);
  sim::TrailRecorder trail;
  scenario::Mission mission(scenario, seed.value_or(scenario->spec.seed), until);
  mission.run().attach(trail);
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
  r.scenario = scenario;
  return r;
}

}  // namespace eyrie::test
