// SPDX-License-Identifier: MIT
#pragma once
/// \file  A campaign whose results are made up, so that thousands of them take no time.
#include <limits>

#include "campaign/engine.hpp"
#include "core/draw.hpp"

namespace eyrie::test {

/// Three cells, columns "end", "kills", "Kills" and "won".
inline campaign::Spec made_up_spec(const std::string& more = "replicates: 40") {
  return campaign::parse_spec(R"(eyrie: 1
name: made up
scenario: none
factors:
  bingo: {path: blue.flights.eagle.bingo, values: [1800 kg, 2200 kg, 2600 kg]}
measures:
  end: {what: end_time}
  kills: {what: kills, who: blue}
  Kills: {what: kills, who: red}
  won: {what: outcome, is: [red_lost]}
)" + more + "\n",
                              "made_up.yaml");
}

/// Depends on the cell and the replicate alone. Every 17th replicate is a fault.
inline campaign::Result made_up(const campaign::Spec& spec, std::uint64_t cell,
                                std::uint64_t replicate) {
  const std::uint64_t seed = campaign::seed_of(spec, cell, replicate);
  std::uint64_t x = (cell + 1) * 0x9e3779b97f4a7c15 + replicate * 0xbf58476d1ce4e5b9;
  x ^= x >> 31;
  x *= 0x94d049bb133111eb;
  x ^= x >> 29;
  campaign::Result result{.cell = cell,
                          .replicate = replicate,
                          .flown = {.seed = seed,
                                    .steps = x % 1000,
                                    .hash = x,
                                    .outcome = scenario::Outcome::red_lost,
                                    .time = static_cast<double>(x % 777) / 7,
                                    .fault = ""}};
  if (replicate % 17 == 16) {
    result.flown.outcome = scenario::Outcome::fault;
    result.flown.fault = "threw: no 'fuel'";
  } else {
    result.values = {result.flown.time, static_cast<double>(x % 5),
                     x % 3 ? 0.1 : std::numeric_limits<double>::quiet_NaN(),
                     static_cast<double>(x % 2)};
  }
  return result;
}

/// Flies nothing; gives up after `left` results.
struct MadeUpCrew final : campaign::Crew {
  const campaign::Spec& spec;
  std::uint64_t left = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t other = 0;  ///< added to the hashes: another program
  std::uint64_t flown = 0;

  explicit MadeUpCrew(const campaign::Spec& s) : spec(s) {}
  void fly(std::span<const campaign::Batch> batches, const Take& take) override {
    const campaign::Plan plan(batches);
    for (std::uint64_t i = 0; i < plan.size(); ++i) {
      auto result = made_up(spec, plan[i].cell, plan[i].replicate);
      result.flown.hash += other;
      if (left-- == 0)
        result.flown.outcome = scenario::Outcome::stopped;
      else
        ++flown;
      if (!take(std::move(result)))
        return;
    }
  }
};

}  // namespace eyrie::test
