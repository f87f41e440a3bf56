// SPDX-License-Identifier: MIT
#pragma once
/// \file  Tacview ACMI 2.2 text: aircraft, missiles, kills, locks, fuel and who is in charge.
/// Format: https://www.tacview.net/documentation/acmi/ (as of 2024-06-20).
#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "disk/sink.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// Writes a flight recording while a run is flown. Aircraft are sampled at 5 Hz and missiles at
/// 10 Hz; births, deaths and decisions stand at the time of their step. Positions are relative to
/// the reference point, so that seven decimals of a degree (about 1 cm) stay short.
class AcmiWriter final : public sim::Observer {
 public:
  AcmiWriter(const scenario::Scenario& scenario, disk::Sink& sink);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

 private:
  struct Shown {
    std::uint64_t locked = 0;
    std::uint32_t behavior = 0;
    double fuel = -1;
    float vote = -1;
  };

  void frame(double time);
  void place(PlayerId id, const model::Kinematics& k);
  void aircraft(const sim::World& world, std::size_t row);
  void vehicle(const sim::World& world, std::size_t row);
  void players(const sim::World& world);
  /// Ends the line of a player with who it is.
  void introduce(const scenario::Roster::Player& player, std::string_view type);
  /// The behavior in charge, if it has changed.
  template <class Agent, class Trees>
  void winner(Shown& shown, const Agent& agent, const Trees& trees);
  void new_missile(const sim::Event& event, const sim::World& world);
  void happened(const sim::Event& event, const sim::World& world);
  void flush();

  const scenario::Scenario& scenario_;
  disk::Sink& sink_;
  fmt::memory_buffer out_;
  double written_time_ = -1, time_ = 0, dt_ = 0;
  std::vector<Shown> shown_;
  std::vector<PlayerId> gone_;
};

}  // namespace eyrie::record
