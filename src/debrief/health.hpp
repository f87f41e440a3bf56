// SPDX-License-Identifier: MIT
#pragma once
/// \file  How believable a flown war is: what an instructor would look at, counted over many seeds.
#include <array>
#include <map>

#include "scenario/mission.hpp"

namespace eyrie::debrief {

/// How steadily somebody flies, sample by sample. Angles in rad.
class Steadiness {
 public:
  static constexpr double kWindow = 60;  ///< s, after which the heading gained is compared

  void sample(double time, double heading, double roll);
  /// The time of watching is over, until the next sample.
  void stop();

  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  /// Of the bank, from 10 degrees on one side to 10 on the other.
  [[nodiscard]] std::uint64_t reversals() const { return reversals_; }
  [[nodiscard]] double turned() const { return turned_; }  ///< heading, either way
  [[nodiscard]] double gained() const { return gained_; }  ///< what is left of it a window later

 private:
  bool watched_ = false;
  double begin_ = 0, first_ = 0, heading_ = 0, turned_ = 0, gained_ = 0;
  int bank_ = 0;  ///< the side of the last bank
  std::uint64_t samples_ = 0, reversals_ = 0;
};

/// Sums over runs of one scenario: those of several runs are added. Angles in rad, times in s.
struct Health {
  static constexpr std::size_t kBins = 10;
  static constexpr double kBin = 0.2;  ///< no-escape ranges; the last one is open
  struct Bin {
    std::uint64_t shots = 0, kills = 0;
  };

  std::uint64_t runs = 0;
  // pursuit of a target beyond 10 nmi, sampled ten times a second
  double pursued = 0;               ///< s
  std::uint64_t reversals = 0;      ///< of the bank, beyond 10 degrees on each side
  double turned = 0, gained = 0;    ///< heading turned, and what of it is left after each minute
  std::vector<float> pursuit_mach;  ///< of all pursuits, once a second
  // shots
  std::vector<float> launch_mach;
  std::array<Bin, kBins> by_zone{};  ///< by range at launch over r_ne
  std::uint64_t killed = 0;          ///< missiles that killed whom they were shot at
  std::uint64_t missiles = 0, at_the_dead = 0, fratricides = 0;
  // pilots
  std::uint64_t engagements = 0;     ///< pilots who took a target at all
  std::uint64_t target_changes = 0;  ///< from one living enemy to another
  std::uint64_t wvr = 0;             ///< pilots' entries into a phase "wvr"
  std::uint64_t wvr_seen = 0;        ///< of them with a living enemy in the flight's sight
  std::uint64_t defenses = 0, for_others = 0;  ///< against missiles, and against those of mates
  std::vector<float> merged_mach;              ///< within 5 nmi of a living enemy, once a second
  std::uint64_t near_mates = 0;                ///< runs in which two of one side came within 500 ft
  std::uint64_t collisions = 0;                ///< pilots who hit somebody in the air
  std::uint64_t recommits = 0, recommits_lost = 0;  ///< and of them who died within a minute
  // ends
  std::uint64_t undecided = 0;      ///< out of time with both sides alive
  std::uint64_t left_fighting = 0;  ///< somebody went home from living enemies: fuel or losses
  std::array<std::uint64_t, 2> lost{}, players{};  ///< blue, red
  std::array<std::uint64_t, 2> won{};              ///< runs in which a side lost fewer

  void add(const Health& other);
};

/// Of one run from start to end.
[[nodiscard]] Health measure(const std::shared_ptr<const scenario::Scenario>& scenario,
                             std::uint64_t seed);

}  // namespace eyrie::debrief
