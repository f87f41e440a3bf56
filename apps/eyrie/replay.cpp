// SPDX-License-Identifier: MIT
/// \file  replay: a recorded run once more, with the plug-ins that it had.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "record/run_file.hpp"
#include "report.hpp"
#include "scenario/mission.hpp"
#include "sim/trail.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

/// Where the plug-ins of a run are, in its order: where they were, or a file of that name among
/// `given`. What is missing, another one or not of the run is a problem.
std::vector<std::string> find_plugins(const record::RunFile& run, std::vector<std::string> given,
                                      Diagnostics& problems) {
  std::vector<std::string> found;
  for (const scenario::PluginFile& plugin : run.plugins) {
    const std::string name = fs::path(plugin.path).filename();
    const auto moved = std::find_if(given.begin(), given.end(), [&](const std::string& file) {
      return fs::path(file).filename() == name;
    });
    found.push_back(moved == given.end() ? plugin.path : *moved);
    if (moved != given.end())
      given.erase(moved);
    const auto hash = scenario::hash_of_file(found.back());
    if (!hash)
      problems.error({}, fmt::format("the run needs the plug-in {}, which is not there; --plugin "
                                     "says where it is now",
                                     found.back()));
    else if (*hash != plugin.hash)
      problems.error(
          {}, fmt::format("{} is not the {} of the run: it has other bytes", found.back(), name));
  }
  for (const std::string& file : given)
    problems.error(
        {}, fmt::format("the run has no plug-in {}", quote(fs::path(file).filename().string())));
  return found;
}

}  // namespace

int replay(const ReplayOptions& options) {
  const std::string file =
      fs::is_directory(options.run) ? (fs::path(options.run) / "run.eyrie").string() : options.run;
  const record::Decoded decoded = record::read_run_file(file);
  if (!decoded.error.empty()) {
    fmt::print(stderr, "{}: {}\n", file, decoded.error);
    return 2;
  }
  const record::RunFile& recorded = decoded.run;
  Diagnostics problems;
  const auto plugins = find_plugins(recorded, options.plugins, problems);
  if (!problems.ok()) {
    for (const Diagnostic& problem : problems.sorted())
      fmt::print(stderr, "{}: {}\n", file, problem.text());
    return 2;
  }
  std::shared_ptr<const scenario::Scenario> scenario;
  try {
    scenario = scenario::load({recorded.scenario, recorded.sets, plugins},
                              scenario::Source::bundle(recorded.files));
  } catch (const ConfigError& e) {
    fmt::print(stderr, "{}: this build refuses the scenario inside:\n{}\n", file,
               e.diagnostics().text());
    return 2;
  }
  if (scenario->simulation->schema().layout_hash() != recorded.layout_hash) {
    fmt::print(stderr,
               "{}: recorded by {}, whose world has another layout than that of {}; fly it again "
               "with that build\n",
               file, recorded.build, version_text());
    return 2;
  }

  sim::Run flight(scenario->simulation, scenario->world(recorded.seed),
                  {.workers = options.workers});
  sim::TrailChecker checker(recorded.trail);
  flight.attach(checker);
  for (const sim::Order& order : recorded.orders)
    if (const std::string refused = flight.submit(order); !refused.empty()) {
      fmt::print(stderr, "{}: {}\n", file, refused);
      return 2;
    }
  const auto last = recorded.trail.marks.empty() ? 0 : recorded.trail.marks.back().step;
  while (flight.world().step() < last && !checker.done())
    flight.step();
  flight.finish();

  const auto& departure = checker.departure();
  if (options.json) {
    nlohmann::ordered_json j{{"run", file},
                             {"steps", flight.world().step()},
                             {"hash", hash_text(flight.world().hash())},
                             {"same", !departure}};
    if (departure) {
      j["first_step"] = departure->step;
      j["reason"] = departure->reason;
      if (departure->where)
        j["where"] = {{"table", departure->where->table},
                      {"column", departure->where->column},
                      {"field", departure->where->field},
                      {"player", departure->where->player.value}};
    }
    fmt::print("{}\n", j.dump(2));
  } else if (departure) {
    fmt::print("{}: differs from the recording by {}\n{}\n", file, recorded.build,
               departure->reason);
  } else {
    fmt::print("{}: the same, {} steps, world hash {}\n", file, flight.world().step(),
               hash_text(flight.world().hash()));
  }
  return departure ? 1 : 0;
}

}  // namespace eyrie::app
