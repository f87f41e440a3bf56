// SPDX-License-Identifier: MIT
/// \file  The command line. CLI11 lives in this file alone: it is slow to compile.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include "command.hpp"
#include "commands.hpp"
#include "locate.hpp"

namespace {

using namespace eyrie::app;

/// What the user asked for, once the line is parsed.
struct Commands {
  FlyOptions fly;
  ReplayOptions replay;
  ExplainOptions explain;
  WhatIfOptions what_if;
  DebriefOptions debrief;
  ExportOptions exported;
  std::string left, right;
  std::vector<std::string> files, plugins;
  TrustOptions trust;
  std::string name;
  bool markdown = false, json_schema = false;
};

/// Whole numbers from `least` to `most`. CLI11 takes "-1" for the largest number of all, and its
/// own ranges have other words from version to version.
auto whole_number(std::uint64_t least = 0,
                  std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  return [=](const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = failed == std::errc{} && end == text.data() + text.size() && value >= least &&
                      value <= most;
    return good ? std::string{}
                : "must be a whole number from " + std::to_string(least) + " to " +
                      std::to_string(most);
  };
}

void add_plugins(CLI::App* app, std::vector<std::string>& plugins, const char* help) {
  app->add_option("--plugin", plugins, help)->allow_extra_args(false);
}
constexpr const char* kPluginHelp = "a shared library with more behaviors, arbiters and models";
constexpr const char* kRunPluginHelp = "a plug-in of the run, which may be opened, where it is now";

void add_fly(CLI::App& app, Commands& c) {
  CLI::App* fly = app.add_subcommand("fly", "Fly a scenario and write what happened");
  fly->add_option("scenario", c.fly.scenario, "a file, or the name of one in scenarios/")
      ->default_str("sweep");
  fly->add_option("--seed", c.fly.seed, "seed of the draws (default: the scenario's)")
      ->check(whole_number());
  fly->add_option("--set", c.fly.sets, "override: path.in.the.file=value")->allow_extra_args(false);
  add_plugins(fly, c.fly.plugins, kPluginHelp);
  fly->add_option("--out", c.fly.out, "folder for the output (default: runs/<name>-<seed>)");
  fly->add_option("--until", c.fly.until, "stop at this simulated time, such as '10 min'");
  fly->add_option("--workers", c.fly.workers, "threads that share the step; never the result")
      ->check(whole_number(1, 256));
  fly->add_option("--paranoid", c.fly.paranoid,
                  "make every step twice, with this many workers the second time, and compare")
      ->expected(0, 1)
      ->default_str("2")
      ->check(whole_number(1, 256));
  fly->add_option("--realtime", c.fly.realtime, "pace by the clock, times this factor")
      ->expected(0, 1)
      ->default_str("1")
      ->check(CLI::PositiveNumber);
  fly->add_flag("--force", c.fly.force, "replace the folder given by --out");
  fly->add_flag("--quiet", c.fly.quiet, "no story, only how it ended");
  fly->add_flag("!--no-debrief", c.fly.debrief, "do not write the page debrief.html");
  fly->add_flag("--json", c.fly.json, "one JSON object on standard output instead of words");
}

void add_explain(CLI::App& app, Commands& c) {
  CLI::App* explain =
      app.add_subcommand("explain", "Why an agent of a recorded run did what it did");
  ExplainOptions& o = c.explain;
  explain->add_option("run", o.run, "a run folder or its run file")->required();
  explain->add_option("--player", o.player, "who")->required();
  auto* at =
      explain->add_option("--at", o.at, "the decision at this time: 312.4, '5 min' or 5:12.4");
  auto* from =
      explain->add_option("--from", o.from, "every decision from this time on")->excludes(at);
  auto* to = explain->add_option("--to", o.to, "and up to this one")->excludes(at);
  auto* changes = explain->add_flag(
      "--changes", o.changes, "whenever somebody else in the tree leads, and why (the default)");
  changes->excludes(at);
  explain->add_option("--event", o.event, "the decisions at events with this word, such as break")
      ->excludes(at)
      ->excludes(from)
      ->excludes(to)
      ->excludes(changes);
  auto* csv = explain->add_flag("--csv", o.csv, "a row for each field that a node proposed");
  csv->excludes(changes);
  explain->add_flag("--json", o.json, "for tools")->excludes(csv);
  add_plugins(explain, o.plugins, kRunPluginHelp);
}

void add_what_if(CLI::App& app, Commands& c) {
  CLI::App* what_if = app.add_subcommand(
      "whatif",
      "What an agent of a recorded run would have decided with other trees or parameters");
  WhatIfOptions& o = c.what_if;
  what_if->add_option("run", o.run, "a run folder or its run file")->required();
  what_if->add_option("--player", o.player, "who")->required();
  what_if
      ->add_option("--set", o.sets,
                   "the change: a node of the tree, root/bvr=fusion or root/bvr/pursue.vote=70, or "
                   "as for fly, trees.bvr.per_field.pursue.vote=70")
      ->allow_extra_args(false)
      ->required();
  what_if->add_option("--at", o.at, "from this time on: 312.4, '5 min' or 5:12.4");
  what_if->add_flag("--branch", o.branch,
                    "fly on from the first difference and compare how it ends");
  what_if->add_option("--seeds", o.seeds, "fly seeds 1 to this one both ways and compare")
      ->check(whole_number(1, 100000));
  what_if->add_flag("--json", o.json, "for tools");
  add_plugins(what_if, o.plugins, kRunPluginHelp);
}

void add_debrief(CLI::App& app, Commands& c) {
  CLI::App* debrief = app.add_subcommand(
      "debrief", "A recorded run, or two, as a page in which every decision can be questioned");
  DebriefOptions& o = c.debrief;
  debrief->add_option("runs", o.runs, "a run folder or its run file; two of them to compare")
      ->required()
      ->expected(1, 2);
  debrief->add_option("--out", o.out, "the file (default: debrief.html beside the first run)");
  debrief->add_flag("--force", o.force, "replace the file given by --out");
  add_plugins(debrief, o.plugins, kRunPluginHelp);
}

ExportFormat format_named(const std::string& word) {
  if (word == "czml")
    return ExportFormat::czml;
  if (word == "geojson")
    return ExportFormat::geojson;
  if (word == "decisions")
    return ExportFormat::decisions;
  throw CLI::ValidationError("--to", "must be czml, geojson or decisions, not '" + word + "'");
}

void add_export(CLI::App& app, Commands& c) {
  CLI::App* exported = app.add_subcommand("export", "A recorded run for other tools");
  ExportOptions& o = c.exported;
  exported->add_option("run", o.run, "a run folder or its run file")->required();
  exported
      ->add_option_function<std::string>(
          "--to", [&o](const std::string& word) { o.format = format_named(word); },
          "czml (Cesium), geojson (maps), or decisions (CSV: every field that every node of every "
          "player proposed)")
      ->required();
  exported->add_option("--player", o.player, "only this player's decisions");
  exported->add_option("--out", o.out,
                       "the file (default: run.czml, run.geojson or decisions.csv beside the run)");
  exported->add_flag("--force", o.force, "replace the file given by --out");
  add_plugins(exported, o.plugins, kRunPluginHelp);
}

void add_trust(CLI::App& app, Commands& c) {
  CLI::App* trust = app.add_subcommand(
      "trust", "Plug-ins that scenarios and run files may name without --plugin");
  auto* add = trust->add_option("plugins", c.trust.add,
                                "shared libraries to trust, each as long as it stays as it is");
  auto* remove = trust->add_option("--remove", c.trust.remove, "trust these no longer");
  auto* list = trust->add_flag("--list", c.trust.list, "show which are trusted");
  add->excludes(remove)->excludes(list);
  remove->excludes(list);
  trust->require_option(1);
}

int run(int argc, char** argv) {
  CLI::App app{"Eyrie: autonomous agents in the air, by the Unified Behavior Framework"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  Commands c;
  add_fly(app, c);
  add_explain(app, c);
  add_what_if(app, c);
  add_debrief(app, c);
  add_export(app, c);
  CLI::App* diff_cmd = app.add_subcommand("diff", "Where two recorded runs part");
  diff_cmd->add_option("left", c.left, "a run folder or its run file")->required();
  diff_cmd->add_option("right", c.right, "another one")->required();
  diff_cmd->add_flag("--json", c.replay.json, "for tools");
  add_plugins(diff_cmd, c.plugins, kRunPluginHelp);
  CLI::App* validate_cmd = app.add_subcommand("validate", "Check scenario files");
  validate_cmd->add_option("files", c.files, "scenario files")->required();
  add_plugins(validate_cmd, c.plugins, kPluginHelp);
  CLI::App* catalog_cmd =
      app.add_subcommand("catalog", "Everything a scenario may name, with its parameters");
  auto* schema = catalog_cmd->add_flag("--json-schema", c.json_schema, "as a JSON schema");
  catalog_cmd->add_flag("--markdown", c.markdown, "as the reference page")->excludes(schema);
  add_plugins(catalog_cmd, c.plugins, kPluginHelp);
  CLI::App* replay_cmd = app.add_subcommand("replay", "Fly a recorded run again and compare");
  replay_cmd->add_option("run", c.replay.run, "a run folder or its run file")->required();
  replay_cmd->add_option("--workers", c.replay.workers, "threads that share the step")
      ->check(whole_number(1, 256));
  replay_cmd->add_flag("--json", c.replay.json, "one JSON object instead of words");
  add_plugins(replay_cmd, c.replay.plugins, kRunPluginHelp);
  add_trust(app, c);
  CLI::App* new_cmd = app.add_subcommand("new", "Begin something of your own");
  new_cmd->require_subcommand(1)
      ->add_subcommand("behavior", "A plug-in with one behavior, its test and a scenario")
      ->add_option("name", c.name, "what trees call it; also the name of the folder")
      ->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return code == 0 ? 0 : 2;
  }
  take_launch_zones();
  if (app.got_subcommand("fly"))
    return fly(c.fly);
  if (app.got_subcommand("explain"))
    return explain(c.explain);
  if (app.got_subcommand("whatif"))
    return what_if(c.what_if);
  if (app.got_subcommand("debrief"))
    return debrief_page(c.debrief);
  if (app.got_subcommand("export"))
    return export_run(c.exported);
  if (app.got_subcommand(diff_cmd))
    return diff(c.left, c.right, c.replay.json, c.plugins);
  if (app.got_subcommand(validate_cmd))
    return validate(c.files, c.plugins);
  if (app.got_subcommand(replay_cmd))
    return replay(c.replay);
  if (app.got_subcommand("trust"))
    return trust(c.trust);
  if (app.got_subcommand(new_cmd))
    return new_behavior(c.name);
  return catalog(c.json_schema ? CatalogFormat::json_schema
                 : c.markdown  ? CatalogFormat::markdown
                               : CatalogFormat::text,
                 c.plugins);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  return run_command([&] { return run(argc, argv); });
}
