// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the user reads: header, story, closing table; or one JSON object.
#include "live.hpp"
#include "net/precedence.hpp"
#include "net/telemetry_host.hpp"
#include "record/names.hpp"
#include "record/story.hpp"
#include "say.hpp"
#include "scenario/mission.hpp"

namespace eyrie::app {

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

}  // namespace eyrie::app
