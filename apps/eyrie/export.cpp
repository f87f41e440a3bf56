// SPDX-License-Identifier: MIT
/// \file  export: a recorded run for other tools.
#include <filesystem>

#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "dis/pcap.hpp"
#include "disk/output.hpp"
#include "live.hpp"
#include "locate.hpp"
#include "record/paths.hpp"
#include "record/run_file.hpp"
#include "say.hpp"
#include "tables/csv_files.hpp"
#include "tables/schema.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

void fly_again(const debrief::Recorded& recorded, sim::Observer& observer) {
  debrief::Reflight flight(recorded);
  flight.attach(observer);
  while (!interrupted() && flight.step()) {
  }
  observer.finish(flight.after());
}

void write_paths(const debrief::Recorded& recorded, ExportFormat format, disk::Sink& sink) {
  record::Paths paths(*recorded.scenario);
  fly_again(recorded, paths);
  if (const double pause = paths.widest_pause(); pause > 0)
    complain("eyrie: {} is long: of a path with more than {} fixes each {:.3g} s is kept\n",
             recorded.file, record::Paths::kMost, pause);
  sink.write(format == ExportFormat::czml ? record::czml(paths) : record::geojson(paths));
}

void write_packets(const debrief::Recorded& recorded, disk::Sink& sink) {
  dis::PcapWriter pcap(sink, std::uint64_t{dis::kFirstHour} * 3600);
  dis::Announcer announcer(*recorded.scenario, {}, [&](double time, const dis::Packet& packet) {
    pcap.write(time, dis::encode(packet));
  });
  fly_again(recorded, announcer);
  tell_nameless(announcer);
}

tables::Selection selection_of(const ExportOptions& options, const debrief::Recorded& recorded) {
  tables::Selection selection;
  selection.changes_only = options.changes_only;
  if (!options.player.empty())
    selection.who = player_named(recorded.scenario->roster, options.player);
  if (!options.every.empty())
    selection.every = period_named("--every", options.every);
  return selection;
}

void write_tables(const debrief::Recorded& recorded, const ExportOptions& options,
                  const std::string& file, disk::Sink& sink) {
  const tables::Selection selection = selection_of(options, recorded);
  if (options.format == ExportFormat::sqlite) {
    if (const auto bytes = tables::run_database(recorded, selection, interrupted))
      sink.write(*bytes);
    return;
  }
  tables::TextFile text(sink, file.ends_with(".gz"));
  (options.format == ExportFormat::decisions ? tables::write_decisions : tables::write_answers)(
      recorded, selection, text, interrupted);
}

}  // namespace

int export_run(const ExportOptions& options) {
  const bool paths =
      options.format == ExportFormat::czml || options.format == ExportFormat::geojson;
  const bool packets = options.format == ExportFormat::pcap;
  const bool csv = !paths && !packets && options.format != ExportFormat::sqlite;
  const std::string end = fs::path(options.out).extension();
  if ((end != ".gz" && to_small(end) == ".gz") || (end == ".gz" && !csv))
    refuse("--out {}: only CSV is compressed, and only for a name that ends with '.gz'",
           quote_path(options.out));
  const bool part = !options.player.empty() || !options.every.empty() || options.changes_only;
  if ((paths || packets) && part)
    refuse("--player, --every and --changes-only are for decisions: {} are those of all players",
           packets ? "packets" : "paths");
  const debrief::Recorded recorded = open_run(options.run, options.plugins);
  selection_of(options, recorded);
  constexpr const char* kNames[] = {record::kCzmlName,      record::kGeojsonName,
                                    record::kDecisionsName, record::kAnswersName,
                                    record::kDatabaseName,  record::kPcapName};
  const std::string beside =
      fs::path(recorded.file).parent_path() / kNames[static_cast<int>(options.format)];
  const std::string& file = options.out.empty() ? beside : options.out;
  demand_other_file(file, {recorded.file});
  listen_for_interrupts();
  const bool whole = options.out.empty() && !part;
  disk::OutputFile out(file, options.force || (whole && is_own_folder(recorded)));
  if (paths)
    write_paths(recorded, options.format, out.sink());
  else if (packets)
    write_packets(recorded, out.sink());
  else
    write_tables(recorded, options, file, out.sink());
  finish(out);
  return 0;
}

}  // namespace eyrie::app
