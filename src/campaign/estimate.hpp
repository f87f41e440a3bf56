// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the replicates say about a measure, and how sure that is.
#include <optional>
#include <variant>

#include "campaign/measure.hpp"
#include "stats/sample.hpp"
#include "stats/share.hpp"

namespace eyrie::campaign {

struct Estimate {
  std::uint64_t n = 0;                        ///< replicates to which it applies
  std::optional<double> value{};              ///< nothing of none, and of a ratio to 0
  std::optional<stats::Interval> interval{};  ///< nothing if it has no bounds
};

/// Takes the replicates of a cell one by one. The same ones in the same order give the same bits.
class Estimator {
 public:
  explicit Estimator(const Measure& measure);
  /// The values of a replicate by column; those of one that has none are left out.
  void add(std::span<const double> values);
  /// Shares have Wilson's interval, means Student's, ratios Fieller's.
  [[nodiscard]] Estimate estimate(double confidence = 0.95) const;

 private:
  std::size_t column_, per_;
  std::variant<stats::Share, stats::Moments, stats::Ratio> sum_;
};

}  // namespace eyrie::campaign
