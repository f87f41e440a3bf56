// SPDX-License-Identifier: MIT
#include "scenario/mission.hpp"

#include <algorithm>
#include <filesystem>

#include "model/events.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/plugin_file.hpp"
#include "team/moment.hpp"

namespace eyrie::scenario {
namespace {

/// Code of others may do otherwise the second time.
sim::RunOptions with_copies(sim::RunOptions options, const Scenario& scenario) {
  if (scenario.has_foreign_nodes)
    options.steps_per_copy = 1;
  return options;
}

}  // namespace

std::optional<std::string> until_problem(const ScenarioSpec& spec, double until) {
  const double step = 1 / spec.rates.kinematics;
  if (until >= step && until <= kLongestFlight)
    return std::nullopt;
  const auto show = [](double time) { return exact_quantity(time, Dimension::time); };
  return fmt::format("{} is outside [{}, {}]: from one step to the longest flight", show(until),
                     show(step), show(kLongestFlight));
}

Mission::Mission(std::shared_ptr<const Scenario> scenario, sim::World start, double until,
                 bool any_home, const sim::RunOptions& options)
    : scenario_(std::move(scenario)),
      run_(scenario_->simulation, std::move(start), with_copies(options, *scenario_)),
      until_(until),
      judge_(*scenario_, until_),
      course_{.any_home = any_home},
      outcome_(judge_(run_.world(), any_home)) {}

Mission::Mission(const std::shared_ptr<const Scenario>& scenario, std::uint64_t seed,
                 std::optional<double> until, const sim::RunOptions& options)
    : Mission(scenario, scenario->world(seed), until.value_or(scenario->spec.until), false,
              options) {
  for (const sim::Order& order : scenario_->orders)
    static_cast<void>(run_.submit(order));  // of a kind that the pilots accept, at a step to come
}

Judge::Judge(const Scenario& scenario, double until)
    : scenario_(&scenario),
      last_step_(scenario.spec.rates.step_at(until)),
      somebody_may_arrive_(std::ranges::any_of(
          scenario.fleets,
          [](const auto& fleet) { return fleet->agents && !fleet->words.comes_home; })),
      standings_(scenario.library->flights.size()) {}

std::optional<std::string> start_problem(const Scenario& scenario) {
  const Outcome outcome = Judge(scenario, scenario.spec.until)(*scenario.start, false);
  if (outcome == Outcome::running)
    return std::nullopt;
  return fmt::format("ends: {} holds at the start already ({}): nothing would be flown",
                     enum_name(scenario.spec.ends), enum_name(outcome));
}

bool Judge::is_home_of_blue(const sim::Event& event) const {
  if (event.kind != sim::EventKind(model::EventKind::home))
    return false;
  const Roster::Player* who = scenario_->roster.find(event.who);
  return who && who->side == model::Side::blue;
}

Outcome Judge::operator()(const sim::World& world, bool any_home) {
  std::ranges::fill(standings_, Standing{});
  for (const auto& fleet : scenario_->fleets)
    fleet->count(world, *scenario_->library, standings_);
  std::uint32_t blue = 0, red = 0;
  bool any_arrived = false;
  for (std::size_t f = 0; f < standings_.size(); ++f) {
    const Standing& flight = standings_[f];
    const bool is_blue = scenario_->library->flights[f].side == model::Side::blue;
    const bool arrived = scenario_->spec.ends == Ends::blue_home && flight.at_the_end &&
                         !flight.moving && flight.players > 0;
    any_arrived |= arrived && is_blue;
    if (!arrived)
      (is_blue ? blue : red) += flight.players;
  }
  if (scenario_->spec.ends == Ends::blue_home && blue == 0)
    return any_home || any_arrived ? Outcome::blue_home : Outcome::blue_lost;
  if (scenario_->spec.ends == Ends::last_side && (blue == 0 || red == 0))
    return blue > 0 ? Outcome::red_lost : red > 0 ? Outcome::blue_lost : Outcome::both_lost;
  return by_time(world);
}

bool Mission::step() {
  if (outcome_ != Outcome::running)
    return false;
  const auto events = run_.step();
  if (run_.fault()) {
    outcome_ = Outcome::fault;
    return false;
  }
  outcome_ = judge_.after_step(run_.world(), events, course_);
  return true;
}

void Mission::fly() {
  while (step()) {
  }
  run_.finish();
}

std::string fault_text(const sim::Fault& fault, const Roster& roster, double dt) {
  std::string who = fault.agent;
  if (const std::string plugin = plugin_at(fault.node); !plugin.empty())
    who += fmt::format(", from {},", shell_word(std::filesystem::path(plugin).filename().string()));
  const std::string name = fault.player ? roster.name(fault.player) + " at " : "";
  return fmt::format("{}{:.2f} s (step {}): {}{}{}", name, static_cast<double>(fault.step) * dt,
                     fault.step, who, who.empty() ? "" : " ", fault.what);
}

sim::Fault fault_of_end(const std::string& done) {
  const team::Underway* now = team::underway();
  if (!now)
    return {.what = done};
  return {.player = now->player,
          .what = fmt::format("{} in a decision of tree '{}'", done, now->tree),
          .step = now->step};
}

}  // namespace eyrie::scenario
