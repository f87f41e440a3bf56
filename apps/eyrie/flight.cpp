// SPDX-License-Identifier: MIT
#include "flight.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "core/text.hpp"
#include "debrief/what_if.hpp"
#include "disk/file_system.hpp"
#include "locate.hpp"
#include "say.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/path.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

/// The folder of the run: the one that was asked for, or the next free one in runs/.
disk::FolderWish folder_of(const FlyOptions& options, const scenario::Scenario& scenario,
                           std::uint64_t seed) {
  const bool numbered = options.out.empty();
  return {.path = numbered ? fmt::format("runs/{}-{}", file_name_from(scenario.spec.name), seed)
                           : options.out,
          .names = record::kRunFolderNames,
          .sign = record::kRunFileName,
          .replace = options.force,
          .numbered = numbered};
}

/// What stands beside the run file. A run is kept without what could not be written.
struct Beside {
  const disk::OutputFolder& folder;
  std::string written = record::kRunFileName;
  bool failed = false;

  void close(disk::Sink& sink, const char* name) {
    if (sink.close()) {
      written += fmt::format(", {}", name);
    } else {
      folder.drop(name);
      lost(sink.error() + "; the run is kept without it");
    }
  }
  void page(const PageWritten& page) {
    if (page.written)
      written += fmt::format(", {}", record::kPageName);
    if (!page.problem.empty())
      complain("eyrie: {}\n", page.problem);
    failed |= page.failed;
  }
  void lost(const std::string& words) {
    complain("eyrie: {}\n", words);
    failed = true;
  }
};

/// The last would win, and the others do nothing; options win over every --set.
void refuse_what_is_set_twice(const FlyOptions& options) {
  std::vector<std::string> paths = options.sets, setters;
  for (const std::string& set : options.sets)
    setters.push_back("--set " + quote(set));
  const auto add = [&](bool given, std::string_view path, std::string_view option) {
    if (given) {
      paths.emplace_back(path);
      setters.emplace_back(option);
    }
  };
  add(options.seed.has_value(), "seed", "--seed");
  add(!options.seeds.empty(), "seed", "--seeds");
  add(!options.until.empty(), "until", "--until");
  add(!options.ours.empty(), "ours", "--ours");
  for (const auto& [first, again] : scenario::set_twice(paths))
    refuse("eyrie: {}: {} sets {}, too", Composed{setters[first]}, Composed{setters[again]},
           quote(paths[first].substr(0, scenario::path_size(paths[first]))));
}

