// SPDX-License-Identifier: MIT
#pragma once
/// \file  One flight of many; and one scenario flown with many seeds: how it ends, how sure that
/// is, and which seeds are worth a look.
#include <memory>
#include <optional>
#include <span>

#include "core/hash.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"
#include "stats/sample.hpp"

namespace eyrie::campaign {

/// How a flight ended. It depends on the scenario and the seed alone.
struct Flown {
  std::uint64_t seed = 0;
  std::uint64_t steps = 0;
  std::uint64_t hash = 0;  ///< of the last whole world
  scenario::Outcome outcome = scenario::Outcome::running;
  double time = 0;    ///< s
  std::string fault;  ///< why it could not go on, if the outcome is that
};

/// Flies a scenario from its start to its end, or to `until` (s) instead of the scenario's own. The
/// observer, if any, sees every step. `given_up`, asked in every step, stops the flight there. Any
/// number of threads may fly one scenario.
[[nodiscard]] Flown fly(const std::shared_ptr<const scenario::Scenario>& scenario,
                        std::uint64_t seed, sim::Observer* observer = nullptr,
                        std::optional<double> until = {}, bool (*given_up)() = nullptr);

/// The command that flies a scenario: options with their values.
[[nodiscard]] std::string fly_command(
    const std::string& scenario,
    const std::vector<std::pair<const char*, std::vector<std::string>>>& options);

/// A flight with what each side had of it.
struct SeedFlown : Flown {
  record::Tally::OfSide blue, red;
};
[[nodiscard]] SeedFlown fly_seed(const std::shared_ptr<const scenario::Scenario>& scenario,
                                 std::uint64_t seed, std::optional<double> until = {},
                                 bool (*given_up)() = nullptr);

/// A figure of many flights with its 95 % interval, if it has one.
struct SeedEstimate {
  const char* name;
  std::optional<double> value = {};
  std::optional<stats::Interval> interval = {};
};

/// Flights are added in the order of their seeds. Some 50 bytes of each are kept. One that ended
/// with a fault counts as such, and for nothing else.
class SeedTable {
 public:
  void add(const SeedFlown& flown);

  [[nodiscard]] std::uint64_t flown() const { return flown_; }
  [[nodiscard]] stats::Share share(scenario::Outcome outcome) const {
    return {outcomes_[static_cast<std::size_t>(outcome)], flown()};
  }
  /// Means with Student's intervals, ratios of sums with Fieller's.
  [[nodiscard]] std::vector<SeedEstimate> estimates() const;
  /// Over seeds and hashes, in order.
  [[nodiscard]] std::uint64_t hash() const { return hash_.value(); }

  /// A seed to look at, and why.
  struct StandsOut {
    std::uint64_t seed;
    std::string why;  ///< "first", "typical", "best for blue" ...; several with commas
  };
  /// The first one; the typical one, whose figures are nearest to the means by their deviations;
  /// the best and the worst for blue by losses; the longest; the first with a fault. By seed.
  [[nodiscard]] std::vector<StandsOut> stand_out() const;

 private:
  using Figures = std::array<double, 5>;  ///< blue and red losses, blue and red shots, end time (s)
  struct Row {
    std::uint64_t seed;
    Figures figures;
  };
  std::uint64_t flown_ = 0;
  std::vector<Row> rows_;  ///< without faults
  std::array<std::uint64_t, enum_names<scenario::Outcome>().size()> outcomes_{};
  std::array<stats::Moments, std::tuple_size_v<Figures>> figures_;
  stats::Ratio exchange_, blue_kills_, red_kills_;
  std::optional<std::uint64_t> first_fault_;
  Hasher hash_;
};

}  // namespace eyrie::campaign
