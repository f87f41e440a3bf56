// SPDX-License-Identifier: MIT
#include "debrief/recorded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/assert.hpp"
#include "core/text.hpp"

#include "scenario/mission.hpp"

namespace eyrie::debrief {
namespace {

constexpr double kLongestRun = 1e6;  // s, as scenarios allow

/// What the file says of its flight and no flight of its scenario can have: more time than any,
/// other orders.
std::vector<std::string> false_claims(const record::RunFile& run,
                                      const sim::Simulation& simulation) {
  std::vector<std::string> problems;
  if (static_cast<double>(run.trail.last_step) * simulation.dt() > kLongestRun)
    problems.push_back(fmt::format("it claims {} steps, more than a run can have: {} s",
                                   run.trail.last_step, kLongestRun));
  const sim::Order* last = nullptr;
  for (const sim::Order& order : run.orders) {
    if (simulation.handler(order.kind) == nullptr)
      problems.push_back(
          fmt::format("nobody in its scenario accepts orders of kind {}", order.kind.value));
    else if (last && order.step < last->step)
      problems.push_back(fmt::format("its orders for the steps {} and {} stand the wrong way round",
                                     last->step, order.step));
    if (!problems.empty())
      break;
    last = &order;
  }
  return problems;
}

}  // namespace

Opened open(record::RunFile run, std::string file, std::vector<std::string> plugins,
            std::string_view build) {
  Recorded recorded{std::move(file), std::move(run), std::move(plugins), nullptr};
  try {
    recorded.scenario = with_overrides(recorded, {});
  } catch (const ConfigError& e) {
    return {std::nullopt, {"this build refuses the scenario inside:\n" + e.diagnostics().text()}};
  }
  const auto& scenario = *recorded.scenario;
  if (scenario.simulation->schema().layout_hash() != recorded.run.layout_hash)
    return {std::nullopt,
            {fmt::format("recorded by {}, whose world has another layout than that of {}; fly it "
                         "again with that build",
                         printable(recorded.run.build), build)}};
  if (auto problems = false_claims(recorded.run, *scenario.simulation); !problems.empty())
    return {std::nullopt, std::move(problems)};
  return {std::move(recorded), {}};
}

std::shared_ptr<const scenario::Scenario> with_overrides(
    const Recorded& recorded, const std::vector<std::string>& sets,
    std::vector<scenario::TreeChange> changes) {
  std::vector<std::string> all = recorded.run.sets;
  all.insert(all.end(), sets.begin(), sets.end());
  return scenario::load(
      {recorded.run.scenario, std::move(all), recorded.plugins, std::move(changes)},
      scenario::Source::bundle(recorded.run.files));
}

Past past_at(const Recorded& recorded, std::uint64_t step) {
  Reflight flight(recorded);
  std::vector<Happened> events;
  while (flight.after().step() < step && flight.step())
    if (!flight.events().empty())
      events.push_back(flight.happened());
  return {flight.after(), std::move(events)};
}

Reflight::Reflight(const Recorded& recorded, sim::World from)
    : recorded_(recorded),
      run_(recorded.scenario->simulation, std::move(from)),
      before_(run_.world()) {
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= before_.step())
      EYRIE_DEMAND(run_.submit(order).empty(), "open() refuses such orders");
}

Reflight::Reflight(const Recorded& recorded)
    : Reflight(recorded, recorded.scenario->world(recorded.run.seed)) {
  run_.attach(checker_.emplace(recorded.run.trail));
}

Happened Reflight::happened() const {
  return {{before_.step(), recorded_.run.seed, run_.simulation().dt()},
          {events_.begin(), events_.end()}};
}

bool Reflight::step() {
  demand_the_same();  // also as it began
  if (run_.world().step() >= recorded_.last_step())
    return false;
  before_ = run_.world();
  events_ = run_.step();
  if (const sim::Fault* fault = run_.fault())
    throw std::runtime_error(fmt::format(
        "{}: it cannot be flown again: {}", recorded_.file,
        scenario::fault_text(*fault, recorded_.scenario->roster, run_.simulation().dt())));
  demand_the_same();
  return true;
}

void Reflight::demand_the_same() {
  if (!checker_ || !checker_->departure())
    return;
  // up to the next mark, which knows the field
  while (!checker_->done() && !run_.fault() && run_.world().step() < recorded_.last_step())
    run_.step();
  throw std::runtime_error(fmt::format("{}: this is not the run that was recorded by {}: {}",
                                       recorded_.file, recorded_.run.build,
                                       checker_->departure()->reason));
}

}  // namespace eyrie::debrief
