// SPDX-License-Identifier: MIT
/// \file  The command line. CLI11 lives here and in the other files of its executable alone: it is
/// slow to compile.
#include "arguments.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "line.hpp"
#include "locate.hpp"
#include "say.hpp"
#include "scenario/end_guard.hpp"

namespace {

using namespace eyrie;
using namespace eyrie::app;

void add_run_plugins(CLI::App* app, std::vector<std::string>& plugins) {
  add_plugins(app, plugins, "a plug-in of the run, which may be opened, where it is now");
}
template <class Options>
void add_run(CLI::App* app, Options& o) {
  app->add_option("run", o.run, "a run folder or its run file")->required();
  add_run_plugins(app, o.plugins);
}

void add_units(CLI::App* app) {
  static constexpr auto kSystems = enum_names<UnitSystem>();
  app->add_option_function<std::string>(
         "--units",
         [](const std::string& name) {
           write_units(enum_named<UnitSystem>(name).value_or(UnitSystem::us));
         },
         "of what is printed: us (ft, nmi, kt, lb) or metric (m, km, km/h, kg)")
      ->check(one_of({kSystems.begin(), kSystems.end()}));
}

/// What of a scenario is flown.
void add_variation(CLI::App* command, FlyOptions& o) {
  command->add_option("--seed", o.seed, "seed (default: the scenario's)")
      ->transform(CLI::Validator(whole_number(), ""));
  command->add_option("--set", o.sets, "override: path.in.the.file=value")->allow_extra_args(false);
}

/// Of who takes part in a flight, or watches it. One that is served goes by the clock anyhow.
void add_others(CLI::App* command, FlyOptions& o, bool served) {
  const std::string clock = served ? "" : "; by the clock, if --real-time says nothing else";
  const auto live = [&](const char* name, std::string& at, const char* port, auto check,
                        const std::string& help) {
    return command->add_option(name, at, help)->expected(0, 1)->default_str(port)->check(check);
  };
  auto* tacview =
      live("--tacview", o.tacview, "42674", endpoint,
           "let Tacview watch, here at this port, or at 0.0.0.0 or ADDRESS:PORT" + clock);
  command
      ->add_option("--tacview-password", o.tacview_password,
                   "a file whose first line Tacview has to know")
      ->needs(tacview);
  if (!served)  // viewers would wait with it
    command->add_flag("--tacview-wait", o.tacview_wait, "begin when Tacview has joined")
        ->needs(tacview);
  auto* dis = live("--dis", o.dis, "3000", datagram_endpoint,
                   "tell other simulations by DIS, here at this port, or at ADDRESS:PORT of a "
                   "machine, a network or a group" +
                       clock);
  const auto of_dis = [&](const char* name, std::string& into, const char* help) {
    return command->add_option(name, into, help)->needs(dis);
  };
  of_dis("--dis-station", o.dis_station, "exercise, site and application (default: 1.1.1)")
      ->check(station);
  of_dis("--dis-interface", o.dis_interface, "send from this own address")->check(own_ipv4);
  of_dis("--dis-threshold", o.dis_threshold,
         "how far others may be off before they are told (default: '1 m, 3 deg')");
  of_dis("--ours", o.ours,
         "sides, flights and aircraft that are flown here, such as blue or eagle,bogey2; the "
         "others are another program's, heard by --dis");
  command
      ->add_flag("--dis-obey", o.dis_obey, "start, freeze and stop when another simulation says so")
      ->needs(dis);
}

void add_fly(CLI::App& app, Chosen& chosen) {
  CLI::App* fly = app.add_subcommand("fly", "Fly a scenario and write what happened");
  FlyOptions& o = options_of(fly, app::fly, chosen);
  fly->add_option("scenario", o.scenario, "a file, or the name of one in scenarios/")
      ->default_str("sweep");
  add_variation(fly, o);
  auto* seeds = fly->add_option(
      "--seeds", o.seeds,
      "fly each of them, 1..500 or 500 for the same, on all cores, and say how they ended");
  add_plugins(fly, o.plugins, kPluginHelp);
  add_includes(fly, o.includes);
  auto* out =
      fly->add_option("--out", o.out, "folder for the output (default: runs/<name>-<seed>)");
  fly->add_option("--until", o.until, "stop at this simulated time, such as '10 min'");
  fly->add_option("--workers", o.workers,
                  "threads that share the step, or the seeds; never the result")
      ->transform(number(1, 256));
  fly->add_option("--paranoid", o.paranoid,
                  "make every step twice, with this many workers the second time, and compare")
      ->expected(0, 1)
      ->default_str("2")
      ->transform(number(1, 256));
  fly->add_option("--real-time", o.real_time,
                  "by the clock, at this rate: 0.1 to 100, or max, which waits for nothing")
      ->expected(0, 1)
      ->default_str("1")
      ->transform(CLI::Validator(rate, ""));
  add_others(fly, o, false);
  fly->add_flag("--force", o.force, "replace the folder given by --out")->needs(out);
  fly->add_flag("--quiet", o.quiet, "no story, only how it ended");
  fly->add_flag("!--no-debrief", o.debrief, "do not write the page debrief.html");
  auto* watch = fly->add_flag("--watch", o.watch,
                              "fly again whenever a file of the scenario changes, until ^C");
  seeds->excludes(watch);
  fly->add_flag("--json", o.json,
                "one JSON object on standard output instead of words; with --seeds one a line for "
                "each, and one for all");
  add_units(fly);
  for (const char* of_one : {"--seed", "--out", "--paranoid", "--real-time", "--tacview", "--dis",
                             "--force", "--quiet", "--no-debrief", "--units"})
    seeds->excludes(fly->get_option(of_one));
}

void add_explain(CLI::App& app, Chosen& chosen) {
  CLI::App* explain =
      app.add_subcommand("explain", "Why an agent of a recorded run did what it did");
  ExplainOptions& o = options_of(explain, app::explain, chosen);
  add_run(explain, o);
  auto* player = explain->add_option(
      "--player", o.player,
      "who; not given: the decisions on which the run turned, whoever made them");
  auto* at =
      explain->add_option("--at", o.at, "the decision at this time: 312.4, '5 min' or 5:12.4");
  auto* from =
      explain->add_option("--from", o.from, "every decision from this time on")->excludes(at);
  auto* to = explain->add_option("--to", o.to, "and up to this one")->excludes(at);
  auto* changes = explain->add_flag(
      "--changes", o.changes, "whenever somebody else in the tree leads, and why (the default)");
  changes->excludes(at);
  auto* event = explain->add_option("--event", o.event,
                                    "the decisions at events with this word, such as break");
  for (auto* other : {at, from, to, changes})
    event->excludes(other);
  auto* csv = explain->add_flag("--csv", o.csv, "a row for each field that a node proposed");
  csv->excludes(changes);
  explain->add_flag("--json", o.json, "for tools")->excludes(csv);
  add_units(explain);
  for (const char* of_player : {"--at", "--from", "--to", "--changes", "--event", "--csv"})
    explain->get_option(of_player)->needs(player);
}

void add_what_if(CLI::App& app, Chosen& chosen) {
  CLI::App* what_if = app.add_subcommand(
      "whatif",
      "What an agent of a recorded run would have decided with other trees or parameters");
  WhatIfOptions& o = options_of(what_if, app::what_if, chosen);
  add_run(what_if, o);
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
      ->transform(number(1, 100'000));
  what_if->add_flag("--json", o.json, "for tools");
  add_units(what_if);
}

void add_runs(CLI::App* command, std::vector<std::string>& runs) {
  command->add_option("runs", runs, "a run folder or its run file; two of them to compare")
      ->required()
      ->expected(1, 2);
}

void add_debrief(CLI::App& app, Chosen& chosen) {
  CLI::App* debrief = app.add_subcommand(
      "debrief", "A recorded run, or two, as a page in which every decision can be questioned");
  DebriefOptions& o = options_of(debrief, debrief_page, chosen);
  add_runs(debrief, o.runs);
  debrief->add_option("--out", o.out, "the file (default: beside the first run)");
  debrief->add_flag("--force", o.force, "replace the file that is there");
  debrief->add_flag("--columns", o.columns,
                    "put what was recorded into the page, not the engine that flies it again");
  add_run_plugins(debrief, o.plugins);
}

void add_serve(CLI::App& app, Chosen& chosen) {
  CLI::App* served = app.add_subcommand(
      "serve",
      "A mission, or the debrief page of a run, for browsers, which also choose and steer it");
  ServeOptions& o = options_of(served, serve, chosen);
  served
      ->add_option("what", o.what,
                   "a scenario, as for fly; or a run folder or its run file, or two of them "
                   "(default: the home page, to choose from)")
      ->expected(0, 2);
  served->add_option("--port", o.port, "0: any that is free")
      ->transform(number(0, 65'535))
      ->capture_default_str();
  served
      ->add_option("--address", o.address,
                   "of this machine, or 0.0.0.0 for all that it has; others than this machine then "
                   "need the address with the token that is printed")
      ->check(address)
      ->capture_default_str();
  add_run_plugins(served, o.plugins);
  FlyOptions& flight = o.flight;
  add_variation(served, flight);
  served
      ->add_option("--rate", flight.real_time,
                   "seconds of the mission in one of the clock: 0.1 to 100, or max (default: 1)")
      ->transform(CLI::Validator(rate, ""));
  served->add_flag("--paused", o.paused, "begin when somebody says so");
  served->add_option("--workers", flight.workers, "threads that share the step; never the result")
      ->transform(number(1, 256));
  add_others(served, flight, true);
}

void add_playground(CLI::App& app, Chosen& chosen) {
  CLI::App* playground = app.add_subcommand(
      "playground", "A folder of files in which a browser edits, flies and debriefs scenarios");
  PlaygroundOptions& o = options_of(playground, app::playground, chosen);
  playground->add_option("--out", o.out, "the folder")->capture_default_str();
  playground->add_flag("--force", o.force, "replace the folder");
}

void add_zones(CLI::App& app, Chosen& chosen) {
  CLI::App* zones = app.add_subcommand(
      "zones", "The launch zones of missiles: flown on all cores and kept in data/zones, or drawn");
  ZonesOptions& o = options_of(zones, app::zones, chosen);
  zones->add_option("missiles", o.missiles, "names in data/missiles (default: all)");
  auto* check =
      zones->add_flag("--check", o.check, "write nothing, and exit with 1 if one is stale");
  auto* draw = zones->add_flag("--draw", o.draw, "draw each over the aspect, as NAME.svg");
  draw->excludes(check);
  zones->add_flag("--force", o.force, "replace drawings")->needs(draw);
  for (auto* of_drawing :
       {zones->add_option("--out", o.out, "the folder of the drawings"),
        zones->add_option("--altitude", o.altitude, "of both in a drawing: 300 m to 15 km"),
        zones->add_option("--speed", o.speed, "of both in a drawing: 100 to 550 m/s")})
    of_drawing->needs(draw)->capture_default_str();
}

void add_export(CLI::App& app, Chosen& chosen) {
  static constexpr auto kFormats = enum_names<ExportFormat>();
  CLI::App* exported = app.add_subcommand("export", "A recorded run for other tools");
  ExportOptions& o = options_of(exported, export_run, chosen);
  add_run(exported, o);
  exported
      ->add_option_function<std::string>(
          "--to",
          [&o](const std::string& name) {
            o.format = enum_named<ExportFormat>(name).value_or(o.format);
          },
          "sqlite (everything in one database), decisions (CSV: one a row), answers (CSV: those of "
          "every node), czml (Cesium), geojson (maps), or pcap (DIS, for Wireshark)")
      ->required()
      ->check(one_of({kFormats.begin(), kFormats.end()}));
  exported->add_option("--player", o.player, "only this player's decisions");
  exported->add_option("--every", o.every,
                       "at most one decision of a player in each so much time of the run: '1 s'");
  exported->add_flag("--changes-only", o.changes_only,
                     "only decisions with another leader, tree or order than the one before");
  exported->add_option("--out", o.out,
                       "the file (default: run.sqlite, decisions.csv.gz ... beside the run; a name "
                       "without .gz gives plain CSV)");
  exported->add_flag("--force", o.force, "replace the file that is there");
}

void add_trust(CLI::App& app, Chosen& chosen) {
  CLI::App* trust = app.add_subcommand(
      "trust", "Plug-ins that scenarios and run files may name without --plugin");
  TrustOptions& o = options_of(trust, app::trust, chosen);
  auto* add = trust->add_option("plugins", o.add,
                                "shared libraries to trust, each as long as it stays as it is");
  auto* remove = trust->add_option("--remove", o.remove, "trust these no longer");
  auto* list = trust->add_flag("--list", o.list, "show which are trusted");
  add->excludes(remove)->excludes(list);
  remove->excludes(list);
  trust->require_option(1);
}

void add_diff(CLI::App& app, Chosen& chosen) {
  CLI::App* diff = app.add_subcommand("diff", "Where two recorded runs part");
  DiffOptions& o = options_of(diff, app::diff, chosen);
  o.runs.resize(2);
  diff->add_option("left", o.runs[0], "a run folder or its run file")->required();
  diff->add_option("right", o.runs[1], "a second run, to compare with")->required();
  diff->add_flag("--json", o.json, "for tools");
  add_units(diff);
  add_run_plugins(diff, o.plugins);
}

void add_validate(CLI::App& app, Chosen& chosen) {
  CLI::App* validate = app.add_subcommand("validate", "Check scenarios and packages");
  ValidateOptions& o = options_of(validate, app::validate, chosen);
  validate->add_option("files", o.files, "scenario files, or what they include")->required();
  validate->add_flag("--print", o.print,
                     "print each as one file, with what it extends and includes");
  add_plugins(validate, o.plugins, kPluginHelp);
  add_includes(validate, o.includes);
}

void add_catalog(CLI::App& app, Chosen& chosen) {
  CLI::App* catalog =
      app.add_subcommand("catalog", "Everything a scenario may name, with its parameters");
  CatalogOptions& o = options_of(catalog, app::catalog, chosen);
  auto* node = catalog->add_option("node", o.node, "one kind of node, with its parameters");
  auto* schema = catalog->add_flag("--json-schema", o.json_schema, "as a JSON schema");
  catalog->add_flag("--markdown", o.markdown, "as the reference page")->excludes(schema);
  schema->excludes(node);
  catalog->get_option("--markdown")->excludes(node);
  auto* events = catalog->add_flag("--events", o.events, "the kinds of events instead, as a page");
  auto* tables = catalog->add_flag("--tables", o.tables, "the tables of run.sqlite instead");
  events->excludes(node)->excludes(schema)->excludes(tables);
  tables->excludes(node)->excludes(schema);
  add_plugins(catalog, o.plugins, kPluginHelp);
  for (auto* of_eyrie : {events, tables})
    of_eyrie->excludes(catalog->get_option("--plugin"));
}

void add_replay(CLI::App& app, Chosen& chosen) {
  CLI::App* replay = app.add_subcommand("replay", "Fly a recorded run again and compare");
  ReplayOptions& o = options_of(replay, app::replay, chosen);
  add_run(replay, o);
  replay->add_option("--workers", o.workers, "threads that share the step")
      ->transform(number(1, 256));
  replay->add_flag("--json", o.json, "one JSON object instead of words");
}

void add_new(CLI::App& app, Chosen& chosen) {
  CLI::App* begin = app.add_subcommand("new", "Begin something of your own");
  CLI::App* behavior = begin->require_subcommand(1)->add_subcommand(
      "behavior", "A plug-in with one behavior, its test and a scenario");
  behavior
      ->add_option("name", options_of(behavior, new_behavior, chosen).name,
                   "what trees call it; also the name of the folder")
      ->required();
}

int run(int argc, char** argv) {
  CLI::App app{"Eyrie: autonomous agents in the air, by the Unified Behavior Framework", "eyrie"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  Chosen chosen;
  for (const auto add :
       {add_fly, add_campaign, add_report, add_query, add_optimize, add_explain, add_what_if,
        add_debrief, add_serve, add_playground, add_export, add_diff, add_validate, add_zones,
        add_catalog, add_replay, add_trust, add_new, add_completion})
    add(app, chosen);
  set_help(app);
  refuse_flag_values(app);
  keep_zones();
  if (argc > 2 && std::string_view(argv[1]) == "completion" &&
      std::string_view(argv[2]) == "--for") {
    say("{}", Composed{completions(app, std::span(argv, argv + argc).subspan(3))});
    return 0;
  }
  std::vector<char*> typed(argv, argv + argc);
  char help[] = "--help";
  bool asks = false;
  for (; typed.size() > 1 && std::string_view(typed[1]) == "help"; asks = true)
    typed.erase(typed.begin() + 1);
  if (asks)  // "help fly" means "fly --help"
    typed.insert(typed.begin() + std::min<std::ptrdiff_t>(std::ssize(typed), 2), help);
  const std::span<char*> words(typed);
  try {
    if (const std::string problem = asks ? word_behind_help(app, words) : empty_text(words);
        !problem.empty())
      return say_wrong(app, words, problem);
    app.parse(static_cast<int>(typed.size()), typed.data());
  } catch (const CLI::ParseError& e) {
    return say_mistake(app, e, words);
  }
  return chosen();
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  const eyrie::scenario::EndGuard guard(
      1, [](const std::string& done) { complain("eyrie: {} and ended the program\n", done); });
  return run_command([&] { return run(argc, argv); });
}
