// SPDX-License-Identifier: MIT
/// \file  report and query: what the results of a campaign say, on the terminal, as a page, and in
/// SQL.
#include <fmt/ranges.h>

#include "campaign/again.hpp"
#include "campaign/store.hpp"
#include "campaign/summary.hpp"
#include "campaign_page.hpp"
#include "campaigns.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/units.hpp"
#include "disk/output.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

using namespace campaign;
using Json = nlohmann::ordered_json;
/// [cell, replicate, seed, outcome, time_s, hash, values ...], as many of each cell as a page can
/// hold.
Json replicates_json(Database& database, std::size_t cells) {
  constexpr std::size_t kMost = 50'000, kFew = 20;
  Statement all =
      database.prepare("SELECT * FROM replicates WHERE replicate < ? ORDER BY cell, replicate");
  all.with(std::max(kFew, kMost / std::max<std::size_t>(1, cells)));
  Json rows = Json::array();
  while (all.step()) {
    Json& row = rows.emplace_back(Json{all.integer(0), all.integer(1), all.integer(2), all.text(3),
                                       number_or_null(all.number(4)), all.text(6)});
    for (int i = kFirstColumn; i < all.columns(); ++i)
      row.push_back(number_or_null(all.number(i)));
  }
  return rows;
}

/// [cell, replicate, player, side, lost, hundredths of a nautical mile east, north ...]
Json ways_json(const std::vector<Way>& ways) {
  constexpr double kUnit = 18.52;  // m
  Json all = Json::array();
  for (const Way& way : ways) {
    Json& one = all.emplace_back(Json{way.cell, way.replicate, way.player, way.side, way.lost});
    for (const auto& [north, east] : way.places) {
      one.push_back(std::lround(east / kUnit));
      one.push_back(std::lround(north / kUnit));
    }
  }
  return all;
}

/// Says how far something has come, once it has begun; false when it was interrupted.
std::function<bool(std::uint64_t, std::uint64_t)> telling(std::optional<Progress>& progress) {
  return [&](std::uint64_t done, std::uint64_t all) {
    if (!progress)
      progress.emplace("replicates", all);
    progress->at(done);
    return !interrupted();
  };
}

/// Those of the first replicates, or none and why.
std::vector<Way> ways_to_draw(const CampaignReportOptions& options, const Summary& summary) {
  constexpr std::uint64_t kFlights = 60, kOfCell = 5;  // seconds, not minutes
  const std::uint64_t cells = std::max<std::size_t>(summary.cells.size(), 1);
  const std::uint64_t count = options.ways.value_or(std::min(kOfCell, kFlights / cells));
  if (count == 0)
    return {};
  std::optional<Progress> progress;
  try {
    return ways_flown(options.folder, count, options.workers ? options.workers : cores(),
                      options.plugins, telling(progress));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    if (options.ways)
      throw;
    progress.reset();
    complain("eyrie: the page shows no ways flown: {}\n", words_for(e));
    return {};
  }
}

/// What the page shows. No text in it ends the element that holds it.
std::string page_data(const std::string& folder, const Summary& summary,
                      const std::vector<Comparison>& comparisons, const std::vector<Way>& ways,
                      const std::string& no_debrief) {
  Json json{{"name", summary.name},   {"scenario", summary.scenario}, {"hash", summary.hash},
            {"ended", summary.ended}, {"factors", summary.factors},   {"paired", summary.paired},
            {"debrief", no_debrief}};  // why none can be flown
  for (const char* list : {"measures", "cells", "comparisons", "effects", "interactions", "faults"})
    json[list] = Json::array();
  for (std::size_t i = 0; i < summary.measures.size(); ++i) {
    const Measure& m = summary.measures[i];
    json["measures"].push_back({{"name", m.name},
                                {"unit", summary.units[i]},
                                {"kind", enum_name(m.kind)},
                                {"column", m.column},
                                {"per", m.per}});
  }
  for (const auto& cell : summary.cells) {
    Json estimates = Json::array();
    for (const Estimate& e : cell.estimates)
      estimates.push_back(estimate_json(e));
    json["cells"].push_back({{"values", cell.values},
                             {"command", cell.command},
                             {"replicates", cell.replicates},
                             {"faults", cell.faults},
                             {"estimates", estimates}});
  }
  for (const Comparison& c : comparisons)
    json["comparisons"].push_back({{"cell", c.cell},
                                   {"than", c.than},
                                   {"measure", c.measure},
                                   {"n", c.n},
                                   {"n_than", summary.paired ? c.n : c.n_than},
                                   {"value", c.value},
                                   {"interval", interval_json(c.interval)},
                                   {"p", c.p},
                                   {"holm", c.holm}});
  for (const Effect& e : effects(summary)) {
    Json levels = Json::array();
    for (const auto& level : e.levels)
      levels.push_back({{"name", level.name}, {"mean", level.mean}});
    json["effects"].push_back(
        {{"measure", e.measure}, {"factor", e.factor}, {"part", e.part}, {"levels", levels}});
  }
  for (const Interaction& i : interactions(summary))
    json["interactions"].push_back(
        {{"measure", i.measure}, {"one", i.one}, {"other", i.other}, {"part", i.part}});
  for (const auto& fault : summary.faults)
    json["faults"].push_back({{"cell", fault.cell},
                              {"seed", fault.seed},
                              {"what", fault.what},
                              {"command", fault.command}});
  Database database = open_results(folder);
  json["replicates"] = replicates_json(database, summary.cells.size());
  json["ways"] = ways_json(ways);
  std::string text = record::json_text(json), safe;
  for (const char c : text)
    safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

/// Whether nobody waits for an answer any more.
int unheard(void*) {
  return interrupted() || lost_output() != 0 ? 1 : 0;
}

std::optional<std::size_t> measure_named(const std::string& name, const Summary& summary) {
  if (name.empty())
    return {};
  const auto names = listed(summary.measures, &Measure::name);
  const auto found = std::ranges::find(names, name);
  if (const std::string hint = did_you_mean(name, names); found == names.end())
    refuse("--of: there is no measure {}{}", quote(name),
           hint.empty() ? fmt::format(", only {}", fmt::join(names, ", ")) : hint);
  return static_cast<std::size_t>(found - names.begin());
}

Statement prepared(Database& database, const std::string& sql) {
  try {
    return database.prepare(sql);
  } catch (const disk::Refused& refused) {
    constexpr std::string_view kNoTable = "no such table: ";
    const std::string_view words = refused.what();
    const std::size_t at = words.find(kNoTable);
    const std::string_view name = at == words.npos ? "" : words.substr(at + kNoTable.size());
    for (const std::string_view table : {"losses", "decisions"})
      if (name.substr(0, name.find_first_of(" ,;")) == table)
        refuse("eyrie: there is no table '{}' yet; --decisions '10 s' adds it", table);
    throw;
  }
}

}  // namespace

