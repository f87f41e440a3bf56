// SPDX-License-Identifier: MIT
#pragma once
/// \file  One flight of many.
#include <memory>
#include <optional>
#include <span>

#include "scenario/mission.hpp"

namespace eyrie::campaign {

/// How a flight ended. It depends on the scenario and the seed alone.
struct Flown {
  std::uint64_t seed = 0;
  std::uint64_t steps = 0;
  std::uint64_t hash = 0;  ///< of the last whole world
  scenario::Outcome outcome = scenario::Outcome::running;
  double time = 0;    ///< s
  std::string fault;  ///< why it could not go on, if the outcome is that
};

/// Flies a scenario from its start to its end, or to `until` (s) instead of the scenario's own. The
/// observers see every step. `given_up`, asked in every step, stops the flight there. Any number of
/// threads may fly one scenario.
[[nodiscard]] Flown fly(const std::shared_ptr<const scenario::Scenario>& scenario,
                        std::uint64_t seed, std::span<sim::Observer* const> observers = {},
                        std::optional<double> until = {}, bool (*given_up)() = nullptr);

/// The command that flies a scenario: options with their values.
[[nodiscard]] std::string fly_command(
    const std::string& scenario,
    const std::vector<std::pair<const char*, std::vector<std::string>>>& options);

}  // namespace eyrie::campaign
