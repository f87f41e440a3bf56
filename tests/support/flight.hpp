// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies scenarios inside a test and remembers what happened.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "model/events.hpp"
#include "record/names.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"

namespace eyrie::test {

using model::EventKind;

/// A scenario of scenarios/, by name, with overrides. Tests run in the root of the source tree.
[[nodiscard]] inline std::shared_ptr<const scenario::Scenario> load_scenario(
    const std::string& name, std::vector<std::string> sets = {}) {
  return scenario::load({"scenarios/" + name + ".yaml", std::move(sets)},
                        scenario::Source::disk("."));
}

/// One committed event and when it was (s).
struct Happened {
  double time = 0;
  sim::Event event;

  [[nodiscard]] EventKind kind() const { return event.kind.as<EventKind>(); }
};

/// Keeps every event of a run.
class EventLog final : public sim::Observer {
 public:
  explicit EventLog(const scenario::Scenario& scenario) : scenario_(scenario) {}

  void observe(const sim::World&, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    for (const sim::Event& e : events)
      all_.push_back({info.time_after(), e});
  }

  [[nodiscard]] const std::vector<Happened>& all() const { return all_; }
  /// Of a kind, and of a player by name if one is given.
  [[nodiscard]] std::vector<Happened> of(EventKind kind, std::string_view who = {}) const {
    std::vector<Happened> found;
    for (const Happened& h : all_)
      if (h.kind() == kind && (who.empty() || scenario_.roster.name(h.event.who) == who))
        found.push_back(h);
    return found;
  }
  [[nodiscard]] std::optional<Happened> first(EventKind kind, std::string_view who = {}) const {
    const auto found = of(kind, who);
    return found.empty() ? std::nullopt : std::optional(found.front());
  }
  /// The trees that a player's outermost sequencer went through, with their times.
  [[nodiscard]] std::vector<std::pair<std::string, double>> phases(std::string_view who) const {
    std::vector<std::pair<std::string, double>> found;
    for (const Happened& h : of(EventKind::phase, who))
      if (record::is_outermost(scenario_, h.event))
        found.emplace_back(record::phase_name(scenario_, h.event), h.time);
    return found;
  }

 private:
  const scenario::Scenario& scenario_;
  std::vector<Happened> all_;
};

/// A mission with a log and a tally attached.
struct Flight {
  std::shared_ptr<const scenario::Scenario> scenario;
  EventLog log;
  record::Tally tally;
  scenario::Mission mission;

  explicit Flight(std::shared_ptr<const scenario::Scenario> what,
                  std::optional<std::uint64_t> seed = {}, const sim::RunOptions& options = {})
      : scenario(std::move(what)),
        log(*scenario),
        tally(*scenario),
        mission(scenario, seed.value_or(scenario->spec.seed), std::nullopt, options) {
    mission.run().attach(log);
    mission.run().attach(tally);
  }

  [[nodiscard]] const sim::World& world() const { return mission.run().world(); }
  [[nodiscard]] double time() const { return mission.run().time(); }
  /// Steps until that time (s) or the end.
  void fly_until(double until) {
    while (time() < until - 1e-9 && mission.step()) {
    }
  }
  /// The row of a player by name, or nothing when he has left the run.
  [[nodiscard]] std::optional<std::uint32_t> row(std::string_view name) const {
    const auto id = scenario->roster.find(name);
    return id ? world().row(scenario->aircraft.table, *id) : std::nullopt;
  }
  [[nodiscard]] const record::Tally::OfPlayer& player(std::string_view name) const {
    return tally.players().at(scenario->roster.find(name).value().value - 1);
  }
};

}  // namespace eyrie::test
