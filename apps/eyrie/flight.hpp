// SPDX-License-Identifier: MIT
#pragma once
/// \file  A flight as `fly` and `serve` make it: a mission, and everything that is written, sent
/// and said of it.
#include "commands.hpp"
#include "disk/output.hpp"
#include "live.hpp"
#include "net/precedence.hpp"
#include "net/telemetry_host.hpp"
#include "record/acmi.hpp"
#include "record/event_table.hpp"
#include "record/names.hpp"
#include "record/run_file.hpp"
#include "record/story.hpp"
#include "say.hpp"
#include "scenario/mission.hpp"

namespace eyrie::app {

/// What the options change in the scenario: `--set`, and `--ours`.
[[nodiscard]] std::vector<std::string> overrides(const FlyOptions& options);
/// The scenario with them. Throws Mistake or ConfigError.
[[nodiscard]] std::shared_ptr<const scenario::Scenario> load_scenario(const FlyOptions& options);

/// Throws as a flight would whose run could not be kept in runs/.
void demand_place_for_runs();

/// How long flying took, how well it kept to the clock, and what of it was kept.
struct Timing {
  double wall = 0;                      ///< s
  std::optional<double> kept_until{};   ///< s, if the run file ends before the flight
  std::optional<net::Pacing> pacing{};  ///< if that was asked for
  bool came_first = false;              ///< before all others of the machine
  std::uint64_t moves = 0;              ///< woken on another processor so often
  std::optional<net::TelemetryHost::Counts> tacview{};
  std::optional<Broadcast::Counts> dis{};

  void note(const net::Precedence& precedence) {
    came_first = precedence.permitted();
    moves = precedence.moves();
  }
};

/// How each player ended: who lost it, and its fuel at most a second before.
class Ends final : public sim::Observer {
 public:
  struct OfPlayer {
    std::optional<double> fuel = {};  ///< kg
    std::string by = {};              ///< "eagle1's AMRAAM from 12.1 nmi"
    bool here = true;                 ///< not one of another program that has fallen silent
  };
  explicit Ends(const scenario::Scenario& scenario)
      : scenario_(scenario), players_(scenario.roster.players.size()) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  [[nodiscard]] const std::vector<OfPlayer>& players() const { return players_; }

 private:
  const scenario::Scenario& scenario_;
  std::vector<OfPlayer> players_;
  std::map<PlayerId, std::string> missiles_;  ///< whose, and from where
};

class Report {
 public:
  /// `color` only on a terminal.
  Report(const scenario::Scenario& scenario, bool color) : scenario_(scenario), color_(color) {}

  void header(std::uint64_t seed) const;
  void line(const record::StoryLine& line) const;
  void closing(const scenario::Mission& mission, const record::Tally& tally, const Ends& ends,
               const Timing& timing, const std::string& run_dir, const std::string& files) const;

 private:
  [[nodiscard]] Composed paint(const std::string& text, record::Tone tone) const;
  void table(const record::Tally& tally, const Ends& ends) const;

  const scenario::Scenario& scenario_;
  bool color_;
};

/// The object that `fly --json` prints.
[[nodiscard]] std::string json_report(const scenario::Mission& mission, const record::Tally& tally,
                                      std::uint64_t seed, const Timing& timing,
                                      const std::string& run_dir);

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
