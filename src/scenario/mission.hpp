// SPDX-License-Identifier: MIT
#pragma once
/// \file  One flight of a scenario, from its first world to its end.
#include <memory>
#include <optional>
#include <string_view>

#include "scenario/scenario.hpp"
#include "sim/run.hpp"

namespace eyrie::scenario {

/// Why a mission was over.
enum class Outcome : std::uint8_t {
  running,
  blue_home,  ///< every blue aircraft that lived came home, every convoy that lived arrived
  blue_lost,  ///< no blue player lives
  red_lost,   ///< no red player lives
  time,       ///< `until` came first
  stopped,    ///< from outside
};
[[nodiscard]] std::string_view outcome_name(Outcome outcome);

/// A sim::Run that knows when it is over.
class Mission {
 public:
  /// `until` (s) replaces the scenario's own if given.
  Mission(std::shared_ptr<const Scenario> scenario, std::uint64_t seed,
          std::optional<double> until = {}, const sim::RunOptions& options = {});

  /// Goes on from a world of the scenario's simulation. The scenario's own orders are not given
  /// again; `any_home` says whether a blue aircraft has come home before.
  Mission(std::shared_ptr<const Scenario> scenario, sim::World start, double until, bool any_home);

  [[nodiscard]] const Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] sim::Run& run() { return run_; }
  [[nodiscard]] const sim::Run& run() const { return run_; }
  [[nodiscard]] double until() const { return until_; }

  /// One step; false when the mission is over, and then no step was made.
  bool step();
  /// Ends it now.
  void stop() { outcome_ = Outcome::stopped; }
  /// Steps to the end, then tells the observers.
  void fly();

  [[nodiscard]] Outcome outcome() const { return outcome_; }

 private:
  [[nodiscard]] Outcome judge() const;
  /// Everybody stands, and somebody is past the last point of the route.
  [[nodiscard]] bool has_arrived(std::uint16_t convoy) const;

  std::shared_ptr<const Scenario> scenario_;
  sim::Run run_;
  double until_;
  std::uint64_t last_step_;
  bool any_home_ = false;
  Outcome outcome_ = Outcome::running;
};

}  // namespace eyrie::scenario
