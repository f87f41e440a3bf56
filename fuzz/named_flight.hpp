// SPDX-License-Identifier: MIT
#pragma once
/// \file  A short fight, flown once, in which everything has the names that a fuzzer makes up: what
/// the fuzzers of the writers feed them with. Run them in the root of the source tree, or say where
/// that is by EYRIE_HOME.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/demand.hpp"
#include "fuzz/shipped.hpp"
#include "scenario/mission.hpp"
#include "sim/system.hpp"
#include "sim/trail.hpp"

namespace eyrie::fuzz {

/// The texts in an input: each is as long as the byte before it says, modulo 64; no name
/// is empty. They come again from the first one when they are used up.
class Texts {
 public:
  Texts(const std::uint8_t* data, std::size_t size) {
    for (std::size_t at = 0; at < size;) {
      const std::size_t length = std::min<std::size_t>(data[at] % 64, size - at - 1);
      all_.emplace_back(reinterpret_cast<const char*>(data) + at + 1, length);
      if (length == 0)
        all_.back() = "?";
      at += 1 + length;
    }
    if (all_.empty())
      all_.emplace_back("?");
  }
  /// q0q, q1q and so on: what these became tells where the texts of an input belong.
  Texts() {
    for (int i = 0; i < 10'000; ++i)
      all_.push_back(fmt::format("q{}q", i));
  }
  std::string next() { return all_[next_++ % all_.size()]; }
  /// What was written with q0q, q1q ..., as it must be with these.
  [[nodiscard]] std::string in(std::string_view numbered) const {
    std::string text;
    for (std::size_t i = 0; i < numbered.size(); ++i) {
      std::size_t number = 0;
      const char* const end = numbered.data() + numbered.size();
      const auto [behind, failed] = std::from_chars(numbered.data() + i + 1, end, number);
      if (numbered[i] != 'q' || failed != std::errc{} || behind == end || *behind != 'q') {
        text += numbered[i];
        continue;
      }
      text += all_[number % all_.size()];
      i = static_cast<std::size_t>(behind - numbered.data());
    }
    return text;
  }

 private:
  std::vector<std::string> all_;
  std::size_t next_ = 0;
};

/// The scenario `merge`, begun close behind the other, with its shot and its kill: what an observer
/// sees of its steps.
class NamedFlight {
  struct Step {
    sim::World world;
    sim::StepInfo info = {};
    std::vector<sim::Event> events = {};
  };

 public:
  NamedFlight() {
    const std::string start = "red.flights.bandit.start.";
    loaded_ = shipped("merge",
                      {start + "east=-5.6 nmi", start + "north=0.2 nmi", start + "heading=90 deg"});
    scenario_ = *loaded_;
    scenario_.library = library_ = std::make_shared<model::Library>(*loaded_->library);
    struct Keep final : sim::Observer {
      explicit Keep(std::vector<Step>& all) : steps(all) {}
      void begin(const sim::World& world, double) override { steps.push_back({world}); }
      void observe(const sim::World& world, const sim::StepInfo& info,
                   std::span<const sim::Event> events) override {
        if (world.step() % 50 == 0 || !events.empty())
          steps.push_back({world, info, {events.begin(), events.end()}});
      }
      std::vector<Step>& steps;
    } keep(steps_);
    scenario::Mission mission(loaded_, loaded_->spec.seed);
    sim::TrailRecorder recorder;
    mission.run().attach(keep);
    mission.run().attach(recorder);
    mission.fly();
    demand(mission.outcome() == scenario::Outcome::red_lost);
    trail_ = recorder.trail();
  }

  /// Everything that an output could show has another name from now on.
  void rename(Texts& texts) {
    scenario_.spec.name = texts.next();
    scenario_.spec.help_text = texts.next();
    for (auto& player : scenario_.roster.players) {
      player.name = texts.next();
      player.label = texts.next();
    }
    for (auto& flight : scenario_.roster.flights)
      flight.name = texts.next();
    for (std::size_t i = 0; i < library_->missiles.size(); ++i)
      const_cast<model::MissileType&>(library_->missiles[i]).label = texts.next();
    for (std::uint16_t t = 0; t < scenario_.trees->size(); ++t)
      for (ubf::NodeIndex n = 0; n < (*scenario_.trees)[t].size(); ++n)
        const_cast<pilot::Behavior&>((*scenario_.trees)[t].node(n)).set_label(texts.next());
  }

  void show(sim::Observer& observer) const {
    const double dt = loaded_->simulation->dt();
    observer.begin(steps_.front().world, dt);
    for (std::size_t i = 1; i < steps_.size(); ++i)
      observer.observe(steps_[i].world, steps_[i].info, steps_[i].events);
    observer.finish(steps_.back().world);
  }

  [[nodiscard]] const scenario::Scenario& scenario() const { return scenario_; }
  [[nodiscard]] const sim::HashTrail& trail() const { return trail_; }
  [[nodiscard]] std::size_t events() const {
    std::size_t sum = 0;
    for (const Step& step : steps_)
      sum += step.events.size();
    return sum;
  }

 private:
  std::shared_ptr<const scenario::Scenario> loaded_;
  scenario::Scenario scenario_;
  std::shared_ptr<model::Library> library_;
  std::vector<Step> steps_;
  sim::HashTrail trail_;
};

/// Flown before the first input.
[[nodiscard]] inline NamedFlight& flight() {
  static NamedFlight one;
  return one;
}

}  // namespace eyrie::fuzz
