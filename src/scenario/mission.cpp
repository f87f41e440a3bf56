// SPDX-License-Identifier: MIT
#include "scenario/mission.hpp"

#include <cmath>

#include "model/events.hpp"

namespace eyrie::scenario {

std::string_view outcome_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::running:
      return "running";
    case Outcome::blue_home:
      return "blue_home";
    case Outcome::blue_lost:
      return "blue_lost";
    case Outcome::red_lost:
      return "red_lost";
    case Outcome::time:
      return "time";
    case Outcome::stopped:
      return "stopped";
  }
  return "?";
}

Mission::Mission(std::shared_ptr<const Scenario> scenario, std::uint64_t seed,
                 std::optional<double> until, const sim::RunOptions& options)
    : scenario_(std::move(scenario)),
      run_(scenario_->simulation, scenario_->world(seed), options),
      until_(until.value_or(scenario_->spec.until)),
      last_step_(
          static_cast<std::uint64_t>(std::floor(until_ * scenario_->spec.rates.kinematics + 0.5))) {
  for (const sim::Order& order : scenario_->orders)
    static_cast<void>(run_.submit(order));  // of a kind that the pilots accept, at a step to come
}

Outcome Mission::judge() const {
  std::uint32_t blue = 0, red = 0;
  for (const model::Fit& fit : run_.world().rows(scenario_->aircraft.fit)) {
    blue += fit.side == model::Side::blue;
    red += fit.side == model::Side::red;
  }
  if (scenario_->spec.ends == Ends::blue_home && blue == 0)
    return any_home_ ? Outcome::blue_home : Outcome::blue_lost;
  if (scenario_->spec.ends == Ends::last_side && (blue == 0 || red == 0))
    return blue == 0 ? Outcome::blue_lost : Outcome::red_lost;
  return run_.world().step() >= last_step_ ? Outcome::time : Outcome::running;
}

bool Mission::step() {
  if (outcome_ != Outcome::running)
    return false;
  outcome_ = judge();
  if (outcome_ != Outcome::running)
    return false;
  for (const sim::Event& e : run_.step()) {
    const auto& roster = scenario_->roster;
    if (e.kind == sim::EventKind(model::EventKind::home) && roster.find(e.who))
      any_home_ |= roster.find(e.who)->side == model::Side::blue;
  }
  return true;
}

void Mission::fly() {
  while (step()) {
  }
  run_.finish();
}

}  // namespace eyrie::scenario
