// SPDX-License-Identifier: MIT
#pragma once
/// \file  One flight of a scenario, from its first world to its end.
#include <algorithm>

#include "core/enum_names.hpp"
#include "scenario/roster.hpp"
#include "scenario/scenario.hpp"
#include "sim/event.hpp"
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
  fault,      ///< the next step cannot be made: run().fault()
  both_lost,  ///< nobody lives on either side, and the last of both were lost in one step
};
constexpr auto names_of(Outcome) {
  return names_from_zero<Outcome>("running", "blue_home", "blue_lost", "red_lost", "time",
                                  "stopped", "fault", "both_lost");
}

/// Why a flight cannot end at `until` (s), in words: before its first step is over, or later than
/// any. Nothing if it can.
[[nodiscard]] std::optional<std::string> until_problem(const ScenarioSpec& spec, double until);
/// Why nothing would be flown of a scenario that is whole, in words: what ends it holds at its
/// start. Nothing if something would.
[[nodiscard]] std::optional<std::string> start_problem(const Scenario& scenario);

/// What a judge keeps of a run from step to step.
struct Course {
  bool any_home = false;    ///< whether a blue aircraft has come home
  sim::Census census = {};  ///< after the last step
};

/// Says when a flight is over. Allocates only when it is made.
class Judge {
 public:
  /// `until` in s. The scenario must outlive it.
  Judge(const Scenario& scenario, double until);

  /// `any_home`: whether a blue aircraft has come home before.
  [[nodiscard]] Outcome operator()(const sim::World& world, bool any_home);
  /// After a step of a run that went on, with its events.
  [[nodiscard]] Outcome after_step(const sim::World& world, std::span<const sim::Event> events,
                                   Course& course) {
    course.any_home |= comes_home(events);
    const bool same = world.census() == course.census && !somebody_may_arrive_;
    return same ? by_time(world) : count_anew(world, course);
  }

 private:
  [[nodiscard]] Outcome count_anew(const sim::World& world, Course& course) {
    course.census = world.census();
    return (*this)(world, course.any_home);
  }
  [[nodiscard]] Outcome by_time(const sim::World& world) const {
    return world.step() >= last_step_ ? Outcome::time : Outcome::running;
  }
  /// Whether a blue aircraft does in these events.
  [[nodiscard]] bool comes_home(std::span<const sim::Event> events) const {
    return std::ranges::any_of(events, [&](const sim::Event& e) { return is_home_of_blue(e); });
  }
  [[nodiscard]] bool is_home_of_blue(const sim::Event& event) const;

  const Scenario* scenario_;
  std::uint64_t last_step_;
  bool somebody_may_arrive_;         ///< who drives: that can end a run whose census stays the same
  std::vector<Standing> standings_;  ///< by flight
};

/// A sim::Run that knows when it is over.
class Mission {
 public:
  /// `until` (s) replaces the scenario's own if given.
  Mission(const std::shared_ptr<const Scenario>& scenario, std::uint64_t seed,
          std::optional<double> until = {}, const sim::RunOptions& options = {});

  /// Goes on from a world of the scenario's simulation. The scenario's own orders are not given
  /// again; `any_home` says whether a blue aircraft has come home before.
  Mission(std::shared_ptr<const Scenario> scenario, sim::World start, double until, bool any_home,
          const sim::RunOptions& options = {});

  [[nodiscard]] const Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] sim::Run& run() { return run_; }
  [[nodiscard]] const sim::Run& run() const { return run_; }
  [[nodiscard]] double until() const { return until_; }

  /// One step; false when the mission is over, and then no step was made.
  bool step();
  /// Ends it before the step that is being made (sim::Run::fail).
  void fail(sim::Fault fault) {
    run_.fail(std::move(fault));
    outcome_ = Outcome::fault;
  }
  /// Goes on after a fault, with the step that could not be made.
  void forgive() {
    run_.forgive();
    if (outcome_ == Outcome::fault)
      outcome_ = Outcome::running;
  }
  /// Ends it now, if it is not over.
  void stop() {
    if (outcome_ == Outcome::running)
      outcome_ = Outcome::stopped;
  }
  /// Steps to the end, then tells the observers.
  void fly();

  [[nodiscard]] Outcome outcome() const { return outcome_; }
  /// Whether a blue aircraft has come home so far: for another mission that goes on from here.
  [[nodiscard]] bool any_home() const { return course_.any_home; }

 private:
  std::shared_ptr<const Scenario> scenario_;
  sim::Run run_;
  double until_;
  Judge judge_;
  Course course_;
  Outcome outcome_;
};

/// "eagle1 at 12.3 s (step 615): root/pursue of tree 'pilot', from libmine.so, threw: no fuel"
[[nodiscard]] std::string fault_text(const sim::Fault& fault, const Roster& roster, double dt);

/// The fault of whoever ends the program in the middle of this thread's decision; its player is
/// none if the thread makes no decision. `done` as of EndGuard.
[[nodiscard]] sim::Fault fault_of_end(const std::string& done);

}  // namespace eyrie::scenario