/// "blue, viper1" as a list in YAML, whatever the names hold.
std::string list_of(std::string_view names) {
  nlohmann::json list;
  for (std::size_t at = 0, end = 0; at <= names.size(); at = end + 1) {
    end = std::min(names.find(',', at), names.size());
    list.push_back(trimmed(names.substr(at, end - at)));
  }
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void demand_place_for_runs() {
  static_cast<void>(disk::OutputFolder({.path = "runs/latest", .numbered = true}));
}

std::vector<std::string> overrides(const FlyOptions& options) {
  refuse_what_is_set_twice(options);
  std::vector<std::string> sets = options.sets;
  if (!options.ours.empty())
    sets.push_back("ours=" + list_of(options.ours));
  return sets;
}

std::shared_ptr<const scenario::Scenario> load_scenario(const FlyOptions& options) {
  const std::vector<std::string> sets = overrides(options);
  try {
    return load_scenario(options.scenario, sets, options.plugins, options.includes);
  } catch (const ConfigError& error) {
    if (options.ours.empty())
      throw;
    Diagnostics named;  // as it was typed
    for (Diagnostic d : error.diagnostics().sorted()) {
      if (d.where.file == FileName("--set " + sets.back()))
        d.where = {"--ours " + options.ours, 0, 0};
      named.error(d.where, d.message);
    }
    throw ConfigError(named);
  }
}

Flight::Flight(const FlyOptions& options, const std::shared_ptr<const scenario::Scenario>& scenario,
               std::optional<double> until)
    : options_(options),
      scenario_(scenario),
      seed_(options.seed.value_or(scenario->spec.seed)),
      folder_(folder_of(options, *scenario, seed_)),
      report_(*scenario, !options.json && colors()),
      run_(folder_.file(record::kRunFileName)),
      events_(folder_.file(record::kEventsName)),
      flight_(folder_.file(record::kFlightName)),
      tally_(*scenario),
      ends_(*scenario),
      csv_(*scenario, events_),
      tacview_(host_tacview(options, record::acmi_name(scenario->spec.name))),
      acmi_(
          *scenario,
          [this](std::string_view lines) {
            flight_.write(lines);
            if (tacview_)
              tacview_->send(lines, tacview_->wanted() ? acmi_.whole() : "");
          },
          tacview_ ? record::AcmiWriter::kWatched : record::AcmiWriter::kRecorded),
      recorder_(run_, record::run_file_of(*scenario, seed_, version_text())),
      others_(broadcast_dis(options, *scenario)),
      story_(*scenario, [this](const record::StoryLine& line) { report_.line(line); }),
      mission_(scenario, seed_, until,
               {.workers = options.workers.value_or(1), .paranoid_workers = options.paranoid}) {}

int Flight::fly(const std::function<void()>& steps) {
  if (!options_.json)
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // whoever follows the story reads each line
  if (tacview_ && options_.tacview_wait)
    wait_for_tacview(*tacview_);
  for (sim::Observer* o : std::initializer_list<sim::Observer*>{&tally_, &csv_, &acmi_, &recorder_})
    mission_.run().attach(*o);
  if (others_)
    mission_.run().attach(others_->announcer());
  if (!options_.json && !options_.quiet) {
    report_.header(seed_);
    mission_.run().attach(story_);
  }
  if (!options_.json)
    mission_.run().attach(ends_);

  const auto start = net::Clock::now();
  {
    // a plug-in that ends the program in a decision
    const scenario::EndGuard guard(1, [&](const std::string& done) {
      sim::Fault fault = scenario::fault_of_end(done);
      if (!fault.player)
        return complain("eyrie: {} and ended the program\n", done);
      mission_.fail(std::move(fault));
      try {
        mission_.run().finish();
        static_cast<void>(keep(false));
      } catch (const std::exception& e) {
        complain("eyrie: {}; {}\n", done, words_for(e));
      }
    });
    steps();
    if (interrupted() && mission_.run().time() == 0)
      throw disk::Failed("interrupted before the first step; nothing was flown");
    mission_.run().finish();
  }
  timing_.wall = std::chrono::duration<double>(net::Clock::now() - start).count();
  if (tacview_) {
    tacview_->close(std::chrono::seconds(1));
    timing_.tacview = tacview_->counts();
  }
  if (others_) {
    others_->close();
    timing_.dis = others_->counts();
    tell_nameless(others_->announcer());
  }
  if (const auto& difference = mission_.run().difference()) {
    complain("eyrie: the step is not deterministic: {}\n", difference->text());
    return 1;
  }
  return keep(options_.debrief);
}

int Flight::keep(bool with_page) {
  const std::string lost =
      recorder_.close(mission_.run().orders(), debrief::outcome_text(mission_, tally_));
  timing_.kept_until = recorder_.kept_until();
  if (!run_.close())
    throw disk::Failed(run_.error());
  Beside beside{folder_};
  if (!lost.empty()) {
    beside.lost(lost);
    folder_.spare_old();
  }
  beside.close(events_, record::kEventsName);
  beside.close(flight_, record::kFlightName);
  if (const std::string moved = folder_.commit(); !moved.empty())
    beside.lost(moved);
  if (options_.out.empty())
    if (const std::string why =
            disk::point_link("runs/latest", fs::path(folder_.path()).filename());
        !why.empty())
      beside.lost(why);
  // the run is in its place, whatever becomes of its page
  if (with_page) {
    const std::string file = fmt::format("{}/{}", folder_.path(), record::kRunFileName);
    record::Decoded again = record::read_run_file(file);
    if (again.error.empty())
      beside.page(write_page(
          {.file = file, .run = std::move(again.run), .plugins = {}, .scenario = scenario_},
          fmt::format("{}/{}", folder_.path(), record::kPageName)));
    else
      beside.lost(fmt::format("{}: {}; there is no debrief page", file, again.error));
  }
  if (options_.json)
    say("{}", Composed{json_report(mission_, tally_, seed_, timing_, folder_.path())});
  else
    report_.closing(mission_, tally_, ends_, timing_, folder_.path(), beside.written);
  const sim::Fault* fault = mission_.run().fault();
  if (fault)
    beside.lost(scenario::fault_text(*fault, scenario_->roster, mission_.run().simulation().dt()) +
                "; the run is kept up to there");
  return beside.failed ? 1 : 0;
}

}  // namespace eyrie::app
