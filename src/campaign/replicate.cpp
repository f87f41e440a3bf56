// SPDX-License-Identifier: MIT
#include "campaign/replicate.hpp"

namespace eyrie::campaign {

Flown fly(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed,
          std::span<sim::Observer* const> observers, std::optional<double> until,
          bool (*given_up)()) {
  scenario::Mission mission(scenario, seed, until);
  sim::Run& run = mission.run();
  for (sim::Observer* observer : observers)
    run.attach(*observer);
  while (mission.step())
    if (given_up && given_up())
      mission.stop();
  run.finish();
  Flown flown{.seed = seed,
              .steps = run.world().step(),
              .hash = run.world().hash(),
              .outcome = mission.outcome(),
              .time = run.time(),
              .fault = {}};
  if (const sim::Fault* fault = run.fault())
    flown.fault = scenario::fault_text(*fault, scenario->roster, run.simulation().dt());
  return flown;
}

std::string fly_command(
    const std::string& scenario,
    const std::vector<std::pair<const char*, std::vector<std::string>>>& options) {
  std::string text = "eyrie fly";
  if (!scenario.empty())
    text += " " + scenario::shell_word(scenario);
  for (const auto& [option, values] : options)
    for (const std::string& value : values)
      text += fmt::format(" {} {}", option, scenario::shell_word(value));
  return text;
}

}  // namespace eyrie::campaign
