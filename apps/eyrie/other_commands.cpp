// SPDX-License-Identifier: MIT
/// \file  validate, replay and --version.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "locate.hpp"
#include "record/run_file.hpp"
#include "report.hpp"
#include "scenario/mission.hpp"
#include "sim/trail.hpp"

namespace eyrie::app {

std::string version_text() {
  return "eyrie " EYRIE_VERSION " (" EYRIE_COMPILER ", " EYRIE_BUILD_TYPE ")";
}

namespace {

/// "1 flight", "2 flights"
std::string counted(std::size_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// "6 aircraft in 2 flights and 5 vehicles in 1 convoy"
std::string players_text(const scenario::Scenario& scenario) {
  const std::size_t vehicles = scenario.count(scenario::Platform::vehicle);
  const std::size_t aircraft = scenario.count(scenario::Platform::aircraft);
  std::size_t convoys = 0;
  for (const auto& flight : scenario.roster.flights)
    convoys +=
        scenario.roster.find(flight.members.front())->platform == scenario::Platform::vehicle;
  const std::string air = fmt::format("{} aircraft in {}", aircraft,
                                      counted(scenario.roster.flights.size() - convoys, "flight"));
  const std::string ground =
      fmt::format("{} in {}", counted(vehicles, "vehicle"), counted(convoys, "convoy"));
  return !vehicles ? air : !aircraft ? ground : air + " and " + ground;
}

}  // namespace

int validate(const std::vector<std::string>& files) {
  int code = 0;
  for (const std::string& file : files) {
    if (const auto scenario = load_or_complain(file, {}))
      fmt::print("{}: {}, {}\n", scenario->file, players_text(*scenario),
                 counted(scenario->trees->size() + scenario->driver_trees->size(), "tree"));
    else
      code = 2;
  }
  return code;
}

int replay(const std::string& run, unsigned workers, bool json) {
  const std::string file = std::filesystem::is_directory(run)
                               ? (std::filesystem::path(run) / "run.eyrie").string()
                               : run;
  const record::Decoded decoded = record::read_run_file(file);
  if (!decoded.error.empty()) {
    fmt::print(stderr, "{}: {}\n", file, decoded.error);
    return 2;
  }
  const record::RunFile& recorded = decoded.run;
  std::shared_ptr<const scenario::Scenario> scenario;
  try {
    scenario = scenario::load({recorded.scenario, recorded.sets},
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

  sim::Run flight(scenario->simulation, scenario->world(recorded.seed), {.workers = workers});
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
  if (json) {
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
