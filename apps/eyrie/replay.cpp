// SPDX-License-Identifier: MIT
/// \file  replay: a recorded run once more, with the plug-ins that it had; diff: two of them.
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/assert.hpp"
#include "debrief/recorded.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "record/story.hpp"
#include "say.hpp"
#include "scenario/mission.hpp"
#include "sim/trail.hpp"

namespace eyrie::app {

namespace {

using Json = nlohmann::ordered_json;

Json parting_json(const std::optional<debrief::Parting>& parting) {
  if (!parting)
    return {};
  return {{"time_s", parting->time}, {"step", parting->step}, {"text", parting->text}};
}

}  // namespace

int replay(const ReplayOptions& options) {
  const debrief::Recorded opened = open_run(options.run, options.plugins);
  const record::RunFile& recorded = opened.run;
  const std::string& file = opened.file;
  const auto& scenario = opened.scenario;

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
    Json j{{"run", file},
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
    say("{}: the same, {}, world hash {}\n", file, counted(flight.world().step(), "step"),
        hash_text(flight.world().hash()));
  }
  return departure ? 1 : 0;
}

int diff(const DiffOptions& options) {
  const auto runs = open_runs(options.runs, options.plugins);
  const debrief::Recorded &a = runs[0], &b = runs[1];
  std::string problem;
  const auto found = debrief::compare(a, b, problem);
  if (!found)
    refuse("{}", problem);
  if (options.json) {
    const Json j{{"left", a.file},
                 {"right", b.file},
                 {"same", found->same()},
                 {"steps", found->steps},
                 {"world", parting_json(found->world)},
                 {"action", parting_json(found->action)},
                 {"event", parting_json(found->event)}};
    say("{}", Composed{record::json_lines(j)});
    return found->same() ? 0 : 1;
  }
  if (found->same())
    say("the same, {}\n", counted(found->steps, "step"));
  for (const auto& [name, place] :
       {std::pair("world", &found->world), std::pair("action", &found->action),
        std::pair("event", &found->event)})
    if (*place)
      say("{:<7} {:>8}  {}\n", name, record::clock_text((*place)->time), (*place)->text);
  return found->same() ? 0 : 1;
}

}  // namespace eyrie::app
