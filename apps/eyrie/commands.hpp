// SPDX-License-Identifier: MIT
#pragma once
/// \file  The subcommands of the program. Each gives the exit code: 0 done, 1 failed, 2 the user's
/// mistake.
#include "core/enum_names.hpp"
#include "debrief/recorded.hpp"

namespace eyrie::app {

struct FlyOptions {
  std::string scenario;  ///< file, or the name of one in scenarios/; empty: the sweep
  std::optional<std::uint64_t> seed;
  std::string seeds;  ///< "1..500": fly all of them instead, and write nothing
  std::vector<std::string> sets, plugins, includes;
  std::string out;                  ///< folder; empty: runs/<scenario>-<seed>
  std::string until;                ///< quantity; empty: as the scenario says
  std::optional<unsigned> workers;  ///< 1, with `seeds` all cores
  unsigned paranoid = 0;            ///< workers of the second step; 0: off
  std::optional<double> real_time;  ///< seconds of the mission in one of the clock; 0: unpaced
  std::string tacview;              ///< where to listen for it; empty: nowhere
  std::string tacview_password;     ///< file; empty: none
  bool tacview_wait = false;        ///< flies when somebody has joined
  std::string dis;                  ///< where to send packets of DIS; empty: nowhere
  std::string dis_station, dis_interface, dis_threshold;  ///< empty: the usual ones
  bool dis_obey = false;  ///< starts and stops when another simulation says so
  std::string ours;       ///< "blue,bogey2": whom we fly; empty: as the scenario says
  bool quiet = false, json = false, force = false;
  bool debrief = true;  ///< writes the page beside the run
  bool watch = false;   ///< flies again whenever a file of the scenario changes
};

/// Threads that fly many runs at once: as many as this process may use cores.
[[nodiscard]] unsigned cores();

int fly(const FlyOptions& options);
/// With `seeds`; `until` (s) as for a mission.
int fly_seeds(const FlyOptions& options, const std::shared_ptr<const scenario::Scenario>& scenario,
              std::optional<double> until);

struct ValidateOptions {
  std::vector<std::string> files, plugins, includes;
  bool print = false;  ///< the whole scenario, with what it extends and includes
};
int validate(const ValidateOptions& options);

/// Of a campaign or a search.
struct FlightsOptions {
  std::string file;
  std::vector<std::string> plugins, includes;
  std::string out;       ///< folder; empty: campaigns/<name>, searches/<name>
  unsigned workers = 0;  ///< 0: one for each core
  bool resume = false, json = false;
};
struct CampaignOptions : FlightsOptions {
  std::string part;  ///< "3/16"; empty: all of it
  bool join = false;
};
int campaign(const CampaignOptions& options);

struct ResultsOptions {
  std::string folder;    ///< of a campaign
  unsigned workers = 0;  ///< 0: one for each core
  std::vector<std::string> plugins;
};
struct CampaignReportOptions : ResultsOptions {
  std::string out;  ///< file; empty: report.html in the folder
  bool force = false;
  std::string of;        ///< the measure by which all cells are compared; empty: by each
  bool parquet = false;  ///< writes results.parquet, too
  std::optional<std::uint64_t> ways;  ///< replicates of a cell whose ways are drawn
};
int campaign_report(const CampaignReportOptions& options);

struct QueryOptions : ResultsOptions {
  std::string sql;
  std::string decisions;  ///< a time; empty: nothing is flown again
};
int query(const QueryOptions& options);

int optimize(const FlightsOptions& options);

struct ExplainOptions {
  std::string run;  ///< a run folder or its run file
  std::string player;
  std::string at, from, to;  ///< times, as 312.4, '5 min' or 5:12.4
  std::string event;         ///< in the name or the story of an event
  bool changes = false, json = false, csv = false;
  std::vector<std::string> plugins;
};
int explain(const ExplainOptions& options);

struct WhatIfOptions {
  std::string run, player;
  std::vector<std::string> sets;
  std::string at;           ///< a time; empty: the beginning
  bool branch = false;      ///< fly on from the first difference
  std::uint32_t seeds = 0;  ///< fly so many seeds both ways; 0: none
  bool json = false;
  std::vector<std::string> plugins;
};
int what_if(const WhatIfOptions& options);

struct DiffOptions {
  std::vector<std::string> runs;  ///< two
  bool json = false;
  std::vector<std::string> plugins;
};
int diff(const DiffOptions& options);

struct DebriefOptions {
  std::vector<std::string> runs;  ///< one, or two to compare: run folders or run files
  std::string out;                ///< file; empty: beside the first run
  bool force = false;
  bool columns = false;  ///< what was recorded, not the run file and the engine
  std::vector<std::string> plugins;
};
int debrief_page(const DebriefOptions& options);

/// The page without anything in it. Throws disk::Failed if there is none.
std::string demand_viewer();
/// The page of one run or two, by the engine in it or (`columns`) what was recorded. "" if it was
/// interrupted; throws disk::Failed if it cannot be.
[[nodiscard]] std::string debrief_text(const std::vector<debrief::Recorded>& runs, bool columns);
/// The page that looks at a mission while it is flown; `home`: it was chosen on the home page.
[[nodiscard]] std::string live_text(const scenario::Scenario& scenario, std::uint64_t seed,
                                    bool home);

struct ServeOptions {
  std::vector<std::string> what;  ///< one run or two, or a scenario; empty: the home page
  std::uint16_t port = 8042;
  std::string address = "127.0.0.1";
  std::vector<std::string> plugins;  ///< of the runs
  // of a scenario; its rate is real_time, 1 if that is not set
  FlyOptions flight;
  bool paused = false;
};
/// Until it is interrupted.
int serve(const ServeOptions& options);

/// What became of a page.
struct PageWritten {
  bool written = false;
  bool failed = false;    ///< something went wrong
  std::string problem{};  ///< why there is none
};
/// The page of one run.
[[nodiscard]] PageWritten write_page(const debrief::Recorded& recorded, const std::string& file);

struct ZonesOptions {
  std::vector<std::string> missiles;  ///< names in data/missiles; none: all
  bool check = false;                 ///< writes nothing
  bool draw = false, force = false;
  std::string out = ".";                             ///< folder of the drawings
  std::string altitude = "9 km", speed = "280 m/s";  ///< of both, in a drawing
};
int zones(const ZonesOptions& options);
/// Launch zones are taken from data/zones, and those of other missiles kept in the user's cache.
void keep_zones();

struct PlaygroundOptions {
  std::string out = "playground";  ///< folder
  bool force = false;
};
int playground(const PlaygroundOptions& options);

enum class ExportFormat { czml, geojson, decisions, answers, sqlite, pcap };
constexpr auto names_of(ExportFormat) {
  return names_from_zero<ExportFormat>("czml", "geojson", "decisions", "answers", "sqlite", "pcap");
}
struct ExportOptions {
  std::string run;
  ExportFormat format = ExportFormat::czml;
  // of decisions, answers and sqlite
  std::string player;         ///< whose decisions; empty: everybody's
  std::string every;          ///< a time: at most one decision of a player in it
  bool changes_only = false;  ///< only decisions that are others than those before them
  std::string out;            ///< file; empty: run.czml, run.geojson, run.sqlite ... beside the run
  bool force = false;
  std::vector<std::string> plugins;
};
int export_run(const ExportOptions& options);

struct CatalogOptions {
  std::string node;                            ///< only this one; empty: everything
  bool markdown = false, json_schema = false;  ///< neither: a short list
  bool events = false;  ///< instead: what each kind of event means, as docs/events.md
  bool tables = false;  ///< instead: what run.sqlite holds, as docs/tables.md
  std::vector<std::string> plugins;
};
int catalog(const CatalogOptions& options);

struct ReplayOptions {
  std::string run;
  std::vector<std::string> plugins;  ///< where plug-ins of the run are now
  unsigned workers = 1;
  bool json = false;
};
int replay(const ReplayOptions& options);

/// Which plug-ins a scenario or a run file may name without --plugin: the list in the user's
/// configuration.
struct TrustOptions {
  std::vector<std::string> add, remove;  ///< shared libraries
  bool list = false;
};
int trust(const TrustOptions& options);
/// What that list permits; it is read when it is first asked.
[[nodiscard]] scenario::PluginPermission trusted();

/// Writes the folder `name` with a behavior, its test, a scenario and a CMake file.
struct NewOptions {
  std::string name;
};
int new_behavior(const NewOptions& options);

/// "eyrie 0.2.0 (gcc 12.2.0, Release)"
[[nodiscard]] std::string version_text();

}  // namespace eyrie::app
