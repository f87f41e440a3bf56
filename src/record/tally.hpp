// SPDX-License-Identifier: MIT
#pragma once
/// \file  Counts a run as it is flown: shots, kills, losses, phases, and how it ended.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/events.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// Reads nothing but committed events.
class Tally final : public sim::Observer {
 public:
  struct OfPlayer {
    std::uint32_t shots = 0, kills = 0;
    bool lost = false, home = false, bingo = false, winchester = false;
    double end_time = 0;  ///< s, when it was lost or came home
    std::string phase;    ///< of its outermost sequencer, "" if it has none
  };
  struct OfSide {
    std::uint32_t players = 0;  ///< that may come home: aircraft
    std::uint32_t losses = 0, shots = 0, kills = 0, home = 0;
  };
  /// A flight's phase is that of whoever leads it.
  struct Phase {
    std::uint16_t flight = 0;
    std::string phase;
    double time = 0;  ///< s, when the flight entered it
  };

  explicit Tally(const scenario::Scenario& scenario);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;

  [[nodiscard]] const std::vector<OfPlayer>& players() const { return players_; }
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }
  [[nodiscard]] OfSide side(model::Side side) const;
  /// The phase that a flight is in, "" if none yet.
  [[nodiscard]] std::string_view phase(std::uint16_t flight) const;

 private:
  void enter(PlayerId who, double time);

  const scenario::Scenario& scenario_;
  std::vector<OfPlayer> players_;  ///< index: id - 1
  std::vector<Phase> phases_;
  std::vector<PlayerId> leads_;  ///< per flight
};

}  // namespace eyrie::record
