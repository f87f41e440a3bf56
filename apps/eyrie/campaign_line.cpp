// SPDX-License-Identifier: MIT
#include "line.hpp"

namespace eyrie::app {
namespace {

void add_flights(CLI::App* app, FlightsOptions& o) {
  app->add_flag("--resume", o.resume, "go on where it ended, or was killed");
  add_workers(app, o.workers);
  add_plugins(app, o.plugins, kPluginHelp);
  add_includes(app, o.includes);
}
void add_results(CLI::App* app, ResultsOptions& o) {
  app->add_option("folder", o.folder, "the folder of a campaign")->required();
  add_workers(app, o.workers);
  add_plugins(app, o.plugins, kPluginHelp);
}

}  // namespace

void add_campaign(CLI::App& app, Chosen& chosen) {
  CLI::App* campaign = app.add_subcommand(
      "campaign", "Fly a scenario many times, as a campaign file says, and keep what came of it");
  CampaignOptions& o = options_of(campaign, app::campaign, chosen);
  campaign->add_option("file", o.file, "a campaign file: docs/campaigns.md")->required();
  campaign->add_option("--out", o.out, "folder for the results (default: campaigns/<name>)");
  add_flights(campaign, o);
  auto* part = campaign->add_option("--part", o.part, "fly the third of 16 parts: 3/16");
  campaign->add_flag("--join", o.join, "put all parts together")->excludes(part);
  campaign->add_flag("--json", o.json, "a line for each replicate, and one for the end");
}

void add_report(CLI::App& app, Chosen& chosen) {
  CLI::App* report = app.add_subcommand("report", "What a campaign found: tables, and a page");
  CampaignReportOptions& o = options_of(report, campaign_report, chosen);
  add_results(report, o);
  auto* out = report->add_option("--out", o.out, "the page (default: report.html in the folder)");
  report->add_flag("--force", o.force, "replace the file given by --out")->needs(out);
  report->add_option("--of", o.of, "a measure: compare each cell with every other, by it alone");
  report->add_option("--ways", o.ways, "replicates of each cell whose ways are drawn: flown again")
      ->transform(number(0, 1000));
  report->add_flag("--parquet", o.parquet, "results.parquet, too, by DuckDB's library");
}

void add_query(CLI::App& app, Chosen& chosen) {
  CLI::App* query = app.add_subcommand(
      "query", "Ask the results of a campaign in SQL: docs/campaigns.md has the tables");
  QueryOptions& o = options_of(query, app::query, chosen);
  add_results(query, o);
  query->add_option("sql", o.sql, "a SELECT; the answer is CSV");
  auto* decisions = query->add_option(
      "--decisions", o.decisions,
      "first add what the lost decided in their last '10 s': they are flown again");
  for (const char* of_flights : {"--workers", "--plugin"})
    query->get_option(of_flights)->needs(decisions);
}

void add_optimize(CLI::App& app, Chosen& chosen) {
  CLI::App* optimize = app.add_subcommand(
      "optimize", "Search votes and parameters for those with which a measure is best");
  FlightsOptions& o = options_of(optimize, app::optimize, chosen);
  optimize->add_option("file", o.file, "a search: docs/campaigns.md")->required();
  optimize->add_option("--out", o.out, "folder for what is found (default: searches/<name>)");
  add_flights(optimize, o);
  optimize->add_flag("--json", o.json, "a line for each generation, and one for the end");
}

}  // namespace eyrie::app
