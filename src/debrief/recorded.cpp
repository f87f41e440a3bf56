// SPDX-License-Identifier: MIT
#include "debrief/recorded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "core/assert.hpp"
#include "core/printable.hpp"

#include "scenario/fault_text.hpp"

namespace eyrie::debrief {
namespace {
namespace fs = std::filesystem;

constexpr double kLongestRun = 1e6;  // s, as scenarios allow

/// Why a plug-in of the run cannot be used; empty if it can. `unasked`: the run file alone names
/// it.
std::string plugin_problem(const scenario::PluginFile& plugin, const std::string& file,
                           bool unasked, const scenario::PluginPermission& may_open) {
  const std::string shown = scenario::shell_word(file);
  const std::string name = scenario::shell_word(fs::path(plugin.path).filename().string());
  std::error_code failed;
  if (unasked && !fs::path(file).is_absolute())
    return fmt::format(
        "the run needs the plug-in {}, at no absolute path; --plugin says where it "
        "is",
        shown);
  if (!fs::exists(file, failed))
    return fmt::format(
        "the run needs the plug-in {}, which is not there; --plugin says where it "
        "is now",
        shown);
  const scenario::FileBytes read = scenario::read_plugin_file(file);
  if (!read.problem.empty())
    return fmt::format("the run needs the plug-in {}: {}", shown, read.problem);
  if (unasked)
    if (const std::string why =
            scenario::refusal(may_open, fs::weakly_canonical(file, failed).string(), read.bytes);
        !why.empty())
      return fmt::format("the run needs the plug-in {}: {}", shown,
                         scenario::not_opened(why, file));
  if (scenario::hash_of(read.bytes) != plugin.hash)
    return fmt::format("{} is not the {} of the run: it has other bytes", shown, name);
  return {};
}

/// Where the plug-ins of a run are, in its order: a file of that name among `given`, or else where
/// the run file says, if that one may be opened. What is missing, another one or not of the run is
/// a problem.
std::vector<std::string> find_plugins(const record::RunFile& run, std::vector<std::string> given,
                                      const scenario::PluginPermission& may_open,
                                      std::vector<std::string>& problems) {
  std::vector<std::string> found;
  for (const scenario::PluginFile& plugin : run.plugins) {
    const auto typed = std::find_if(given.begin(), given.end(), [&](const std::string& file) {
      return fs::path(file).filename() == fs::path(plugin.path).filename();
    });
    const bool unasked = typed == given.end();
    found.push_back(unasked ? plugin.path : *typed);
    if (!unasked)
      given.erase(typed);
    if (auto problem = plugin_problem(plugin, found.back(), unasked, may_open); !problem.empty())
      problems.push_back(std::move(problem));
  }
  for (const std::string& file : given)
    problems.push_back(
        fmt::format("the run has no plug-in {}", quote(fs::path(file).filename().string())));
  return found;
}

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

Opened open(const std::string& path, std::vector<std::string> plugins, std::string_view build,
            const scenario::PluginPermission& may_open) {
  Recorded recorded;
  std::error_code ignored;
  recorded.file = fs::is_directory(path, ignored) ? (fs::path(path) / "run.eyrie").string() : path;
  std::vector<std::string> problems;
  const auto refused = [&] {
    constexpr std::size_t kWhole = 300;  // a longer path is shortened
    const std::string file = recorded.file.size() > kWhole ? quote(recorded.file) : recorded.file;
    for (std::string& problem : problems)
      problem = fmt::format("{}: {}", file, problem);
    return Opened{std::nullopt, std::move(problems)};
  };
  record::Decoded decoded = record::read_run_file(recorded.file);
  if (!decoded.error.empty()) {
    problems.push_back(decoded.error);
    return refused();
  }
  recorded.run = std::move(decoded.run);
  recorded.plugins = find_plugins(recorded.run, std::move(plugins), may_open, problems);
  if (!problems.empty())
    return refused();
  try {
    recorded.scenario = with_overrides(recorded, {});
  } catch (const ConfigError& e) {
    problems.push_back("this build refuses the scenario inside:\n" + e.diagnostics().text());
    return refused();
  }
  const auto& scenario = *recorded.scenario;
  if (scenario.simulation->schema().layout_hash() != recorded.run.layout_hash) {
    problems.push_back(
        fmt::format("recorded by {}, whose world has another layout than that of {}; fly it again "
                    "with that build",
                    printable(recorded.run.build), build));
    return refused();
  }
  problems = false_claims(recorded.run, *scenario.simulation);
  if (!problems.empty())
    return refused();
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

Reflight::Reflight(const Recorded& recorded)
    : recorded_(recorded),
      run_(recorded.scenario->simulation, recorded.scenario->world(recorded.run.seed)),
      checker_(recorded.run.trail),
      before_(run_.world()) {
  for (const sim::Order& order : recorded.run.orders)
    EYRIE_DEMAND(run_.submit(order).empty(), "open() refuses such orders");
  run_.attach(checker_);
}

bool Reflight::step() {
  demand_the_same();  // also as it began
  if (run_.world().step() >= recorded_.last_step())
    return false;
  before_ = run_.world();
  orders_.clear();
  const auto all = run_.orders();  // by step
  while (next_order_ < all.size() && all[next_order_].step == before_.step())
    orders_.push_back(all[next_order_++]);
  events_ = run_.step();
  if (const sim::Fault* fault = run_.fault())
    throw std::runtime_error(fmt::format(
        "{}: it cannot be flown again: {}", recorded_.file,
        scenario::fault_text(*fault, recorded_.scenario->roster, run_.simulation().dt())));
  demand_the_same();
  return true;
}

void Reflight::demand_the_same() {
  if (!checker_.departure())
    return;
  // up to the next mark, which knows the field
  while (!checker_.done() && !run_.fault() && run_.world().step() < recorded_.last_step())
    run_.step();
  throw std::runtime_error(fmt::format("{}: this is not the run that was recorded by {}: {}",
                                       recorded_.file, recorded_.run.build,
                                       checker_.departure()->reason));
}

}  // namespace eyrie::debrief
