// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "commands.hpp"
#include "core/units.hpp"
#include "interrupt.hpp"
#include "locate.hpp"
#include "output.hpp"
#include "report.hpp"
#include "say.hpp"
#include "sim/trail.hpp"

namespace eyrie::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Keeps the mission at `factor` times real time and counts the steps that came late.
class Pacer {
 public:
  Pacer(double dt, double factor) : step_(dt / factor), begin_(Clock::now()) {}

  void wait(Timing& timing) {
    ++timing.deadlines;
    const std::chrono::duration<double> due(step_ * static_cast<double>(timing.deadlines));
    const auto deadline = begin_ + std::chrono::duration_cast<Clock::duration>(due);
    const std::chrono::duration<double> late = Clock::now() - deadline;
    if (late.count() > step_) {  // a whole step too late
      ++timing.missed;
      timing.worst_late = std::max(timing.worst_late, late.count());
    }
    std::this_thread::sleep_until(deadline);
  }

 private:
  double step_;
  Clock::time_point begin_;
};

void fly_to_the_end(scenario::Mission& mission, const FlyOptions& options, Timing& timing) {
  listen_for_interrupts();
  const auto begun = Clock::now();
  Pacer pacer(mission.run().simulation().dt(), options.realtime.value_or(1));
  timing.paced = options.realtime.has_value();
  while (mission.step()) {
    if (interrupted())
      mission.stop();
    if (mission.run().difference())
      mission.stop();
    if (timing.paced)
      pacer.wait(timing);
  }
  mission.run().finish();
  timing.wall = std::chrono::duration<double>(Clock::now() - begun).count();
}

record::RunFile run_file_of(const scenario::Mission& mission, std::uint64_t seed,
                            const sim::TrailRecorder& trail, std::string outcome) {
  const scenario::Scenario& s = mission.scenario();
  const auto orders = mission.run().orders();
  return {
      .build = version_text(),
      .scenario = s.file,
      .files = s.files,
      .sets = s.sets,
      .seed = seed,
      .until = static_cast<double>(mission.run().world().step()) * mission.run().simulation().dt(),
      .layout_hash = mission.run().simulation().schema().layout_hash(),
      .orders = {orders.begin(), orders.end()},
      .trail = trail.trail(),
      .outcome = std::move(outcome),
      .plugins = s.plugins};
}

/// Nothing is left behind when a file could not be written.
bool written(disk::Sink& sink) {
  if (sink.close())
    return true;
  complain("eyrie: {}\n", sink.error());
  return false;
}

}  // namespace

int fly(const FlyOptions& options) {
  std::optional<double> until;
  if (!options.until.empty()) {
    const Parsed time = parse_quantity(options.until, Dimension::time);
    if (!time || time.value <= 0) {
      complain("--until: {}\n", time ? "must be after the start" : time.error);
      return 2;
    }
    until = time.value;
  }
  const auto scenario = load_or_complain(options.scenario, options.sets, options.plugins);
  if (!scenario)
    return 2;
  const std::uint64_t seed = options.seed.value_or(scenario->spec.seed);

  std::optional<OutputFolder> folder;
  try {
    folder.emplace(options.out, scenario->spec.name, seed, options.force);
  } catch (const std::invalid_argument& e) {
    complain("eyrie: {}\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    complain("eyrie: {}\n", e.what());
    return 1;
  }

  // who watches
  const Report report(*scenario, !options.json && ::isatty(STDOUT_FILENO));
  disk::Sink events(folder->file("events.csv")), flight(folder->file("flight.acmi"));
  record::Tally tally(*scenario);
  record::EventsCsv csv(*scenario, events);
  record::AcmiWriter acmi(*scenario, flight);
  sim::TrailRecorder trail;
  record::Story story(*scenario, [&](const record::StoryLine& line) { report.line(line); });
  scenario::Mission mission(scenario, seed, until,
                            {.workers = options.workers, .paranoid_workers = options.paranoid});
  for (sim::Observer* o : std::initializer_list<sim::Observer*>{&tally, &csv, &acmi, &trail})
    mission.run().attach(*o);
  const bool words = !options.json && !options.quiet;
  if (words) {
    report.header(seed);
    mission.run().attach(story);
  }

  Timing timing;
  fly_to_the_end(mission, options, timing);
  if (const auto& difference = mission.run().difference()) {
    complain("eyrie: the step is not deterministic: {}\n", difference->text());
    return 1;
  }

  debrief::Recorded recorded{.file = folder->path(),
                             .run = run_file_of(mission, seed, trail, outcome_text(mission, tally)),
                             .plugins = {},
                             .scenario = scenario};
  disk::Sink run(folder->file("run.eyrie"));
  run.write(record::encode(recorded.run));
  if (!written(run) || !written(events) || !written(flight))
    return 1;
  PageWritten page;
  if (options.debrief)
    page = write_page(recorded, folder->file("debrief.html"));
  if (page.failed)
    return 1;
  folder->commit();
  if (options.json)
    say("{}", Composed{json_report(mission, tally, seed, timing, folder->path())});
  else
    report.closing(mission, tally, timing, folder->path(), page.written);
  if (!page.problem.empty())
    complain("eyrie: {}\n", page.problem);
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace eyrie::app
