// SPDX-License-Identifier: MIT
/// \file  export: a recorded run for other tools.
#include <filesystem>

#include "command.hpp"
#include "commands.hpp"
#include "debrief/decision.hpp"
#include "disk/output.hpp"
#include "locate.hpp"
#include "record/paths.hpp"
#include "record/run_file.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

void write_paths(const debrief::Recorded& recorded, ExportFormat format, disk::Sink& sink) {
  record::Paths paths(*recorded.scenario);
  debrief::Reflight flight(recorded);
  flight.attach(paths);
  while (!interrupted() && flight.step()) {
  }
  paths.finish(flight.after());
  sink.write(format == ExportFormat::czml ? record::czml(paths) : record::geojson(paths));
}

/// Every decision of every player, or of one.
void write_decisions(const debrief::Recorded& recorded, std::optional<PlayerId> who,
                     disk::Sink& sink) {
  const scenario::Scenario& scenario = *recorded.scenario;
  debrief::Reflight flight(recorded);
  std::vector<debrief::Decision> decisions;
  bool first = true;
  const auto flush = [&] {
    const std::string text = debrief::decisions_csv(decisions, scenario.roster);
    sink.write(first ? std::string_view(text) : std::string_view(text).substr(text.find('\n') + 1));
    first = false;
    decisions.clear();
  };
  while (!interrupted() && flight.step()) {
    for (std::uint32_t id = 1; id <= scenario.roster.players.size(); ++id)
      if (!who || *who == PlayerId{id})
        if (auto decision = debrief::explain(scenario, flight.before(), flight.after(),
                                             PlayerId{id}, flight.orders()))
          decisions.push_back(std::move(*decision));
    if (decisions.size() > 1000)
      flush();
  }
  flush();
}

}  // namespace

int export_run(const ExportOptions& options) {
  const debrief::Recorded recorded = open_run(options.run, options.plugins);
  std::optional<PlayerId> who;
  if (!options.player.empty()) {
    who = player_named(recorded.scenario->roster, options.player);
    if (options.format != ExportFormat::decisions)
      refuse("--player is for decisions: paths are those of all players");
  }
  constexpr const char* kNames[] = {record::kCzmlName, record::kGeojsonName,
                                    record::kDecisionsName};
  const std::string beside =
      fs::path(recorded.file).parent_path() / kNames[static_cast<int>(options.format)];
  const std::string& file = options.out.empty() ? beside : options.out;
  listen_for_interrupts();
  disk::OutputFile out(file, options.force || options.out.empty());
  if (options.format == ExportFormat::decisions)
    write_decisions(recorded, who, out.sink());
  else
    write_paths(recorded, options.format, out.sink());
  finish(out);
  return 0;
}

}  // namespace eyrie::app