int campaign_report(const CampaignReportOptions& options) {
  WriteParquet parquet;
  if (options.parquet)
    parquet = open_parquet(duckdb_library());
  check_results(options.folder);
  const Summary summary = read_summary(options.folder);
  listen_for_interrupts();
  const std::string file =
      options.out.empty() ? fmt::format("{}/report.html", options.folder) : options.out;
  const auto in_folder = [&](std::string_view name) {
    return fmt::format("{}/{}", options.folder, name);
  };
  std::vector<std::string> others{in_folder(kTableName), in_folder(kParquetName)};
  for (const char* journal : {"", "-wal", "-shm", "-journal"})
    others.push_back(in_folder(std::string(kStoreName) + journal));
  demand_other_file(file, others);
  disk::OutputFile out(file, options.out.empty() || options.force);  // before it flies
  std::optional<disk::OutputFile> columns;
  if (parquet)
    columns.emplace(in_folder(kParquetName), true);
  if (options.out.empty())
    static_cast<void>(table_in(options.folder));
  const auto comparisons = compare(options.folder, summary, measure_named(options.of, summary));
  print_cells(summary);
  if (summary.hash.empty())
    say("not finished: it is being flown, or its program was killed\n");
  else if (!summary.ended.empty() && summary.ended != "complete")
    say("not the whole campaign: {}\n", summary.ended);
  print_comparisons(summary, comparisons, options.of.empty() ? 20 : comparisons.size());
  print_effects(summary, effects(summary), interactions(summary));
  say("\n");
  const std::vector<Way> ways = ways_to_draw(options, summary);
  const CampaignDebrief debrief = campaign_debrief(options.folder, options.plugins);
  std::string_view page = kCampaignPage;
  for (const auto& [here, text] :
       {std::pair{"@DATA@", page_data(options.folder, summary, comparisons, ways, debrief.problem)},
        {"@DEBRIEF@", debrief.page}}) {
    const std::size_t at = page.find(here);
    out.sink().write(page.substr(0, at));
    out.sink().write(text);
    page.remove_prefix(at + std::string_view(here).size());
  }
  out.sink().write(page);
  finish(out);
  Database database = open_results(options.folder);
  if (options.out.empty())  // a page elsewhere leaves the folder as it is: it may be read-only
    write_table(database, options.folder);
  if (parquet)
    parquet(database, *columns);
  return 0;
}

int query(const QueryOptions& options) {
  if (options.sql.empty() && options.decisions.empty())
    refuse("eyrie: query needs SQL, or --decisions");
  check_results(options.folder);
  if (!options.decisions.empty()) {
    const double window = period_named("--decisions", options.decisions);
    listen_for_interrupts();
    std::optional<Progress> progress;
    add_last_decisions(options.folder, window, options.workers ? options.workers : cores(),
                       options.plugins, telling(progress));
    if (interrupted()) {
      complain("eyrie: interrupted; the same command goes on, and then asks\n");
      return 0;
    }
  }
  if (options.sql.empty())
    return 0;
  Database database = open_results(options.folder);
  Statement asked = prepared(database, options.sql);
  if (asked.columns() == 0 || !asked.reads_only())
    refuse("eyrie: query reads, and {} gives no rows or writes", quote(options.sql));
  if (const auto looked = looked_at(database); looked && looked->replicates < looked->of)
    complain("eyrie: losses and decisions{} are there of {} of {}; --decisions adds the others\n",
             looked->replicates ? fmt::format(" of the last {} s", looked->window) : "",
             looked->replicates, counted(looked->of, "replicate"));
  database.stop_if(unheard);
  write_csv(asked, [](const std::string& line) { say("{}", Composed{line}); });
  return 0;
}

}  // namespace eyrie::app
