// SPDX-License-Identifier: MIT
/// \file  replay: a recorded run once more, with the plug-ins that it had.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/assert.hpp"
#include "debrief/recorded.hpp"
#include "record/json_text.hpp"
#include "report.hpp"
#include "say.hpp"
#include "scenario/fault_text.hpp"
#include "sim/trail.hpp"

namespace eyrie::app {

std::optional<debrief::Recorded> open_or_complain(const std::string& run,
                                                  const std::vector<std::string>& plugins) {
  debrief::Opened opened = debrief::open(run, plugins, version_text(), trusted());
  for (const std::string& problem : opened.problems)
    complain("{}\n", lines(problem));
  return std::move(opened.recorded);
}

int replay(const ReplayOptions& options) {
  const auto opened = open_or_complain(options.run, options.plugins);
  if (!opened)
    return 2;
  const record::RunFile& recorded = opened->run;
  const std::string& file = opened->file;
  const auto& scenario = opened->scenario;

  sim::Run flight(scenario->simulation, scenario->world(recorded.seed),
                  {.workers = options.workers});
  sim::TrailChecker checker(recorded.trail);
  flight.attach(checker);
  for (const sim::Order& order : recorded.orders)
    EYRIE_DEMAND(flight.submit(order).empty(), "open() refuses such orders");
  while (flight.world().step() < recorded.trail.last_step && !checker.done() && !flight.fault())
    flight.step();
  if (const sim::Fault* fault = flight.fault()) {
    complain("{}: it cannot be flown again: {}\n", file,
             scenario::fault_text(*fault, scenario->roster, flight.simulation().dt()));
    return 1;
  }
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
    say("{}", Composed{record::json_lines(j)});
  } else if (departure) {
    say("{}: differs from the recording by {}\n{}\n", file, recorded.build, departure->reason);
  } else {
    say("{}: the same, {} steps, world hash {}\n", file, flight.world().step(),
        hash_text(flight.world().hash()));
  }
  return departure ? 1 : 0;
}

}  // namespace eyrie::app
