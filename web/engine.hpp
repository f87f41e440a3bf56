// SPDX-License-Identifier: MIT
#pragma once
/// \file  Eyrie in a page: what can be asked of it there. The same natively, where it is tested.
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"
#include "web/messages.hpp"

namespace eyrie::web {

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

  // what can be asked: questions.hpp says of each what it does
  Nothing take_zones(std::string_view file);
  [[nodiscard]] NodeTypes node_types(const Nothing& = {}) const;
  [[nodiscard]] Problems validate(const Texts& texts) const;
  About load(const Load& load);
  Flown fly(const Until& until);
  Flown end_flight(const Nothing& = {});
  Nothing run_file(const Nothing&, std::string& bytes);
  About open(std::string_view run_file);
  /// The run once more from its start on, every hash compared with the recorded ones: as far as it
  /// was asked for, packed for the page (page::Packer). What was flown is not flown again by the
  /// next question; seek() and branch() are quick in it.
  Moment page(const Until& until, std::string& packed);
  Followed follow(std::string_view run_file);
  /// Whoever orders what nobody accepts, or for a step that is over, gets BadRequest. `packed` is
  /// what the page has not had yet.
  Advanced advance(const Advance& advance, std::string& packed);
  Moment seek(const Step& step);
  [[nodiscard]] Decided explain(const Decider& decider) const;
  [[nodiscard]] debrief::WhatIf what_if(const Otherwise& otherwise);
  [[nodiscard]] debrief::Outcome outcome(const Nothing& = {}) const;
  [[nodiscard]] debrief::Outcome branch(const Otherwise& otherwise, std::string& packed) const;

 private:
  /// What is being flown.
  [[nodiscard]] scenario::Mission& mission() const;
  /// Becomes a run if it is over.
  Flown flown_so_far(bool over);
  [[nodiscard]] const debrief::Recorded& run() const;
  /// The same, with a trail up to where it is.
  [[nodiscard]] const debrief::Recorded& run_with_trail();
  [[nodiscard]] PlayerId player(const std::string& name) const;
  [[nodiscard]] std::shared_ptr<const scenario::Scenario> other(const Otherwise& otherwise) const;
  About about(const scenario::Scenario& scenario, std::uint64_t seed, double until) const;
  /// Tells the progress, of a flight with such steps (s), in every so many of them.
  void tell(const sim::World& world, double dt) const;
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
