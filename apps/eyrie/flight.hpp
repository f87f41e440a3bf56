// SPDX-License-Identifier: MIT
#pragma once
/// \file  A flight as `fly` and `serve` make it: a mission, and everything that is written, sent
/// and said of it.
#include "commands.hpp"
#include "disk/output.hpp"
#include "live.hpp"
#include "record/acmi.hpp"
#include "record/csv.hpp"
#include "record/run_file.hpp"
#include "report.hpp"
#include "scenario/mission.hpp"

namespace eyrie::app {

/// What the options change in the scenario: `--set`, and `--ours`.
[[nodiscard]] std::vector<std::string> overrides(const FlyOptions& options);
/// The scenario with them. Throws Mistake or ConfigError.
[[nodiscard]] std::shared_ptr<const scenario::Scenario> load_scenario(const FlyOptions& options);

/// Throws as a flight would whose run could not be kept in runs/.
void demand_place_for_runs();

class Flight {
 public:
  /// With the folder and the hosts that the options ask for. `until` (s) as for a mission. The
  /// options must outlive it.
  Flight(const FlyOptions& options, const std::shared_ptr<const scenario::Scenario>& scenario,
         std::optional<double> until = {});

  [[nodiscard]] scenario::Mission& mission() { return mission_; }
  [[nodiscard]] Timing& timing() { return timing_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] std::string folder() const { return folder_.path(); }
  /// Whether there is a reason not to step on: it cannot be recorded any more, or a paranoid step
  /// has found something.
  [[nodiscard]] bool broken() const { return mission_.run().difference() || !run_.error().empty(); }

  /// Before each step: what other programs tell of their players, as orders for it.
  [[nodiscard]] std::vector<sim::Order> listen() {
    return others_ ? others_->listen(mission_) : std::vector<sim::Order>{};
  }
  /// One of them has stopped us, until it says go on.
  [[nodiscard]] bool frozen() const { return others_ && others_->frozen(); }

  /// `steps` makes the steps, all of them watched; the flight ends with the last one and is kept.
  /// Gives the exit code.
  [[nodiscard]] int fly(const std::function<void()>& steps);

 private:
  int keep(bool with_page);

  const FlyOptions& options_;
  std::shared_ptr<const scenario::Scenario> scenario_;
  std::uint64_t seed_;
  disk::OutputFolder folder_;
  Report report_;
  disk::Sink run_, events_, flight_;
  record::Tally tally_;
  Ends ends_;
  record::EventsCsv csv_;
  std::unique_ptr<net::TelemetryHost> tacview_;
  record::AcmiWriter acmi_;
  record::RunFileWriter recorder_;
  std::unique_ptr<Broadcast> others_;
  record::Story story_;
  scenario::Mission mission_;
  Timing timing_;
};

}  // namespace eyrie::app
