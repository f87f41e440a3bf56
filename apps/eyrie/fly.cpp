// SPDX-License-Identifier: MIT
#include <filesystem>

#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "disk/file_system.hpp"
#include "disk/output.hpp"
#include "live.hpp"
#include "locate.hpp"
#include "net/pacing.hpp"
#include "record/acmi.hpp"
#include "record/csv.hpp"
#include "record/run_file.hpp"
#include "report.hpp"
#include "say.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/mission.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

/// Or until it cannot be recorded any more.
void fly_to_the_end(scenario::Mission& mission, const disk::Sink& file, const FlyOptions& options,
                    Timing& timing) {
  using net::Clock;
  const Clock::time_point start = Clock::now();
  Clock::time_point begun = start;
  const bool live = !options.tacview.empty() || !options.dis.empty();
  if (const double rate = options.real_time.value_or(live ? 1 : 0); rate > 0)
    timing.pacing.emplace(mission.run().simulation().dt() / rate, start);
  for (;;) {
    if (timing.pacing) {
      net::sleep_until(timing.pacing->due(), interrupted);
      begun = Clock::now();
    }
    if (!mission.step())
      break;
    if (timing.pacing)
      timing.pacing->made(begun, Clock::now());
    if (interrupted() || mission.run().difference() || !file.error().empty())
      mission.stop();
  }
  mission.run().finish();
  timing.wall = std::chrono::duration<double>(Clock::now() - start).count();
}

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

}  // namespace

int fly(const FlyOptions& options) {
  Flown flown;
  return options.watch ? fly_and_watch(options) : fly(options, flown);
}

int fly(const FlyOptions& options, Flown& flown) {
  std::optional<double> until;
  if (!options.until.empty()) {
    const Parsed time = parse_quantity(options.until, Dimension::time);
    if (!time)
      refuse("--until: {}", time.error);
    until = time.value;
  }
  const auto scenario =
      load_scenario(options.scenario, options.sets, options.plugins, options.includes);
  if (const auto problem = until ? scenario::until_problem(scenario->spec, *until) : std::nullopt)
    refuse("--until: {}", *problem);
  for (const auto& [name, text] : scenario->files)
    flown.files.push_back(name);
  if (!options.seeds.empty())
    return fly_seeds(options, scenario, until);
  const std::uint64_t seed = options.seed.value_or(scenario->spec.seed);

  listen_for_interrupts();
  disk::OutputFolder folder(folder_of(options, *scenario, seed));
  if (!options.json)
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // whoever follows the story reads each line

  // who watches
  const Report report(*scenario, !options.json && colors());
  disk::Sink run = folder.file(record::kRunFileName), events = folder.file(record::kEventsName),
             flight = folder.file(record::kFlightName);
  record::Tally tally(*scenario);
  Ends ends(*scenario);
  record::EventsCsv csv(*scenario, events);
  const std::unique_ptr<net::TelemetryHost> tacview =
      host_tacview(options, record::acmi_name(scenario->spec.name));
  record::AcmiWriter acmi(
      *scenario,
      [&](std::string_view lines) {
        flight.write(lines);
        if (tacview)
          tacview->send(lines, tacview->wanted() ? acmi.whole() : "");
      },
      tacview ? record::AcmiWriter::kWatched : record::AcmiWriter::kRecorded);
  record::RunFileWriter recorder(run, record::run_file_of(*scenario, seed, version_text()));
  const std::unique_ptr<Broadcast> others = broadcast_dis(options, *scenario);
  if (tacview && options.tacview_wait)
    wait_for_tacview(*tacview);
  record::Story story(*scenario, [&](const record::StoryLine& line) { report.line(line); });
  scenario::Mission mission(
      scenario, seed, until,
      {.workers = options.workers.value_or(1), .paranoid_workers = options.paranoid});
  for (sim::Observer* o : std::initializer_list<sim::Observer*>{&tally, &csv, &acmi, &recorder})
    mission.run().attach(*o);
  if (others)
    mission.run().attach(others->announcer);
  const bool words = !options.json && !options.quiet;
  if (words) {
    report.header(seed);
    mission.run().attach(story);
  }
  if (!options.json) {
    mission.run().attach(ends);
  }

  // when it has been flown
  Timing timing;
  const auto keep = [&](bool with_page) {
    const std::string lost = recorder.close(mission.run().orders(), outcome_text(mission, tally));
    if (!run.close())
      throw disk::Failed(run.error());
    Beside beside{folder};
    if (!lost.empty()) {
      beside.lost(lost);
      folder.spare_old();
    }
    beside.close(events, record::kEventsName);
    beside.close(flight, record::kFlightName);
    if (const std::string moved = folder.commit(); !moved.empty())
      beside.lost(moved);
    if (options.out.empty())
      if (const std::string why =
              disk::point_link("runs/latest", fs::path(folder.path()).filename());
          !why.empty())
        beside.lost(why);
    flown.folder = folder.path();
    // the run is in its place, whatever becomes of its page
    if (with_page) {
      const std::string file = fmt::format("{}/{}", folder.path(), record::kRunFileName);
      record::Decoded again = record::read_run_file(file);
      if (again.error.empty())
        beside.page(write_page(
            {.file = file, .run = std::move(again.run), .plugins = {}, .scenario = scenario},
            fmt::format("{}/{}", folder.path(), record::kPageName)));
      else
        beside.lost(fmt::format("{}: {}; there is no debrief page", file, again.error));
    }
    if (options.json)
      say("{}", Composed{json_report(mission, tally, seed, timing, folder.path())});
    else
      report.closing(mission, tally, ends, timing, folder.path(), beside.written);
    const sim::Fault* fault = mission.run().fault();
    if (fault)
      beside.lost(scenario::fault_text(*fault, scenario->roster, mission.run().simulation().dt()) +
                  "; the run is kept up to there");
    return beside.failed ? 1 : 0;
  };

  {
    // a plug-in that ends the program in a decision
    const scenario::EndGuard guard(1, [&](const std::string& done) {
      sim::Fault fault = scenario::fault_of_end(done);
      if (!fault.player)
        return complain("eyrie: {} and ended the program\n", done);
      mission.fail(std::move(fault));
      try {
        mission.run().finish();
        static_cast<void>(keep(false));
      } catch (const std::exception& e) {
        complain("eyrie: {}; {}\n", done, words_for(e));
      }
    });
    fly_to_the_end(mission, run, options, timing);
  }
  if (tacview) {
    tacview->close(std::chrono::seconds(1));
    timing.tacview = tacview->counts();
  }
  if (others) {
    others->sender.close();
    timing.dis = others->sender.counts();
    tell_nameless(others->announcer);
  }
  if (const auto& difference = mission.run().difference()) {
    complain("eyrie: the step is not deterministic: {}\n", difference->text());
    return 1;
  }
  return keep(options.debrief);
}

}  // namespace eyrie::app
