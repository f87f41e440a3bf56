// SPDX-License-Identifier: MIT
#pragma once
/// \file  Recorded runs, opened to be flown again, and where two of them part.
#include "record/run_file.hpp"
#include "scenario/scenario.hpp"
#include "sim/run.hpp"

namespace eyrie::debrief {

/// A run file and the scenario inside it.
struct Recorded {
  std::string file;
  record::RunFile run;
  std::vector<std::string> plugins;  ///< where they are now, in the order of the run
  std::shared_ptr<const scenario::Scenario> scenario;
  scenario::AddNodes add = {};  ///< as it was loaded with

  /// World::step() at the end of the recording.
  [[nodiscard]] std::uint64_t last_step() const { return run.trail.last_step; }
  /// s, when it ends.
  [[nodiscard]] double until() const {
    return static_cast<double>(last_step()) * scenario->simulation->dt();
  }
};

/// A run, or why there is none: `problems` is empty exactly if `recorded` is there.
struct Opened {
  std::optional<Recorded> recorded;
  std::vector<std::string> problems;  ///< a line each, with the file
  std::vector<std::string> unused;    ///< plug-ins that were given and are none of the run's
};

/// Opens a run folder or its run file. `plugins` are where plug-ins of the run are now: these are
/// opened. What the run file names besides is opened if `may_open` permits that, at an absolute
/// path. `add` as of scenario::LoadRequest. `build` is what this program calls itself. A file is
/// refused that is cut, foreign, of a build with another world, or claims what no run of its
/// scenario can have: other orders, more time.
[[nodiscard]] Opened open(const std::string& path, std::vector<std::string> plugins,
                          std::string_view build, const scenario::PluginPermission& may_open = {},
                          const scenario::AddNodes& add = {});

/// The same of a run that was read already and whose plug-ins are at hand; `file` is its name in
/// what is said of it, and stands before no problem.
[[nodiscard]] Opened open(record::RunFile run, std::string file, std::vector<std::string> plugins,
                          std::string_view build, const scenario::AddNodes& add = {});

/// The scenario of a run with more overrides (`path=value`) and changes of trees. Throws
/// ConfigError.
[[nodiscard]] std::shared_ptr<const scenario::Scenario> with_overrides(
    const Recorded& recorded, const std::vector<std::string>& sets,
    std::vector<scenario::TreeChange> changes = {});

/// The path in the run's scenario (scenario/path.hpp) of everything below `trees`, by the place in
/// its file.
[[nodiscard]] std::map<std::string, std::string> tree_paths(const Recorded& recorded);

/// What happened in a step.
struct Happened {
  sim::StepInfo info;
  std::vector<sim::Event> events;
};
/// A run up to one of its worlds, and what had happened until then.
struct Past {
  sim::World world;
  std::vector<Happened> events;  ///< of the steps before it, those in which something happened
};
/// Flies the run to a step, at most to its end.
[[nodiscard]] Past past_at(const Recorded& recorded, std::uint64_t step);

/// Flies a recorded run again, with every step's world before and after, and compares it with the
/// recording on the way. The recording must outlive it.
class Reflight {
 public:
  explicit Reflight(const Recorded& recorded);
  /// From one of its worlds on; what follows is compared no more.
  Reflight(const Recorded& recorded, sim::World from);

  /// It must outlive the last step.
  void attach(sim::Observer& observer) { run_.attach(observer); }
  /// One more order of a recording that grows meanwhile (sim::Run::submit).
  [[nodiscard]] std::string submit(const sim::Order& order) { return run_.submit(order); }
  /// One step; false at the end of the recording. Throws std::runtime_error with words for people
  /// if this is not the run that was recorded: what follows did not happen.
  bool step();
  [[nodiscard]] const sim::World& before() const { return before_; }
  [[nodiscard]] const sim::World& after() const { return run_.world(); }
  /// Those of the step.
  [[nodiscard]] std::span<const sim::Event> events() const { return events_; }
  [[nodiscard]] Happened happened() const;
  [[nodiscard]] std::span<const sim::Order> orders() const {
    return run_.orders_for(before_.step());
  }
  /// s, of the decisions in the step.
  [[nodiscard]] double time() const {
    return static_cast<double>(before_.step()) * run_.simulation().dt();
  }

 private:
  void demand_the_same();

  const Recorded& recorded_;
  sim::Run run_;
  std::optional<sim::TrailChecker> checker_;
  sim::World before_;
  std::span<const sim::Event> events_;
};

/// A place where the runs differ for the first time.
struct Parting {
  std::uint64_t step = 0;  ///< of a world those made, of the others the one in which it was
  double time = 0;         ///< s; of an event at the end of the step, as everywhere
  std::string text;
};

/// Where two recorded runs part: in the world, in what agents ask for, and in events.
struct RunDifference {
  std::optional<Parting> world, action, event;
  std::uint64_t steps = 0;  ///< that were compared
  [[nodiscard]] bool same() const { return !world && !action && !event; }
};

/// Flies both again, step by step, until all three have parted or one ends. `problem` says why two
/// runs cannot be compared: their worlds have other tables.
[[nodiscard]] std::optional<RunDifference> compare(const Recorded& left, const Recorded& right,
                                                   std::string& problem);

}  // namespace eyrie::debrief
