// SPDX-License-Identifier: MIT
#pragma once
/// \file  Eyrie in a page: what can be asked of it there. The same natively, where it is tested.
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"
#include "web/messages.hpp"

namespace eyrie::web {

/// Progress is told every so many steps.
inline constexpr std::uint64_t kTell = 1024;

/// One scenario or run at a time. A scenario is loaded and flown, and is then a run as one that was
/// opened: it can be looked at in any step, explained, questioned and flown on otherwise. Whoever
/// asks for what is not there, such as a moment before anything was loaded, gets BadRequest; a
/// mistake in a text is a ConfigError, a run that is not flown as it was recorded a
/// std::runtime_error.
class Engine {
 public:
  /// Told s of simulated time now and then during long answers.
  using Progress = std::function<void(double)>;
  explicit Engine(Progress progress = {}) : progress_(std::move(progress)) {}

  /// The launch zones of the shipped missiles (KeptZones::take), which then need not be flown.
  static void take_zones(std::string_view file);
  /// What trees may be made of.
  [[nodiscard]] static NodeTypes node_types();
  /// Every mistake in a scenario and its files.
  [[nodiscard]] static Problems validate(const Texts& texts);
  /// Reads a scenario: fly() then begins at its start.
  About load(const Load& load);
  /// On with what was loaded, or with a branch. When it is over it has become a run.
  Flown fly(const Until& until);
  /// The run file of what was flown to its end, or so far.
  [[nodiscard]] std::string run_file();
  /// Opens a run file.
  About open(std::string_view run_file);

  /// The run once more from its start on, every hash compared with the recorded ones: as far as it
  /// was asked for, packed for the page (page::Packer). What was flown is not flown again by the
  /// next question; seek() and branch() are quick in it.
  Moment page(const Until& until, std::string& packed);
  /// Opens a run that others are flying, from its run file so far: advance() begins at its start.
  Followed follow(std::string_view run_file);
  /// On with what is followed, with orders from outside. Whoever orders what nobody accepts, or for
  /// a step that is over, gets BadRequest. `packed` is what the page has not had yet.
  Advanced advance(const Advance& advance, std::string& packed);
  /// Goes to a step of the run.
  Moment seek(const Step& step);
  /// What a player decided in the step that follows.
  [[nodiscard]] Decided explain(const Decider& decider) const;
  /// What it would have decided during the whole run, its states being what they were.
  [[nodiscard]] debrief::WhatIf what_if(const Otherwise& otherwise);
  /// How the run ended.
  [[nodiscard]] debrief::Outcome outcome() const;
  /// How it would have ended, flown on from there with other trees and models, packed for the page.
  [[nodiscard]] debrief::Outcome branch(const Branch& branch, std::string& packed) const;

 private:
  [[nodiscard]] const debrief::Recorded& run() const;
  /// The same, with a trail up to where it is.
  [[nodiscard]] const debrief::Recorded& run_with_trail();
  [[nodiscard]] PlayerId player(const std::string& name) const;
  [[nodiscard]] std::shared_ptr<const scenario::Scenario> other(
      const std::string& player, const std::vector<std::string>& sets) const;
  About about(const scenario::Scenario& scenario, std::uint64_t seed, std::string build,
              double until) const;
  void tell(const sim::World& world) const;
  /// The run at a step; the events are left out if nobody wants them.
  [[nodiscard]] debrief::Past past(std::uint64_t step, bool with_events) const;

  Progress progress_;
  // what is being flown
  struct Flight;
  std::shared_ptr<Flight> flight_;
  // what was
  std::optional<debrief::Recorded> recorded_;
  struct Reflown;
  std::shared_ptr<Reflown> reflown_;
  std::optional<sim::World> here_;
};

/// Its mistakes, each with its place.
[[nodiscard]] Problems problems_of(const ConfigError& error);

/// Answers one request in JSON. `bytes` are those that came with it, and afterwards those that go
/// with the answer. Never throws but for a lack of memory.
[[nodiscard]] std::string answer(Engine& engine, std::string_view request, std::string& bytes);

}  // namespace eyrie::web
